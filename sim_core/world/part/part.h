// SPDX-License-Identifier: Apache-2.0
// A part of the world: bowel, sheet, bands, structures, targets, wall. The world is a list of parts and names
// none of them; registry.cpp has one line for each.
//
// A part has model (constant after construction; any thread may read it), state (what changes from step to
// step: exactly what list_state() lists) and scratch (means nothing between steps).
//
// A step is the same stages for all parts:
//   begin    forget the events of the step before
//   offer    which tissue could the jaws of a hand take, and how far is it; the world then decides, nearest
//            first
//   apply    holds, loads, blades of the hands
//   solve    where the tissue is at the step's end. A part that hangs on another (Coupling) is solved first.
//   publish  local models for the haptic tick, the part's view in the snapshot
//
// World thread. After construction nothing allocates, locks or throws, but for save and restore.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/collision/cavity.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/tick_output.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/heated_sheet.h"
#include "sim_core/world/part/snapshot.h"
#include "sim_core/world/part/state_list.h"

namespace fulcrum {

class Part;

/// What one part costs: `fulcrum lab cost`.
struct PartCost {
    std::string part;
    double us_per_step = 0;  ///< of the last step, measured only after measure(true)
    std::size_t bytes = 0;
};

/// What a hand holds now.
struct HeldTool {
    const InstrumentSpec* instrument = nullptr;  ///< with the kind that the hand has now; null: no such hand
    ToolKinematics tool;     ///< primary button as a blade; outside while instruments are exchanged
    bool energised = false;  ///< the blade is under power
};

/// What the hands do in one step.
struct StepInput {
    const TickOutput* outputs = nullptr;  ///< of the step's ticks, oldest first
    std::size_t count = 0;                ///< at least one
    double dt = 0;                        ///< s
    const LocalModels* models = nullptr;  ///< that the step before published
    HeldTool held[hand_count];
    const Part* holder[hand_count] = {};  ///< whose tissue the jaws hold at the step's begin; null: none
    const Part* taker[hand_count] = {};   ///< whose tissue closing jaws take; null: none

    const TickOutput& last() const { return outputs[count - 1]; }
    std::uint32_t tick() const { return last().sample.tick; }
    /// Whether a hand's jaws hold tissue of another part.
    bool busy(int hand, const Part* part) const { return holder[hand] != nullptr && holder[hand] != part; }
};

class Part {
  public:
    static constexpr double no_offer = std::numeric_limits<double>::infinity();

    Part() = default;
    virtual ~Part() = default;

    virtual void begin_step() noexcept {}
    /// Replaces what a hand holds, where its instruments are exchanged in the field. Called once a step and
    /// hand, before any offer.
    virtual void exchange(int /*hand*/, const StepInput& /*input*/, HeldTool& /*held*/) noexcept {}
    /// m, from the jaws of a hand that close in this step to the nearest tissue that they can take.
    virtual double offer(int /*hand*/, const HeldTool& /*held*/) const noexcept { return no_offer; }
    /// Whether a hand's jaws hold its tissue.
    virtual bool holds(int /*hand*/) const noexcept { return false; }
    /// What they hold, while they do.
    virtual GraspState grasp(int /*hand*/) const noexcept { return {}; }
    /// Whether the last hold ended because the tissue left the jaws, not because they opened.
    virtual bool slipped(int /*hand*/) const noexcept { return false; }
    virtual void apply(const StepInput& /*input*/) noexcept {}
    /// Returns StepRecord::outcome.
    virtual std::uint32_t solve(const StepInput& /*input*/) noexcept { return 0; }
    /// The part's share of a hand's local model: it writes only what is its own.
    virtual void publish_model(int /*hand*/, const TickOutput& /*last*/, LocalModel& /*model*/) noexcept {}
    virtual void size_snapshot(WorldSnapshot& /*snapshot*/) const {}
    virtual void fill_snapshot(WorldSnapshot& /*snapshot*/) const noexcept {}
    /// Reduces a touch of this part to the depth that shows, where the part is drawn deeper than it is felt.
    virtual void show_touch(Touch& /*touch*/) const noexcept {}
    /// Surface that instruments feel as a wall, if the part is one.
    virtual const CavityModel* wall() const noexcept { return nullptr; }
    /// Layers that local models point to, if the part has them.
    virtual const LayeredWall* layered_wall() const noexcept { return nullptr; }
    /// Sheet that instruments give energy to, if the part is one.
    virtual const HeatedSheet* heated_sheet() const noexcept { return nullptr; }

    /// Every state member, once.
    virtual void list_state(StateList& /*list*/) {}
    /// After a restore: brings scratch to the restored state.
    virtual void follow_restore() {}

    virtual void measure(bool /*on*/) {}
    /// us: wall time of the part's apply and solve in the last step.
    virtual void add_costs(double us, std::vector<PartCost>& costs) const = 0;

    void hash(StateHash& hash) const noexcept {
        StateList list(hash);
        const_cast<Part*>(this)->list_state(list);  // a hash reads only
    }
    StateList::Values save() const {
        StateList::Values values;
        StateList list(values);
        const_cast<Part*>(this)->list_state(list);  // a save reads only
        return values;
    }
    /// State of a part made from the same scene and seed: it resumes from there bit for bit.
    void restore(const StateList::Values& values) {
        StateList list(values);
        list_state(list);
        follow_restore();
    }
    /// Writes the state, or reads that of a part made from the same scene and seed. Throws StateArchiveError.
    void transfer(StateArchive& archive) {
        StateList list(archive);
        list_state(list);
        if (archive.reads()) follow_restore();
    }
    /// Memory that state members own.
    std::size_t state_bytes() const {
        std::size_t bytes = 0;
        StateList list(bytes);
        const_cast<Part*>(this)->list_state(list);  // sizes are read only
        return bytes;
    }

  protected:
    Part(const Part&) = default;
    Part& operator=(const Part&) = default;
};

/// A part that hangs on another. Both ends are named; the carried part is solved first, its pull acts on the
/// carrier in the carrier's same step, equal and opposite.
class Coupling {
  public:
    virtual ~Coupling() = default;
    virtual const Part& carried() const = 0;
    virtual const Part& carrier() const = 0;
    /// Before the carried part is solved: its edge goes to where the carrier is about to be.
    virtual void carry(double dt) noexcept = 0;
    /// After it is solved, before the carrier is.
    virtual void pull() noexcept = 0;
    /// After the step of all parts.
    virtual void follow() noexcept {}
    /// At construction: both to rest together.
    virtual void settle(double dt) = 0;
};

using PartList = std::vector<std::unique_ptr<Part>>;

/// The wall that instruments feel; null without.
inline const CavityModel* wall_of(const PartList& parts) noexcept {
    const CavityModel* wall = nullptr;
    for (const std::unique_ptr<Part>& part : parts) {
        if (part->wall() != nullptr) wall = part->wall();
    }
    return wall;
}

/// The sheet that instruments give energy to; null without.
inline const HeatedSheet* heated_sheet_of(const PartList& parts) noexcept {
    for (const std::unique_ptr<Part>& part : parts) {
        if (part->heated_sheet() != nullptr) return part->heated_sheet();
    }
    return nullptr;
}

/// The part of a type; null where the scene does not list it.
template <typename Kind>
Kind* find_part(const PartList& parts) noexcept {
    for (const std::unique_ptr<Part>& part : parts) {
        if (auto* found = dynamic_cast<Kind*>(part.get())) return found;
    }
    return nullptr;
}

}  // namespace fulcrum
