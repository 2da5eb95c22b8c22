// SPDX-License-Identifier: Apache-2.0
// Detects events, progress and the end of an attempt while it runs. Runs after every world step on the same
// thread; allocates nothing after construction. Its result depends on its arguments only, so a replay gives
// the same events.
#pragma once

#include <memory>

#include "assessment/task/task.h"
#include "sim_core/instrument/framing.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

/// Where a monitor's events go; capacity fixed, overflow counted.
class EventSink {
  public:
    virtual ~EventSink() = default;
    virtual void on_event(const Event& event) noexcept = 0;
};

/// What keeps a target from being framed: bits of TaskDisplay::framing_faults.
inline constexpr std::uint8_t framing_hidden = 1;  ///< the cup hides the target
inline constexpr std::uint8_t framing_off_centre = 2;
inline constexpr std::uint8_t framing_too_far = 4;
inline constexpr std::uint8_t framing_too_near = 8;
inline constexpr std::uint8_t framing_tilted = 16;  ///< the horizon is not level

/// The state of the task for the HUD and the operators. Plain data, copied with the snapshot.
struct TaskDisplay {
    std::int32_t goal = 0;            ///< index of the current goal
    std::int32_t active_target = -1;  ///< index into WorldSnapshot::targets to touch now
    double goal_progress = 0;         ///< 0..1
    double hold_progress = 0;         ///< 0..1 of the current hold
    double elapsed_s = 0;  ///< attempt clock, pauses excluded, from the first movement or work on tissue
    double remaining_s = 0;
    double run_covered_m = 0;          ///< run_bowel: arc length covered so far
    double run_next_m = 0;             ///< run_bowel: arc length where the next grasp should be
    double lift_height_m = 0;          ///< lift_and_hold: height above rest now
    double cut_divided_m = 0;          ///< divide_line: length of the marked line divided with a blade so far
    double cut_torn_m = 0;             ///< divide_line: length torn, which never counts as divided
    double cut_next_m = 0;             ///< divide_line: first place along it that is neither
    double cut_distance_m = 0;         ///< signed distance of the last cut from the line
    double traction_n_m = 0;           ///< across the line, at the blade or where it is to be cut next
    std::int8_t traction_warning = 0;  ///< -1 too slack, 1 too tight, beyond the warning margin
    bool distance_warning = false;     ///< the blade cuts too far from the line
    bool cutting = false;              ///< a blade is in the tissue
    std::int32_t bands_divided = 0;    ///< divide_bands: so far, with an instrument
    std::int32_t bands_torn = 0;       ///< divide_bands: torn, which the goal never counts
    std::uint32_t rings_placed =
        0;            ///< transfer_objects: bit i, ring i was handed over and lies around its peg
    Framing framing;  ///< frame_targets, follow_tip: how the target lies in the image
    std::uint8_t framing_faults = 0;  ///< framing_hidden and the like: what keeps it from being framed
    std::int32_t vessels_dry = 0;     ///< stop_bleeding: open and not bleeding
    float blood_ml = 0;               ///< lost so far
    std::int32_t clips_left = 0;
    float force[hand_count] = {0, 0};        ///< N, this step's largest
    float force_limit[hand_count] = {0, 0};  ///< N, of the tissue in contact or grasped; 0 none
    bool warning[hand_count] = {false, false};
    bool moving_seen = false;  ///< first movement or work on tissue happened: an assessed attempt counts
    bool ended = false;
    EventKind end = EventKind::attempt_begin;  ///< completed, timed_out, abandoned or interrupted once ended
    bool critical = false;                     ///< a critical error happened
};

/// One attempt's monitor.
class StateArchive;

class TaskMonitor {
  public:
    TaskMonitor(const TaskDefinition& task, const Scene& scene, std::uint64_t seed);
    ~TaskMonitor();
    /// The ticks since the last call, in order, and the world after the step that consumed them. Events go to
    /// the sink.
    void on_step(const TickSample* ticks, std::size_t count, const WorldSnapshot& world,
                 EventSink& sink) noexcept;
    const TaskDisplay& display() const noexcept;
    /// Writes or reads all that changes from step to step. Throws StateArchiveError.
    void transfer(StateArchive& archive);
    /// A new attempt continues this one: it begins with the next step, with the goal under way, and its clock
    /// starts from 0 with the first movement.
    void begin_again() noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fulcrum
