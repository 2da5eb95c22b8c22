// SPDX-License-Identifier: Apache-2.0
// run_bowel: the bowel is run hand over hand. Arc lengths are counted in the goal's direction from from_m.
#include <algorithm>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

constexpr double run_tolerance = 0.02;  // m, how far past the frontier a hold may begin without a partner
constexpr double hand_over_slack =
    0.005;  // m, on the shortest and longest step: half a jaw's width is nobody's fault

class RunTracker : public GoalTracker {
  public:
    RunTracker(const Goal& goal, const GoalWatch& watch)
        : GoalTracker(goal, watch), direction_(goal.to_m >= goal.from_m ? 1.0 : -1.0) {}

    bool step(const GoalStep& step, GoalEvents& events) noexcept override {
        for (std::size_t hand = 0; hand < hand_count; ++hand) {
            if (step.changes[hand] != HoldChange::grasped) continue;
            const GraspState& partner = step.world.grasps[1 - hand];
            if (!partner.held || step.changes[1 - hand] == HoldChange::grasped)
                continue;  // a hold without a partner is only a start
            const double place = place_of(step.world.grasps[hand]), partner_place = place_of(partner);
            const double stride = place - partner_place;
            const bool counts = partner_place <= covered_ + run_tolerance &&
                                stride >= goal_.minimum_step_m - hand_over_slack &&
                                stride <= goal_.maximum_step_m + hand_over_slack;
            if (!counts || place <= covered_) continue;
            covered_ = std::min(place, goal_.length_m);
            events.progress(covered_);
        }
        // Where the next grasp belongs: a step beyond the hand that holds, or back at the frontier if none
        // holds where it counts.
        next_ = covered_;
        for (const GraspState& grasp : step.world.grasps) {
            const double place = place_of(grasp);
            if (!grasp.held || place > covered_ + run_tolerance || place + goal_.maximum_step_m < covered_)
                continue;
            const double stride = 0.5 * (goal_.minimum_step_m + goal_.maximum_step_m);
            next_ = std::max(next_, std::min(place + goal_.maximum_step_m,
                                             std::max(place + stride, covered_ + run_tolerance)));
        }
        return covered_ >= goal_.length_m - 1e-9;
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = covered_ / goal_.length_m;
        display.run_covered_m = covered_;
        display.run_next_m = goal_.from_m + direction_ * next_;
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(covered_, next_);
    }

  private:
    double place_of(const GraspState& grasp) const noexcept {
        return direction_ * (grasp.arc_length - goal_.from_m);
    }

    double direction_, covered_ = 0, next_ = 0;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_run(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<RunTracker>(goal, watch);
}

std::optional<GoalFault> check_run(const Goal& goal) {
    if (goal.minimum_step_m >= goal.maximum_step_m)
        return GoalFault{"minimum_step_m",
                         QT_TRANSLATE_NOOP("errors", "minimum_step_m is not below maximum_step_m"),
                         QT_TRANSLATE_NOOP("errors", "give the shortest step first")};
    const double room = goal.to_m > goal.from_m ? goal.to_m - goal.from_m : goal.from_m - goal.to_m;
    if (room + 1e-9 < goal.length_m)
        return GoalFault{"length_m",
                         {QT_TRANSLATE_NOOP("errors", "there are only %1 m between from_m and to_m"),
                          std::to_string(room)},
                         QT_TRANSLATE_NOOP("errors", "ask for less, or move from_m and to_m apart")};
    return std::nullopt;
}

std::optional<GoalFault> on_bowel(const Goal& goal, const Scene& scene) {
    if (std::max(goal.from_m, goal.to_m) <= scene.bowel->length) return std::nullopt;
    return GoalFault{"to_m", QT_TRANSLATE_NOOP("errors", "the goal reaches beyond the bowel's end"),
                     QT_TRANSLATE_NOOP("errors", "keep from_m and to_m below the bowel's length")};
}

}  // namespace goals
}  // namespace fulcrum
