// SPDX-License-Identifier: Apache-2.0
// A task's goals, one after another, each with its tracker.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "assessment/task/goal_tracker.h"

namespace fulcrum {

/// The goals of one attempt. Allocates nothing after construction, never throws afterwards.
class GoalMonitor {
  public:
    /// Throws InputError where the scene lacks what a goal needs.
    GoalMonitor(const TaskDefinition& task, const Scene& scene);

    /// One tick, before the step's holds are known.
    void tick(const TickSample& sample, const WorldSnapshot& world, EventSink& sink) noexcept;
    /// After the step: what the hands hold. `ticks` have passed since the last call, pauses excluded.
    void step(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
              std::uint32_t tick, std::uint32_t ticks, EventSink& sink) noexcept;
    /// What the world did to tissue in this step, before step().
    void tissue_event(const Event& event) noexcept { watch_->cut.event(event); }
    /// Bands as the monitor counts them, before step().
    void bands(const BandMonitor& bands) noexcept {
        watch_->bands_divided = bands.divided();
        watch_->vessels_dry = bands.dry();
    }
    /// Whether the hand was where the current goal requires it in the last tick.
    bool at_target(Hand hand) const noexcept { return !done() && tracker().at_target(hand); }
    bool done() const noexcept { return goal_ >= static_cast<int>(trackers_.size()); }
    /// Writes the goal part of the display.
    void show(TaskDisplay& display) const noexcept;
    /// How far a held place is above its resting height, m.
    double height(const WorldSnapshot& world, const GraspState& grasp) const noexcept {
        return watch_->height(world, grasp);
    }

    /// The beginning of the goal under way once more; nothing before the first has begun.
    void report_begun(std::uint32_t tick, EventSink& sink) const noexcept {
        if (begun_ && !done()) GoalEvents(sink, tick, goal_).phase(EventKind::phase_begin);
    }
    void transfer(StateArchive& archive) {
        archive(*watch_, goal_, begun_, grasped_ever_);
        for (const std::unique_ptr<GoalTracker>& tracker : trackers_) tracker->transfer(archive);
    }

  private:
    void begin_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void end_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    GoalTracker& tracker() const noexcept { return *trackers_[static_cast<std::size_t>(goal_)]; }

    std::vector<Goal> goals_;
    std::unique_ptr<GoalWatch> watch_;  ///< trackers refer to it
    std::vector<std::unique_ptr<GoalTracker>> trackers_;
    int goal_ = 0;
    bool begun_ = false, grasped_ever_ = false;
};

}  // namespace fulcrum
