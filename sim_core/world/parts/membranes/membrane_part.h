// SPDX-License-Identifier: Apache-2.0
// A membrane between the bowel's wall and the wall of the cavity as a part of the world (docs/THEORY.md 3).
// World thread. Nothing allocates after construction.
//
// Two-way with the rod: one edge of the sheet hangs on wall points r(s) + R(s) X of the rod, as tethers do.
// Each step the membrane is stepped first, its edge where the wall points are about to be; what holds that
// edge there acts on the rod, equal and opposite, as force and moment of a dead load in the same step. Jaws
// hold a triangle of the sheet by its corners.
#pragma once

#include <array>
#include <vector>

#include "sim_core/membrane/membrane.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/rod/rod.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/state_list.h"

namespace fulcrum {

/// What a pair of jaws holds of a sheet.
struct SheetGrip {
    bool held = false;
    std::int32_t triangle = -1;
    Vector3 point = Vector3::Zero();     ///< m, of the sheet, in the jaws
    Vector3 reaction = Vector3::Zero();  ///< N, jaws on sheet
};

/// A sheet at rest and how it is held.
struct MembraneSheet {
    TriangleMesh mesh;                         ///< in situ, patient frame
    std::vector<std::int32_t> bowel_vertices;  ///< on the bowel's wall
    std::vector<double> bowel_arc_lengths;     ///< m along the rod, one each
    std::vector<std::int32_t> wall_vertices;   ///< on the wall of the cavity: they stay
};

class MembranePart {
  public:
    /// rest: the rod in the shape that the sheet was made for. Throws InputError (place "/membranes/index")
    /// where the sheet is too stiff for the rod's mass at this step: the two are solved in turn.
    MembranePart(const Scene& scene, std::size_t index, const MembraneSheet& sheet, const Rod& rod,
                 const RodState& rest, double dt);

    /// One step of dt with the rod's wall points carried on by their velocities; appends what pulls on the
    /// rod to `loads` (up to its capacity: attachments() more). Returns StepRecord::outcome.
    std::uint32_t step(const Rod& rod, const RodState& state, double dt,
                       std::vector<RodLoad>& loads) noexcept;
    /// The triangle nearest to a point that jaws can take: within the root of `least`, m2 (lowered to what
    /// was found), and with a free corner. -1: none.
    std::int32_t nearest_triangle(const Vector3& point, double& least, Vector3& closest) const noexcept;
    /// A hand's jaws close on a triangle at a point of it: its corners hang on the jaws by springs, together
    /// `stiffness` N/m.
    void take(int hand, std::int32_t triangle, const Vector3& point, double stiffness) noexcept;
    /// Where that point shall be at the end of the next step.
    void carry(int hand, const Vector3& target) noexcept;
    void let_go(int hand) noexcept;
    const SheetGrip& grip(int hand) const { return holds_[hand].grip; }
    /// N/m: the springs at the held corners, which is the most that the sheet can answer with, behind the
    /// jaws' own.
    double grip_stiffness(int hand) const noexcept;

    /// Takes the last step back, at rest: when the rod's was.
    void take_back() noexcept;
    /// Turns every velocity off.
    void stop() noexcept;

    std::size_t attachments() const { return arc_lengths_.size(); }
    const Membrane& membrane() const { return membrane_; }
    const MembraneState& state() const { return state_; }
    const MembraneInputs& inputs() const { return inputs_; }
    const MembraneReport& report() const { return report_; }
    /// N, sum of what pulled on the rod in the last step.
    const Vector3& pull() const { return pull_; }
    /// Stiffness that a moved edge meets within one step over the rod's inertia (1 would be the limit).
    double coupling() const { return coupling_; }

    void size_snapshot(MembraneView& view) const;
    void fill_snapshot(MembraneView& view) const noexcept;
    void list_state(StateList& list);
    std::size_t bytes() const;

  private:
    struct Hold {
        SheetGrip grip;
        std::array<Vector3, 3> offsets;  ///< m, of the corners from the held point when the jaws closed
        Vector3 target = Vector3::Zero();
        double stiffness = 0;
    };
    void fill_holds() noexcept;
    void read_holds() noexcept;
    void check_coupling(const Scene& scene, std::size_t index, const Rod& rod, double dt);

    Membrane membrane_;
    MembraneState state_, good_;
    MembraneInputs inputs_;
    MembraneScratch scratch_;
    MembraneSolve solve_;
    MembraneReport report_;
    std::vector<double> arc_lengths_;
    std::vector<Vector3> offsets_;  ///< ring frame
    Hold holds_[hand_count];
    Vector3 pull_ = Vector3::Zero();
    double coupling_ = 0;
};

}  // namespace fulcrum
