// SPDX-License-Identifier: Apache-2.0
// Membranes hang on the bowel, two-way: one edge of each is on wall points r(s) + R(s) X of the rod, as
// tethers are. Before each step that edge is carried to where the points are about to be; what holds it there
// acts on the rod, equal and opposite, as force and moment of a dead load in the rod's same step.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/rod/rod.h"
#include "sim_core/world/part/part.h"

namespace fulcrum {

class BowelPart;
class MembranePart;
class MembranesPart;
struct MembraneSheet;

/// The edge of one membrane on a rod.
class MembraneEdge {
  public:
    /// rest: the rod in the shape that the membrane was made for. Throws InputError (place
    /// "/membranes/index") where it is too stiff for the rod's mass at this step: the two are solved in turn.
    MembraneEdge(const Scene& scene, std::size_t index, MembranePart& membrane, const MembraneSheet& sheet,
                 const Rod& rod, const RodState& rest, double dt);

    void carry(const Rod& rod, const RodState& state, double dt) noexcept;
    /// After the membrane's step.
    void sum_pulls(const Rod& rod, const RodState& state) noexcept;
    /// Loads on the rod.
    const std::vector<RodLoad>& pulls() const { return pulls_; }
    /// N, their sum.
    const Vector3& pull() const { return pull_; }
    /// Stiffness that the moved edge meets within one step over the rod's inertia (1 would be the limit).
    double coupling() const { return coupling_; }

  private:
    MembranePart& membrane_;
    std::vector<double> arc_lengths_;
    std::vector<Vector3> offsets_;  ///< ring frame
    std::vector<RodLoad> pulls_;
    Vector3 pull_ = Vector3::Zero();
    double coupling_ = 0;
};

class MembranesOnBowel : public Coupling {
  public:
    MembranesOnBowel(const Scene& scene, MembranesPart& membranes, BowelPart& bowel);
    const Part& carried() const override;
    const Part& carrier() const override;
    void carry(double dt) noexcept override;
    void pull() noexcept override;
    void follow() noexcept override;
    /// From the shape in which both were made to rest.
    void settle(double dt) override;
    const std::vector<MembraneEdge>& edges() const { return edges_; }

  private:
    MembranesPart& membranes_;
    BowelPart& bowel_;
    std::vector<MembraneEdge> edges_;
};

std::unique_ptr<Coupling> build_membranes_on_bowel(const Scene& scene, const PartList& parts);

}  // namespace fulcrum
