// SPDX-License-Identifier: Apache-2.0
// lift_and_hold: a stretch of bowel is lifted above its resting height and held there.
#include <algorithm>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

constexpr int report_every = 5;  // s held between two goal_progress events

class LiftTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& step, GoalEvents& events) noexcept override {
        height_ = 0;
        bool holding = false;
        for (const GraspState& grasp : step.world.grasps) {
            if (!grasp.held || grasp.arc_length < goal_.from_m || grasp.arc_length > goal_.to_m) continue;
            holding = true;
            height_ = std::max(height_, watch_.height(step.world, grasp));
        }
        const int before = whole_seconds();
        const bool met = hold(holding && height_ >= goal_.height_m, step.ticks);
        if (whole_seconds() / report_every > before / report_every) events.progress(whole_seconds());
        return met;
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = display.hold_progress = held_share();
        display.lift_height_m = height_;
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(height_);
    }

  private:
    int whole_seconds() const noexcept { return static_cast<int>(held_s() + 1e-9); }

    double height_ = 0;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_lift(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<LiftTracker>(goal, watch);
}

std::optional<GoalFault> check_stretch(const Goal& goal) {
    if (goal.from_m < goal.to_m) return std::nullopt;
    return GoalFault{"from_m", QT_TRANSLATE_NOOP("errors", "the stretch of bowel has no length"),
                     QT_TRANSLATE_NOOP("errors", "give from_m below to_m")};
}

}  // namespace goals
}  // namespace fulcrum
