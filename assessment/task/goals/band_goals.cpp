// SPDX-License-Identifier: Apache-2.0
// divide_bands and stop_bleeding: bands are divided, their vessels controlled.
#include <algorithm>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {
namespace {

class BandTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& /*step*/, GoalEvents& events) noexcept override {
        if (watch_.bands_divided > reported_) events.progress(watch_.bands_divided);
        reported_ = std::max(reported_, watch_.bands_divided);
        return watch_.bands_divided >= goal_.count;
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = std::min(1.0, static_cast<double>(watch_.bands_divided) / goal_.count);
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(reported_);
    }

  private:
    int reported_ = 0;
};

class BleedingTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool step(const GoalStep& step, GoalEvents& events) noexcept override {
        if (watch_.vessels_dry != reported_) events.progress(watch_.vessels_dry);
        reported_ = watch_.vessels_dry;
        return hold(watch_.vessels_dry >= goal_.count, step.ticks);
    }

    void show(TaskDisplay& display) const noexcept override {
        display.goal_progress = std::min(1.0, static_cast<double>(watch_.vessels_dry) / goal_.count);
        display.hold_progress = held_share();
    }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(reported_);
    }

  private:
    int reported_ = 0;
};

std::optional<GoalFault> too_many(bool more) {
    if (!more) return std::nullopt;
    return GoalFault{
        "count", QT_TRANSLATE_NOOP("errors", "the goal asks for more bands or vessels than the scene has"),
        QT_TRANSLATE_NOOP("errors", "lower \"count\" or raise the scene's")};
}

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_bands(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<BandTracker>(goal, watch);
}
std::unique_ptr<GoalTracker> track_bleeding(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<BleedingTracker>(goal, watch);
}
std::optional<GoalFault> enough_bands(const Goal& goal, const Scene& scene) {
    return too_many(goal.count > scene.bands->count);
}
std::optional<GoalFault> enough_vessels(const Goal& goal, const Scene& scene) {
    return too_many(goal.count > scene.bands->vessels);
}

}  // namespace goals
}  // namespace fulcrum
