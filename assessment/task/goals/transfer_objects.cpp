// SPDX-License-Identifier: Apache-2.0
// transfer_objects: one hand lifts a ring, both hold it in the air, the other puts it around a peg on its own
// side of the tray.
#include <algorithm>
#include <cmath>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

constexpr double at_rest_s = 0.3;        // of a ring that lies still around its peg
constexpr double rest_speed = 0.02;      // m/s
constexpr double lying_height = 0.0025;  // m, of a ring's lowest point: lower, it lies on the tray

/// How far a ring has come. `passed`: the other hand alone has it, or let it go and it has not come to lie.
enum class Stage : std::uint8_t { begin, lifted, shared, passed, placed };

class TransferTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& step, GoalEvents& events) noexcept override {
        const ObjectsView& view = step.world.objects;
        const std::size_t count = std::min(view.objects.size(), rings_.size());
        bool taken[2 * ObjectsSpec::most] = {};
        for (std::size_t i = 0; i < count; ++i) follow(i, step);
        int placed = 0;
        placed_rings_ = 0;
        shared_ = false;
        for (std::size_t i = 0; i < count; ++i) {
            const Ring& ring = rings_[i];
            shared_ = shared_ || ring.stage == Stage::shared;
            if (ring.stage != Stage::placed) continue;
            bool& peg = taken[static_cast<std::size_t>(view.objects[i].peg)];
            if (peg) continue;  // one ring around each peg
            peg = true;
            ++placed;
            placed_rings_ |= std::uint32_t{1} << i;
        }
        placed_ = placed;
        if (placed > most_) events.progress(most_ = placed);
        return placed >= goal_.count;
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = static_cast<double>(placed_) / goal_.count;
        display.rings_placed = placed_rings_;
        display.hold_progress = shared_ ? held_share_ : 0;
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(rings_, placed_, most_, placed_rings_, shared_, held_share_);
    }

  private:
    struct Ring {
        Stage stage = Stage::begin;
        double time_s = 0;  ///< held by both, or at rest
    };

    bool holds(const WorldSnapshot& world, Hand hand, std::size_t ring) const noexcept {
        const GraspState& grasp = world.grasps[static_cast<std::size_t>(hand)];
        return grasp.held && grasp.body == HeldBody::object && grasp.patch == static_cast<std::int32_t>(ring);
    }

    void follow(std::size_t i, const GoalStep& step) noexcept {
        Ring& ring = rings_[i];
        const ObjectView& seen = step.world.objects.objects[i];
        const Hand other = goal_.hand == Hand::left ? Hand::right : Hand::left;
        const bool giver = holds(step.world, goal_.hand, i), taker = holds(step.world, other, i);
        const bool in_air = seen.height >= goal_.height_m;
        const double passed_s = step.ticks * watch_.tick_period;
        switch (ring.stage) {
            case Stage::begin:
                if (giver && !taker && in_air) ring = {Stage::lifted, 0};
                break;
            case Stage::lifted:
                if (!giver || !in_air) {
                    ring = {};
                } else if (taker) {
                    ring = {Stage::shared, 0};
                }
                break;
            case Stage::shared:
                ring.time_s += passed_s;
                held_share_ = std::min(1.0, ring.time_s / goal_.hold_s);
                if (!in_air || !taker) {
                    ring = giver && in_air ? Ring{Stage::lifted, 0} : Ring{};
                } else if (!giver) {
                    ring = ring.time_s >= goal_.hold_s ? Ring{Stage::passed, 0} : Ring{};
                }
                break;
            case Stage::passed:
            case Stage::placed:
                follow_passed(ring, seen, step.world.objects, giver, taker, passed_s);
                break;
        }
    }

    void follow_passed(Ring& ring, const ObjectView& seen, const ObjectsView& view, bool giver, bool taker,
                       double passed_s) const noexcept {
        const bool around_peg = seen.peg >= 0 && static_cast<std::size_t>(seen.peg) < view.pegs.size() &&
                                view.pegs[static_cast<std::size_t>(seen.peg)].side != goal_.hand;
        const bool still = !giver && !taker && seen.velocity.norm() < rest_speed;
        ring.time_s = still ? ring.time_s + passed_s : 0;
        if (giver) {
            ring = {};
        } else if (ring.stage == Stage::placed) {
            if (!around_peg) ring = {};  // taken off or knocked off: the ring has to be handed over again
        } else if (ring.time_s >= at_rest_s) {
            if (around_peg) {
                ring.stage = Stage::placed;
            } else if (seen.height < lying_height) {
                ring = {};
            }
        }
    }

    std::array<Ring, ObjectsSpec::most> rings_;
    int placed_ = 0, most_ = 0;
    std::uint32_t placed_rings_ = 0;
    bool shared_ = false;
    double held_share_ = 0;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_transfer(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<TransferTracker>(goal, watch);
}

std::optional<GoalFault> check_transfer(const Goal& goal) {
    if (goal.height_m < 0.005)
        return GoalFault{"height_m",
                         QT_TRANSLATE_NOOP("errors", "a ring at this height still touches the tray"),
                         QT_TRANSLATE_NOOP(
                             "errors", "give at least 0.005, the height from which a fall counts as a drop")};
    return std::nullopt;
}

std::optional<GoalFault> objects_suit(const Goal& goal, const Scene& scene) {
    if (goal.count > scene.objects->count)
        return GoalFault{
            "count", QT_TRANSLATE_NOOP("errors", "the goal asks for more rings than the scene has"),
            QT_TRANSLATE_NOOP("errors", "lower \"count\" or raise \"count\" of the scene's objects")};
    for (const Hand hand : {Hand::left, Hand::right}) {
        const InstrumentSpec* instrument = scene.instrument(hand);
        if (instrument == nullptr || !type_of(instrument->kind).grasps)
            return GoalFault{
                "",
                {QT_TRANSLATE_NOOP("errors", "the %1 hand cannot grasp a ring"), hand_name(hand)},
                QT_TRANSLATE_NOOP("errors", "give both hands of the scene a grasper")};
    }
    return std::nullopt;
}

}  // namespace goals
}  // namespace fulcrum
