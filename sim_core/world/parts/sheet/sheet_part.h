// SPDX-License-Identifier: Apache-2.0
// A sheet that is held and divided, as a part of the world (docs/THEORY.md 3 to 6; Eqs. 6 and 7).
// World thread. Nothing allocates after construction.
//
// The sheet is one cuttable surface (CutMesh: what is visible, which fragments of each root hang together)
// over one membrane of springs on virtual nodes (CutMembrane: where it is). A visible vertex lies in the
// nodes of its fragment. Each step: tools find their contact, jaws and tips enter the membrane's own solve as
// links, the membrane is stepped, blades advance, and what they cut becomes fragments, nodes and springs
// before the step ends. The hand gets the solution to first order (SheetContactModel) and never waits.
// Blades: blade_law.h; jaws: jaws.h. The sheet itself is SheetBody; tips and jaws, blades and fibres are
// objects that share it.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/world/part/heated_sheet.h"
#include "sim_core/world/part/part.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/parts/sheet/fibre_parting.h"
#include "sim_core/world/parts/sheet/sheet_blades.h"
#include "sim_core/world/parts/sheet/sheet_body.h"
#include "sim_core/world/parts/sheet/sheet_contact.h"

namespace fulcrum {

class SheetPart : public Part, public HeatedSheet {
  public:
    using State = SheetState;

    /// Builds the sheet and lets it come to rest. Throws InputError (place "/sheet" or "/septa").
    SheetPart(const Scene& scene, double dt) : body_(scene, dt) {}

    void begin_step() noexcept override { body_.clear_events(); }
    double offer(int hand, const HeldTool& held) const noexcept override {
        return contact_.offer(hand, held);
    }
    void apply(const StepInput& input) noexcept override;
    std::uint32_t solve(const StepInput& input) noexcept override;
    void publish_model(int hand, const TickOutput& /*last*/, LocalModel& model) noexcept override {
        contact_.publish(hand, model);
    }
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    void list_state(StateList& list) override;
    void follow_restore() override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;
    using Part::restore;

    /// Vertices that something else moves (SheetLayout::driven): target in, reaction out.
    std::vector<DrivenVertex>& edge() { return body_.inputs().driven; }
    /// N, sum of the edge's reactions in a step in which it is moved by a displacement (m) along an axis; -1:
    /// not moved. Changes no state.
    Vector3 trial_edge_force(int axis, double displacement, double dt) {
        return body_.trial_edge_force(axis, displacement, dt);
    }
    /// Turns every velocity off.
    void stop() noexcept;
    /// Jaws that would take hold in this step if something is within their reach.
    bool closing(int hand, const SheetAction& action) const noexcept {
        return contact_.closing(hand, action);
    }
    bool holds(int hand) const noexcept override {
        return body_.state().hands[static_cast<std::size_t>(hand)].jaws.held();
    }
    GraspState grasp(int hand) const noexcept override;
    bool slipped(int hand) const noexcept override {
        return body_.state().hands[static_cast<std::size_t>(hand)].jaws.slipped();
    }
    const HeatedSheet* heated_sheet() const noexcept override { return this; }
    const TriangleMesh& mesh() const noexcept override { return body_.surface().mesh(); }
    const std::vector<Vector3>& vertices_now() const noexcept override { return body_.state().positions; }
    bool root_in_fat(std::int32_t root) const override;
    SheetUnder under(int hand) const noexcept override;

    /// First half of a step of dt seconds that ends with this tick: jaws and tips on the sheet.
    void apply(const SheetAction* actions, std::uint32_t tick, double dt) noexcept;
    /// Second half: the membrane, then blades. Returns StepRecord::outcome.
    std::uint32_t solve(const SheetAction* actions, std::uint32_t tick, double dt) noexcept;
    std::uint32_t step(const SheetAction* actions, std::uint32_t tick, double dt) noexcept {
        apply(actions, tick, dt);
        return solve(actions, tick, dt);
    }

    const State& state() const { return body_.state(); }
    const CutMesh& surface() const { return body_.surface(); }
    const CutMembrane& membrane() const { return body_.membrane(); }
    const CutMembraneInputs& inputs() const { return body_.inputs(); }
    const SheetLayout& layout() const { return body_.layout(); }
    /// State and surface of a part made for the same scene.
    void restore(const State& state, const CutState& surface);
    const Event* events() const { return body_.events().data(); }
    int event_count() const { return body_.events().count(); }
    std::size_t bytes() const;
    Vector3 place(const SheetPlace& at) const noexcept { return body_.place(at); }  ///< m
    /// m, in the sheet's frame as SheetView::rest.
    Vector3 rest(const SheetPlace& at) const noexcept { return body_.rest(at); }
    bool in_fat(const Vector3& rest) const noexcept { return body_.in_fat(rest); }

    /// A cut along a blade's step, with all that follows from it; for studies and tests as for the hands.
    CutReport cut(const BladeStep& blade) noexcept { return body_.cut(blade); }

  private:
    SheetBody body_;
    SheetContact contact_{body_};
    FibreParting fibres_{body_};
    SheetBlades blades_{body_, fibres_};
    SheetAction actions_[hand_count];  ///< of the step
};

std::unique_ptr<Part> build_sheet_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
