// SPDX-License-Identifier: Apache-2.0
// Follows one goal from its beginning to its end.
#pragma once

#include <array>
#include <vector>

#include "assessment/task/band_monitor.h"
#include "assessment/task/cut_monitor.h"
#include "assessment/task/hand_monitor.h"
#include "assessment/task/monitor.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum {

/// The data that all goals of an attempt use, updated before a tracker's step.
struct GoalWatch {
    GoalWatch(const TaskDefinition& task, const Scene& scene);

    CutMonitor cut;
    std::vector<double> rest_heights;  ///< m, of each centre-line node before anyone has grasped
    std::array<double, hand_count> tip_radius{};
    double tick_period = 1e-3;  ///< s
    double warning_margin = 0;  ///< as TaskDefinition's
    int bands_divided = 0, vessels_dry = 0;
    int bowel_tissue = -1;  ///< index in the scene, -1 without a bowel

    /// How far a held place is above its resting height, m.
    double height(const WorldSnapshot& world, const GraspState& grasp) const noexcept;

    /// All that changes.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(cut, rest_heights, bands_divided, vessels_dry);
    }
};

/// A goal's own events: stamped with its index.
class GoalEvents {
  public:
    GoalEvents(EventSink& sink, std::uint32_t tick, int goal) : sink_(sink), tick_(tick), goal_(goal) {}
    /// `value` in the goal's measure.
    void progress(double value) noexcept { emit(EventKind::goal_progress, 255, goal_, value); }
    void target(EventKind kind, Hand hand, std::int32_t target) noexcept {
        emit(kind, static_cast<int>(hand), target, 0);
    }
    /// A target of the camera, by no hand.
    void target(EventKind kind, std::int32_t target, double value = 0) noexcept {
        emit(kind, 255, target, value);
    }
    void phase(EventKind kind) noexcept { emit(kind, 255, goal_, 0); }

  private:
    void emit(EventKind kind, int hand, std::int32_t detail, double value) noexcept {
        Event event;
        event.tick = tick_;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.detail = detail;
        event.value = static_cast<float>(value);
        sink_.on_event(event);
    }
    EventSink& sink_;
    std::uint32_t tick_;
    int goal_;
};

/// A step as a tracker sees it. `ticks` have passed since the last one, pauses excluded.
struct GoalStep {
    const WorldSnapshot& world;
    const std::array<HoldChange, hand_count>& changes;
    std::uint32_t ticks;
};

/// Allocates nothing after construction, never throws. step() and tick() return true when the goal is met.
class GoalTracker {
  public:
    GoalTracker(const Goal& goal, const GoalWatch& watch) : goal_(goal), watch_(watch) {}
    GoalTracker(const GoalTracker&) = delete;
    GoalTracker& operator=(const GoalTracker&) = delete;
    virtual ~GoalTracker() = default;

    virtual void begin(const WorldSnapshot& /*world*/, GoalEvents& /*events*/) noexcept {}
    /// One tick, before the step's holds are known.
    virtual bool tick(const TickSample& /*sample*/, const WorldSnapshot& /*world*/,
                      GoalEvents& /*events*/) noexcept {
        return false;
    }
    /// After the world's step.
    virtual bool step(const GoalStep& /*step*/, GoalEvents& /*events*/) noexcept { return false; }
    /// Whether this hand was where the goal requires it in the last tick.
    virtual bool at_target(Hand /*hand*/) const noexcept { return false; }
    virtual void show(TaskDisplay& display) const noexcept = 0;
    /// Writes or reads all that changes; a tracker with members of its own adds them.
    virtual void transfer(StateArchive& archive) { archive(hold_ticks_); }

  protected:
    /// Counts the time that a condition has held without a break.
    bool hold(bool holds, std::uint32_t ticks) noexcept {
        hold_ticks_ = holds ? hold_ticks_ + ticks : 0;
        return held_s() >= goal_.hold_s;
    }
    double held_s() const noexcept { return hold_ticks_ * watch_.tick_period; }
    /// 0 .. 1
    double held_share() const noexcept {
        return goal_.hold_s > 0 ? std::min(1.0, held_s() / goal_.hold_s) : 0.0;
    }

    const Goal& goal_;
    const GoalWatch& watch_;
    std::uint32_t hold_ticks_ = 0;
};

}  // namespace fulcrum
