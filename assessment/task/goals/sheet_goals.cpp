// SPDX-License-Identifier: Apache-2.0
// take_tension, divide_line and let_go: a sheet or septa are held taut, divided along the marked line, let
// go.
#include <algorithm>
#include <cmath>

#include "assessment/task/goal_tracker.h"
#include "assessment/task/specimen_plan.h"

namespace fulcrum {
namespace {

constexpr double line_end_slack =
    0.002;  // m of the line that may stay: a bridge that the flap's own weight parts

class TensionTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& step, GoalEvents& /*events*/) noexcept override {
        const CutMonitor& cut = watch_.cut;
        const bool holding = step.world.grasps[0].held || step.world.grasps[1].held;
        const bool met = hold(holding && cut.fault(goal_, 0) == TractionFault::none, step.ticks);
        // Where all is divided nothing is left to put under tension.
        return met || (cut.line() && cut.next() + line_end_slack >= cut.length());
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = display.hold_progress = held_share();
    }
};

class LineTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& /*step*/, GoalEvents& events) noexcept override {
        const CutMonitor& cut = watch_.cut;
        const auto millimetres = static_cast<int>(cut.divided() * 1e3 + 1e-9);
        if (millimetres > millimetres_) events.progress(cut.divided());
        millimetres_ = std::max(millimetres, millimetres_);
        return cut.next() + line_end_slack >= goal_.length_m;
    }

    void show(TaskDisplay& display) const noexcept override {
        const CutMonitor& cut = watch_.cut;
        display.goal_progress = std::min(1.0, cut.divided() / goal_.length_m);
        const double margin = watch_.warning_margin;
        if (margin < 0) return;
        // Slack tissue is wrong only while it is cut; too much traction tears whatever the blade does.
        const TractionFault fault = cut.fault(goal_, margin);
        if (fault == TractionFault::tight || cut.cutting())
            display.traction_warning = static_cast<std::int8_t>(fault);
        display.distance_warning =
            cut.cutting() && std::abs(cut.distance()) > goal_.tolerance_m * (1 + margin);
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(millimetres_);
    }

  private:
    int millimetres_ = 0;  // of the line, as last reported
};

class LetGoTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& step, GoalEvents& /*events*/) noexcept override {
        const auto& grasps = step.world.grasps;
        return hold(!grasps[0].held && !grasps[1].held && !watch_.cut.cutting(), step.ticks);
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = display.hold_progress = held_share();
    }
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_tension(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<TensionTracker>(goal, watch);
}
std::unique_ptr<GoalTracker> track_line(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<LineTracker>(goal, watch);
}
std::unique_ptr<GoalTracker> track_let_go(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<LetGoTracker>(goal, watch);
}

std::optional<GoalFault> check_traction(const Goal& goal) {
    if (goal.traction_low_n_m < goal.traction_high_n_m) return std::nullopt;
    return GoalFault{"traction_low_n_m",
                     QT_TRANSLATE_NOOP("errors", "traction_low_n_m is not below traction_high_n_m"),
                     QT_TRANSLATE_NOOP("errors", "give the least traction first")};
}

std::optional<GoalFault> check_line(const Goal& goal) {
    if (goal.tolerance_m > goal.corridor_m)
        return GoalFault{"tolerance_m", QT_TRANSLATE_NOOP("errors", "tolerance_m is above corridor_m"),
                         QT_TRANSLATE_NOOP("errors", "give the smaller distance as tolerance_m")};
    return check_traction(goal);
}

std::optional<GoalFault> line_suits(const Goal& goal, const Scene& scene) {
    if (goal.length_m <= marked_line(scene) + 1e-9) return std::nullopt;
    return GoalFault{"length_m",
                     QT_TRANSLATE_NOOP("errors", "the goal asks for more than the marked line's length"),
                     QT_TRANSLATE_NOOP("errors", "lower \"length_m\" or raise \"line_length\" of the scene")};
}

}  // namespace goals
}  // namespace fulcrum
