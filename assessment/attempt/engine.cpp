// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/engine.h"

#include <algorithm>

#include "assessment/attempt/replay_cursor.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_archive.h"
#include "sim_core/numerics/state_hash.h"

namespace fulcrum {

struct AttemptEngine::Parts {
    Scene scene;
    TaskDefinition task;
    std::uint64_t seed;
    World world;
    HapticLoop loop;
    TaskMonitor monitor;
    WorldSnapshot initial;
    std::vector<TickSample> consumed;  // the step's ticks, for the monitor
    StateHash hash;
    std::uint32_t last_tick = 0;

    Parts(const Scene& scene_in, const TaskDefinition& task_in, std::uint64_t seed_in)
        : scene(scene_in),
          task(task_in),
          seed(seed_in),
          world(scene, seed),
          loop(scene, world),
          monitor(task, scene, seed),
          initial(world.snapshot()) {
        consumed.resize(longest_step_ticks);
    }

    static constexpr std::size_t longest_step_ticks =
        4096;  // a world that is later than this is reported as a fault
};

AttemptEngine::AttemptEngine(const Scene& scene, const TaskDefinition& task, std::uint64_t seed)
    : parts_(std::make_unique<Parts>(scene, task, seed)) {}
AttemptEngine::~AttemptEngine() = default;

const Scene& AttemptEngine::scene() const noexcept {
    return parts_->scene;
}
const TaskDefinition& AttemptEngine::task() const noexcept {
    return parts_->task;
}
std::uint64_t AttemptEngine::seed() const noexcept {
    return parts_->seed;
}
World& AttemptEngine::world() noexcept {
    return parts_->world;
}
HapticLoop& AttemptEngine::loop() noexcept {
    return parts_->loop;
}
const WorldSnapshot& AttemptEngine::initial_snapshot() const noexcept {
    return parts_->initial;
}

void AttemptEngine::use_devices(const ForceDevices& devices) {
    for (std::size_t hand = 0; hand < devices.size(); ++hand)
        parts_->loop.set_device(static_cast<Hand>(hand), devices[hand]);
}

ForceDevices devices_of(const Rig& rig) {
    ForceDevices devices;
    for (std::size_t hand = 0; hand < devices.size(); ++hand)
        devices[hand] = rig.force_output(static_cast<Hand>(hand));
    return devices;
}

std::vector<TargetSphere> targets_of(const Scene& scene, const TaskDefinition& task, std::uint64_t seed) {
    if (!scene.targets && !scene.camera_targets) return {};
    return AttemptEngine(scene, task, seed).initial_snapshot().targets;
}

bool AttemptEngine::ended() const noexcept {
    return parts_->monitor.display().ended;
}
const TaskDisplay& AttemptEngine::display() const noexcept {
    return parts_->monitor.display();
}
std::uint64_t AttemptEngine::state_hash() const noexcept {
    return parts_->hash.value();
}

std::uint32_t AttemptEngine::next_tick() const noexcept {
    return parts_->last_tick + 1;
}

void AttemptEngine::transfer(StateArchive& archive) {
    Parts& parts = *parts_;
    parts.world.transfer(archive);
    parts.loop.transfer(archive, parts.world);
    parts.monitor.transfer(archive);
    archive(parts.hash, parts.last_tick);
}

void AttemptEngine::begin_here() noexcept {
    Parts& parts = *parts_;
    parts.loop.adopt(parts.world.local_models());
    parts.loop.clutch_in();
    parts.monitor.begin_again();
    show_restored();
}

void AttemptEngine::show_restored() noexcept {
    parts_->initial = parts_->world.snapshot();
}

const TickOutput& AttemptEngine::tick(const RigSample& input) noexcept {
    parts_->last_tick = input.tick;
    return parts_->loop.tick(input);
}
void AttemptEngine::adopt(const LocalModels& models) noexcept {
    parts_->loop.adopt(models);
}

namespace {

void report_limits(const TickOutput& output, EventSink& sink) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!output.limited[hand].limited) continue;
        Event event;
        event.tick = output.sample.tick;
        event.kind = EventKind::stability_limited;
        event.hand = static_cast<decltype(event.hand)>(hand);
        event.value = output.limited[hand].stiffness;
        sink.on_event(event);
    }
}

}  // namespace

StepProducts AttemptEngine::step(const TickOutput* outputs, std::size_t count, AttemptSink& sink) noexcept {
    Parts& parts = *parts_;
    count = std::min(count, Parts::longest_step_ticks);
    for (std::size_t i = 0; i < count; ++i) {
        parts.consumed[i] = outputs[i].sample;
        report_limits(outputs[i], sink);
    }
    const StepRecord record = parts.world.step(outputs, count);
    if (record.state_hash != 0) parts.hash.add(record.state_hash);
    sink.on_step(record);
    parts.monitor.on_step(parts.consumed.data(), count, parts.world.snapshot(), sink);
    return {&parts.world.local_models(), &parts.world.snapshot(), &parts.monitor.display()};
}

void write_forces(Rig& rig, const TickOutput& output) {
    for (int hand = 0; hand < hand_count; ++hand) {
        // First: a device's command has both, and is sent with its force.
        rig.write_torque(static_cast<Hand>(hand), output.device_torque[hand]);
        rig.write_force(static_cast<Hand>(hand), output.device_force[hand]);
    }
}

RunOutcome run_headless(AttemptEngine& engine, Rig& rig, AttemptSink& sink,
                        const std::function<bool(double)>& keep_going,
                        const std::function<void()>& after_step, const std::function<bool()>& stop) {
    auto* observer = dynamic_cast<ObservingRig*>(&rig);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine.scene().ticks_per_step);
    const auto ticks_per_question = static_cast<std::uint32_t>(engine.scene().tick_rate);
    std::vector<TickOutput> outputs(ticks_per_step);
    if (observer != nullptr) observer->observe(engine.initial_snapshot(), engine.display());
    engine.use_devices(devices_of(rig));

    RunOutcome outcome;
    bool pending = false;  // a step is done and waits for its tick
    for (std::uint32_t tick = engine.next_tick(); !engine.ended(); ++tick) {
        RigSample input;
        input.tick = tick;
        rig.read(tick, input);
        const TickOutput& output = engine.tick(input);
        write_forces(rig, output);
        outputs[(tick - 1) % ticks_per_step] = output;
        sink.on_tick(output.input, output.sample);
        outcome.ticks = tick;
        if (tick % ticks_per_step == 0) {
            if (pending) {  // step j-1 is due now
                engine.adopt(engine.world().local_models());
                if (observer != nullptr) observer->observe(engine.world().snapshot(), engine.display());
            }
            engine.step(outputs.data(), ticks_per_step, sink);
            pending = true;
            if (after_step) after_step();
            if (stop && stop()) {
                outcome.cancelled = true;
                break;
            }
        }
        if (keep_going && tick % ticks_per_question == 0 &&
            !keep_going(tick * engine.scene().tick_period())) {
            outcome.cancelled = true;
            break;
        }
    }
    if (engine.ended()) outcome.end = engine.display().end;
    outcome.state_hash = engine.state_hash();
    return outcome;
}

namespace {

/// Keeps nothing.
class NoSink : public AttemptSink {
  public:
    void on_event(const Event& /*event*/) noexcept override {}
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& /*step*/) noexcept override {}
};

}  // namespace

bool perform_to_goal(AttemptEngine& engine, Rig& rig, int goal, const std::function<bool()>& keep_going) {
    NoSink sink;
    bool stopped = false;
    const auto past = [&] { return engine.display().goal >= goal; };
    const RunOutcome outcome =
        run_headless(engine, rig, sink, {}, {}, [&] { return past() || (stopped = !keep_going()); });
    if (stopped || (past() && outcome.cancelled)) return !stopped;
    throw InputError(engine.task().id, "/goals/" + std::to_string(goal),
                     QT_TRANSLATE_NOOP("errors", "the expert did not reach this goal"),
                     QT_TRANSLATE_NOOP("errors", "begin at an earlier goal"));
}

ReplayOutcome replay_record(AttemptEngine& engine, const AttemptRecord& record, bool keep_samples,
                            const std::function<bool(const WorldSnapshot&)>& after_step) {
    ReplayCursor cursor(engine, record);
    cursor.keep_samples(keep_samples);
    cursor.after_step(after_step);
    cursor.run_to_end();
    return cursor.take_outcome();
}

}  // namespace fulcrum
