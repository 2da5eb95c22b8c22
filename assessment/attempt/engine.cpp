// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/engine.h"

#include <algorithm>
#include <cstring>

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

const TickOutput& AttemptEngine::tick(const RigSample& input) noexcept {
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
        rig.write_force(static_cast<Hand>(hand), output.device_force[hand]);
        rig.write_torque(static_cast<Hand>(hand), output.device_torque[hand]);
    }
}

RunOutcome run_headless(AttemptEngine& engine, Rig& rig, AttemptSink& sink,
                        const std::function<bool(double)>& keep_going,
                        const std::function<void()>& after_step) {
    auto* observer = dynamic_cast<ObservingRig*>(&rig);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine.scene().ticks_per_step);
    const auto ticks_per_question = static_cast<std::uint32_t>(engine.scene().tick_rate);
    std::vector<TickOutput> outputs(ticks_per_step);
    if (observer != nullptr) observer->observe(engine.initial_snapshot(), engine.display());
    engine.use_devices(devices_of(rig));

    RunOutcome outcome;
    bool pending = false;  // a step is done and waits for its tick
    for (std::uint32_t tick = 1; !engine.ended(); ++tick) {
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

/// Stores the results of the replay.
class ReplaySink : public AttemptSink {
  public:
    explicit ReplaySink(ReplayOutcome& outcome) : outcome_(outcome) {}
    void on_event(const Event& event) noexcept override { outcome_.events.push_back(event); }
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& step) noexcept override { last_ = step; }
    const StepRecord& last() const noexcept { return last_; }

  private:
    ReplayOutcome& outcome_;
    StepRecord last_;
};

bool same_sample(const TickSample& a, const TickSample& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// A hand whose device renders no force was sent none: what older records hold there was never felt.
void forget_unfelt(const ForceDevices& devices, TickSample& sample) {
    for (std::size_t h = 0; h < devices.size(); ++h) {
        if (devices[h]) continue;
        HandSample& hand = sample.hand[h];
        std::fill(std::begin(hand.device_force), std::end(hand.device_force), 0);
        hand.flags = static_cast<std::uint16_t>(hand.flags & ~static_cast<unsigned>(hand_clamped));
    }
}

}  // namespace

ReplayOutcome replay_record(AttemptEngine& engine, const AttemptRecord& record, bool keep_samples,
                            const std::function<bool(const WorldSnapshot&)>& after_step) {
    static_assert(std::has_unique_object_representations_v<HandSample> &&
                  std::has_unique_object_representations_v<CameraSample>);
    ReplayOutcome outcome;
    ReplaySink sink(outcome);
    engine.use_devices(record.devices);
    std::vector<TickOutput> outputs;
    std::size_t next_step = 0;
    bool stopped = false;
    const auto diverged = [&](std::uint32_t tick) {
        if (outcome.identical) outcome.first_divergence_s = tick * engine.scene().tick_period();
        outcome.identical = false;
    };
    const auto step_once = [&]() {
        const StepRecord& recorded = record.steps[next_step];
        std::size_t count = 0;
        while (count < outputs.size() && outputs[count].sample.tick <= recorded.last_tick) ++count;
        engine.step(outputs.data(), count, sink);
        outputs.erase(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(count));
        if (sink.last().state_hash != recorded.state_hash || sink.last().outcome != recorded.outcome)
            diverged(recorded.last_tick);
        if (after_step && !after_step(engine.world().snapshot())) stopped = true;
        ++next_step;
    };
    std::uint32_t adopted = 0;
    for (std::size_t i = 0; i < record.inputs.size() && !stopped; ++i) {
        const RigSample& input = record.inputs[i];
        const TickSample& recorded = record.samples[i];
        if (recorded.model_step != adopted) {  // the step whose model was used in this tick, from the record
            while (next_step < record.steps.size() && record.steps[next_step].step <= recorded.model_step)
                step_once();
            engine.adopt(engine.world().local_models());
            adopted = recorded.model_step;
        }
        TickOutput output = engine.tick(input);
        output.sample.missed = recorded.missed;  // depends on wall time, not on the simulation
        TickSample expected = recorded;
        forget_unfelt(record.devices, expected);
        if (!same_sample(output.sample, expected)) diverged(recorded.tick);
        if (keep_samples) outcome.samples.push_back(output.sample);
        outputs.push_back(output);
        // Where no tick waits for a model any more (never one without instruments), steps follow their ticks:
        // what waits would otherwise grow with the attempt.
        if (record.samples.back().model_step != adopted) continue;
        while (next_step < record.steps.size() && record.steps[next_step].last_tick <= recorded.tick &&
               !stopped)
            step_once();
    }
    while (next_step < record.steps.size() && !stopped) step_once();
    outcome.state_hash = engine.state_hash();
    return outcome;
}

}  // namespace fulcrum
