// SPDX-License-Identifier: Apache-2.0
// One attempt's objects and the order in which they run: the haptic loop, the world, the monitor. There is
// one engine; without a window it is stepped in one thread, with a window its two halves run on two threads
// (app/performance), and a replay steps it by the record.
//
// Order, for m ticks a step: step j consumes the input ticks up to j*m and is due at tick (j+1)*m; its model
// and snapshot are adopted at the next tick that follows a multiple of m. A late step is adopted later; the
// record names the model of every tick.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "assessment/operators/operator.h"
#include "assessment/task/monitor.h"
#include "assessment/task/task.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/record_ticks.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/sample.h"
#include "sim_core/world/world.h"

namespace fulcrum {

class StateArchive;

/// Receives an attempt's record. Called on the haptic side (on_tick) and the world side (on_event,
/// on_step); without a window both are one thread.
class AttemptSink : public EventSink {
  public:
    virtual void on_tick(const RigSample& input, const TickSample& sample) noexcept = 0;
    virtual void on_step(const StepRecord& step) noexcept = 0;
};

/// Output of a step for the other side: the model for the tick, the snapshot for the viewport, the task for
/// the HUD.
struct StepProducts {
    const LocalModels* models = nullptr;
    const WorldSnapshot* snapshot = nullptr;
    const TaskDisplay* display = nullptr;
};

/// What the devices of a rig can render.
ForceDevices devices_of(const Rig& rig);

class AttemptEngine {
  public:
    /// Builds the scene's parts. Throws InputError if scene and task do not fit together. The seed selects
    /// the variant.
    AttemptEngine(const Scene& scene, const TaskDefinition& task, std::uint64_t seed);
    ~AttemptEngine();
    AttemptEngine(const AttemptEngine&) = delete;
    AttemptEngine& operator=(const AttemptEngine&) = delete;

    const Scene& scene() const noexcept;
    const TaskDefinition& task() const noexcept;
    std::uint64_t seed() const noexcept;
    World& world() noexcept;
    HapticLoop& loop() noexcept;
    /// Before the first tick: what the rig's devices can render. Without it no force is sent.
    void use_devices(const ForceDevices& devices);
    /// The snapshot before the first tick, or that of the state that the attempt began with.
    const WorldSnapshot& initial_snapshot() const noexcept;

    /// Haptic side: one tick with the model adopted last.
    const TickOutput& tick(const RigSample& input) noexcept;
    /// Haptic side: adopt a step's model (copied).
    void adopt(const LocalModels& models) noexcept;
    /// World side: one step over the outputs of `count` ticks, then the monitor. Products stay valid until
    /// the next step.
    StepProducts step(const TickOutput* outputs, std::size_t count, AttemptSink& sink) noexcept;
    /// True once the monitor has ended the attempt.
    bool ended() const noexcept;
    const TaskDisplay& display() const noexcept;
    /// Hash over all steps so far.
    std::uint64_t state_hash() const noexcept;
    /// The tick that comes next: 1 at the beginning.
    std::uint32_t next_tick() const noexcept;

    /// Writes all that changes while an attempt runs, or reads it into an engine of the same scene, task and
    /// seed in the same build, which then continues bit for bit. Throws StateArchiveError: the engine's state
    /// then means nothing. Not for the real-time path.
    void transfer(StateArchive& archive);
    /// A new attempt begins with this state: the newest model is adopted, the clock starts again with the
    /// whole time limit, the devices move the instruments from where these are. Between two ticks, with every
    /// tick stepped.
    void begin_here() noexcept;
    /// After transfer() has read: initial_snapshot() is that of the state read.
    void show_restored() noexcept;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The targets that the metrics of a task need, where an attempt with this seed has them; none where the
/// scene has none.
std::vector<TargetSphere> targets_of(const Scene& scene, const TaskDefinition& task, std::uint64_t seed);

/// Hands a tick's forces to the rig. Haptic thread.
void write_forces(Rig& rig, const TickOutput& output);

struct RunOutcome {
    EventKind end = EventKind::interrupted;
    std::uint32_t ticks = 0;
    std::uint64_t state_hash = 0;
    bool cancelled = false;
};

/// Runs an attempt to its end in this thread, as fast as possible. `keep_going` is called about once per
/// simulated second with the simulated time; returning false interrupts the attempt. `after_step` is called
/// after every world step, then `stop`: true ends the run there. A rig that is also an ObservingRig is shown
/// the world.
RunOutcome run_headless(AttemptEngine& engine, Rig& rig, AttemptSink& sink,
                        const std::function<bool(double)>& keep_going = {},
                        const std::function<void()>& after_step = {}, const std::function<bool()>& stop = {});

/// An operator performs without a record until a goal (index) has begun and the last step has used every
/// tick. `keep_going` is asked before every step; false where it said so. Throws InputError where the attempt
/// ends before.
bool perform_to_goal(AttemptEngine& engine, Rig& rig, int goal, const std::function<bool()>& keep_going);

/// The record of an attempt as a replay needs it. One that began with the state of another attempt has as its
/// first tick the one after that state's.
struct AttemptRecord {
    std::vector<RigSample> inputs;
    std::vector<TickSample> samples;
    std::vector<StepRecord> steps;
    std::vector<Event> events;
    ForceDevices devices;                           ///< that the attempt was performed with
    std::shared_ptr<const RecordTicks> ticks = {};  ///< in place of inputs and samples, which are empty then
};

struct ReplayOutcome {
    bool identical = true;
    double first_divergence_s = -1;  ///< -1: none
    std::uint64_t state_hash = 0;
    std::vector<Event> events;        ///< as re-simulated
    std::vector<TickSample> samples;  ///< as re-simulated, on request
};

/// Runs a new engine over a record, following its schedule, and compares every sample and every step's hash
/// with it, except the force sent to a hand whose device renders none. `after_step` gets the world after
/// every step; returning false stops.
ReplayOutcome replay_record(AttemptEngine& engine, const AttemptRecord& record, bool keep_samples = false,
                            const std::function<bool(const WorldSnapshot&)>& after_step = {});

}  // namespace fulcrum
