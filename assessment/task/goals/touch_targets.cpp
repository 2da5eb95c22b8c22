// SPDX-License-Identifier: Apache-2.0
// touch_targets: each sphere of one hand is touched and held, in order.
#include <algorithm>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

constexpr double touch_tolerance =
    0.001;  // m, beyond contact, so that a light touch's own tremor does not end a hold

class TargetTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    void begin(const WorldSnapshot& world, GoalEvents& events) noexcept override {
        show_target(world, events);
    }

    bool tick(const TickSample& sample, const WorldSnapshot& world, GoalEvents& events) noexcept override {
        if (target_ < 0) return false;
        const auto hand_index = static_cast<std::size_t>(goal_.hand);
        const HandSample& hand = sample.hand[hand_index];
        const TargetSphere& target = world.targets[static_cast<std::size_t>(target_)];
        const Vector3 tip = sample_length_unit * Vector3(hand.tip[0], hand.tip[1], hand.tip[2]);
        const double reach = target.radius + watch_.tip_radius[hand_index] + touch_tolerance;
        const bool touching = (hand.flags & hand_inside) != 0 && (tip - target.centre).norm() <= reach;
        if (!hold(touching, 1)) return false;
        events.target(EventKind::target_reached, goal_.hand, target_);
        events.progress(++reached_);
        if (reached_ >= goal_.count) return true;
        show_target(world, events);
        return false;
    }

    bool at_target(Hand hand) const noexcept override { return hold_ticks_ > 0 && goal_.hand == hand; }

    void show(TaskDisplay& display) const noexcept override {
        display.active_target = target_;
        display.goal_progress = static_cast<double>(reached_) / goal_.count;
        display.hold_progress = held_share();
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(reached_, target_);
    }

  private:
    void show_target(const WorldSnapshot& world, GoalEvents& events) noexcept {
        hold_ticks_ = 0;
        target_ = -1;
        int of_hand = 0;
        for (std::size_t i = 0; i < world.targets.size(); ++i) {
            if (world.targets[i].hand != goal_.hand) continue;
            if (of_hand++ != reached_) continue;
            target_ = static_cast<std::int32_t>(i);
            events.target(EventKind::target_shown, goal_.hand, target_);
            return;
        }
    }

    int reached_ = 0, target_ = -1;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_targets(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<TargetTracker>(goal, watch);
}

std::optional<GoalFault> targets_suit(const Goal& goal, const Scene& scene) {
    if (scene.instrument(goal.hand) == nullptr)
        return GoalFault{
            "hand",
            {QT_TRANSLATE_NOOP("errors", "the scene gives the %1 hand no instrument"), hand_name(goal.hand)},
            QT_TRANSLATE_NOOP("errors", "add one to the scene")};
    if (goal.count > scene.targets->per_hand)
        return GoalFault{
            "count",
            QT_TRANSLATE_NOOP("errors", "the goal asks for more targets than the scene has for a hand"),
            QT_TRANSLATE_NOOP("errors", "lower \"count\" or raise \"per_hand\" of the scene")};
    return std::nullopt;
}

}  // namespace goals
}  // namespace fulcrum
