// SPDX-License-Identifier: Apache-2.0
// Septa hang on the rectum, two-way: before each step their edge is carried to where the rod's wall points
// are about to be; what holds the edge there acts on the rod, equal and opposite, in the rod's same step.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/rod/rod.h"
#include "sim_core/world/part/part.h"

namespace fulcrum {

class BowelPart;
class SheetPart;

/// The edge of septa on a rod.
class SeptaEdge {
  public:
    /// state: the rod in the shape that the septa were made for. Throws InputError where they are too stiff
    /// for its mass.
    SeptaEdge(const Scene& scene, SheetPart& septa, const Rod& rod, const RodState& state, double dt);

    void carry(const Rod& rod, const RodState& state, double dt) noexcept;
    void sum_pulls() noexcept;
    /// Loads on the rod, one for each septum; empty without.
    const std::vector<RodLoad>& pulls() const { return pulls_; }
    /// Stiffness that the moved edge meets within one step over the rod's inertia (1 would be the limit).
    double coupling() const { return coupling_; }

  private:
    SheetPart& septa_;
    std::vector<double> arc_lengths_;  ///< m along the rod, one for each septum
    std::vector<Vector3> offsets_;     ///< of the edge's vertices, ring frame
    std::vector<Vector3> arms_;        ///< m, of the edge's vertices from the rod's centre line
    std::vector<RodLoad> pulls_;
    double coupling_ = 0;
};

class SeptaOnRectum : public Coupling {
  public:
    SeptaOnRectum(const Scene& scene, SheetPart& septa, BowelPart& rectum);
    const Part& carried() const override;
    const Part& carrier() const override;
    void carry(double dt) noexcept override;
    void pull() noexcept override;
    /// From the shape in which the rectum lay without septa to rest.
    void settle(double dt) override;
    const SeptaEdge& edge() const { return edge_; }

  private:
    SheetPart& septa_;
    BowelPart& rectum_;
    SeptaEdge edge_;
};

std::unique_ptr<Coupling> build_septa_on_rectum(const Scene& scene, const PartList& parts);

}  // namespace fulcrum
