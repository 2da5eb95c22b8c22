// SPDX-License-Identifier: Apache-2.0
// Progress towards a task's goals: targets held, bowel run hand over hand, bowel lifted and held,
// a sheet put under tension, divided along its line and let go.
#pragma once

#include <array>
#include <vector>

#include "assessment/task/band_monitor.h"
#include "assessment/task/cut_monitor.h"
#include "assessment/task/hand_monitor.h"
#include "assessment/task/monitor.h"

namespace fulcrum {

/// The goals of one attempt, one after another. Allocates nothing after construction, never throws
/// afterwards.
class GoalMonitor {
  public:
    /// Throws InputError where the scene lacks what a goal needs.
    GoalMonitor(const TaskDefinition& task, const Scene& scene);

    /// One tick, before the step's holds are known: contact with targets.
    void tick(const TickSample& sample, const WorldSnapshot& world, EventSink& sink) noexcept;
    /// After the step: what the hands hold. `ticks` have passed since the last call, pauses excluded.
    void step(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
              std::uint32_t tick, std::uint32_t ticks, EventSink& sink) noexcept;
    /// What the world did to tissue in this step, before step().
    void tissue_event(const Event& event) noexcept { cut_.event(event); }
    /// Bands as the monitor counts them, before step().
    void bands(const BandMonitor& bands) noexcept {
        bands_divided_ = bands.divided();
        vessels_dry_ = bands.dry();
    }
    /// The hand holds the lit target, as of the last tick.
    bool at_target(Hand hand) const noexcept {
        return hold_ticks_ > 0 && !done() && goal().kind == GoalKind::touch_targets && goal().hand == hand;
    }
    bool done() const noexcept { return goal_ >= static_cast<int>(goals_.size()); }
    /// Writes the goal part of the display.
    void show(TaskDisplay& display) const noexcept;
    /// How far a held place is above its resting height, m.
    double height(const WorldSnapshot& world, const GraspState& grasp) const noexcept;

  private:
    void begin_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void end_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void show_target(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void step_run(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
                  std::uint32_t tick, EventSink& sink) noexcept;
    void step_lift(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                   EventSink& sink) noexcept;
    void step_tension(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                      EventSink& sink) noexcept;
    void step_divide(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void step_let_go(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                     EventSink& sink) noexcept;
    void step_bands(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept;
    void step_bleeding(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                       EventSink& sink) noexcept;
    void progress(double value, std::uint32_t tick, EventSink& sink) noexcept;
    const Goal& goal() const noexcept { return goals_[static_cast<std::size_t>(goal_)]; }

    std::vector<Goal> goals_;
    std::vector<double> rest_heights_;  ///< m, of each centre-line node before anyone has grasped
    double tick_period_ = 1e-3;
    std::array<double, hand_count> tip_radius_{};
    int goal_ = 0;
    bool begun_ = false, grasped_ever_ = false;
    // touch_targets
    int reached_ = 0, target_ = -1;
    std::uint32_t hold_ticks_ = 0;
    // run_bowel: arc lengths counted in the goal's direction from from_m
    double covered_ = 0, run_next_ = 0;
    // lift_and_hold
    double lift_height_ = 0;
    // take_tension, divide_line, let_go
    CutMonitor cut_;
    double warning_margin_ = 0;
    // divide_bands, stop_bleeding
    int bands_divided_ = 0, vessels_dry_ = 0, counted_ = 0;
    int millimetres_ = 0;  ///< of the line, as last reported
};

}  // namespace fulcrum
