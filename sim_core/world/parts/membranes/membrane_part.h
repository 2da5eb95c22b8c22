// SPDX-License-Identifier: Apache-2.0
// One membrane between the bowel's wall and the wall of the cavity (docs/THEORY.md 3): its edges are held,
// one of them where something else carries it (couplings/membranes_on_bowel.h). Jaws hold a triangle of it by
// its corners. World thread. Nothing allocates after construction.
#pragma once

#include <array>
#include <vector>

#include "sim_core/contact/jaws.h"
#include "sim_core/membrane/membrane.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/state_list.h"
#include "sim_core/world/parts/membranes/membrane_layout.h"

namespace fulcrum {

/// What a pair of jaws holds of a sheet.
struct SheetGrip {
    bool held = false;
    std::int32_t triangle = -1;
    Vector3 point = Vector3::Zero();     ///< m, of the sheet, in the jaws
    Vector3 reaction = Vector3::Zero();  ///< N, jaws on sheet
};

class MembranePart {
  public:
    MembranePart(const Scene& scene, std::size_t index, const MembraneSheet& sheet, double dt);

    /// Targets of the edge on the bowel, for the next step, and N, what held it there in the last one; the
    /// first attachments() of each.
    std::vector<Vector3>& edge() { return inputs_.attachments; }
    const std::vector<Vector3>& edge_reactions() const { return inputs_.reactions; }
    std::size_t attachments() const { return attachments_; }
    /// N, sum of the edge's reactions in a step in which it is moved by a displacement (m) along an axis; -1:
    /// not moved. Changes no state.
    Vector3 trial_edge_force(int axis, double displacement, double dt);
    /// One step of dt. Returns StepRecord::outcome.
    std::uint32_t step(double dt) noexcept;
    /// The triangle nearest to a point that jaws can take: within the root of `least`, m2 (lowered to what
    /// was found), and with a free corner. -1: none.
    std::int32_t nearest_triangle(const Vector3& point, double& least, Vector3& closest) const noexcept;
    /// m2 of both sides, of the triangles whose middle is between jaws.
    double area_in(const JawBox& box) const noexcept;
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

    const Membrane& membrane() const { return membrane_; }
    const MembraneState& state() const { return state_; }
    const MembraneInputs& inputs() const { return inputs_; }
    const MembraneReport& report() const { return report_; }

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

    Membrane membrane_;
    MembraneState state_, good_;
    MembraneInputs inputs_;
    MembraneScratch scratch_;
    MembraneSolve solve_;
    MembraneReport report_;
    std::size_t attachments_ = 0;
    Hold holds_[hand_count];
};

}  // namespace fulcrum
