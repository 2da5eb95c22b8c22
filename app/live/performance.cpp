// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/performance.h"

#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>

#include "app/live/frame_store.h"
#include "app/live/replay_player.h"
#include "app/live/trace_rig.h"
#include "assessment/metrics/version.h"
#include "assessment/operators/device_model.h"
#include "assessment/operators/skill.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/world/physics_version.h"

namespace fulcrum::app {

template <typename Action>
void RecordingSink::guarded(Action&& action) noexcept {
    if (trouble_) return;
    try {
        action();
    } catch (...) {
        trouble_ = std::current_exception();
    }
}

void RecordingSink::on_event(const Event& event) noexcept {
    MemorySink::on_event(event);
    guarded([&] { recorder_.append(event); });
}

void RecordingSink::on_tick(const RigSample& input, const TickSample& sample) noexcept {
    MemorySink::on_tick(input, sample);
    guarded([&] {
        recorder_.append(input);
        recorder_.append(sample);
    });
}

void RecordingSink::on_step(const StepRecord& step) noexcept {
    MemorySink::on_step(step);
    guarded([&] { recorder_.append(step); });
}

void RecordingSink::rethrow() const {
    if (trouble_) std::rethrow_exception(trouble_);
}

std::string hex(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

std::string cpu_features() {
#if defined(__x86_64__)
    return "x86-64-v3";
#else
    return "generic";
#endif
}

std::string state_build() {
    return std::string(program_version) + " physics " + std::to_string(physics_version) + " " +
           cpu_features();
}

database::AttemptMeta attempt_meta(const LoadedTask& loaded, std::uint64_t seed, AttemptMode mode,
                                   DeviceClass device_class, const std::string& device,
                                   const Limits& limits) {
    database::AttemptMeta meta;
    meta.task_id = loaded.task.id;
    meta.task_version = loaded.task.version;
    meta.mode = mode;
    meta.device_class = device_class;
    meta.device = device;
    meta.variant = loaded.scene.variant;
    meta.seed = seed;
    meta.fidelity = loaded.scene.fidelity.id;
    meta.scene = loaded.scene_file;
    meta.scene_text = loaded.scene_text;
    meta.limits = limits.name();
    meta.assets = loaded.assets;
    if (!limits.file.name.empty()) meta.assets.push_back(limits.file);
    meta.program_version = program_version;
    meta.cpu_features = cpu_features();
    return meta;
}

database::AttemptResult attempt_result(const ScoredAttempt& scored, const RunOutcome& outcome, double wall_s,
                                       std::uint32_t missed, std::uint64_t lost, const std::string& limits) {
    database::AttemptResult result;
    result.state = scored.state;
    result.duration_s = scored.duration_s;
    result.wall_s = wall_s;
    result.missed_ticks = missed;
    result.lost_samples = lost;
    result.state_hash = hex(outcome.state_hash);
    result.score = to_row(scored, limits);
    return result;
}

namespace {

/// Key frames of an attempt while it is performed in this thread.
class FramesOnTheWay {
  public:
    FramesOnTheWay(AttemptEngine& engine, const AttemptRecord& record, FrameStore& frames)
        : engine_(engine), record_(record), frames_(frames) {
        add();
    }
    /// After a step.
    void look() {
        if (frames_.wants(thread_seconds() - since_)) add();
    }

  private:
    void add() {
        ReplayPlace place{{}, record_.inputs.size(), record_.steps.size(), engine_.loop().model_step()};
        frames_.add(engine_, place);
        since_ = thread_seconds();
    }
    AttemptEngine& engine_;
    const AttemptRecord& record_;
    FrameStore& frames_;
    double since_ = 0;
};

std::unique_ptr<ObservingRig> make_performer(const PerformRequest& request) {
    const std::uint64_t individual = request.individual.value_or(request.seed);
    if (!request.mastery)
        return make_operator(request.operator_level.value(), request.loaded.task, request.loaded.scene,
                             individual, request.seed);
    Skill skill;
    draw_learner(*request.mastery, individual, request.seed, skill);
    return make_operator(skill, request.loaded.task, request.loaded.scene, request.seed);
}

}  // namespace

Performed perform(const PerformRequest& request, database::Recorder* recorder, const Limits& limits) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    Performed performed;
    AttemptEngine engine(request.loaded.scene, request.loaded.task, request.seed);
    performed.targets = engine.initial_snapshot().targets;

    std::unique_ptr<Rig> rig;
    if (request.input_trace != nullptr) {
        rig = std::make_unique<TraceRig>(request.input_trace->inputs);
    } else {
        rig =
            through_device(make_performer(request), request.device_class, request.loaded.scene, request.seed);
    }
    std::unique_ptr<MemorySink> sink =
        recorder != nullptr ? std::make_unique<RecordingSink>(*recorder) : std::make_unique<MemorySink>();
    std::function<void()> after_step;
    std::optional<FramesOnTheWay> frames;
    if (request.frames != nullptr) {
        engine.use_devices(devices_of(*rig));  // is part of a frame
        frames.emplace(engine, sink->record, *request.frames);
        after_step = [&frames] { frames->look(); };
    }
    performed.outcome = run_headless(engine, *rig, *sink, request.keep_going, after_step);
    if (performed.outcome.cancelled) {
        Event event;
        event.tick = performed.outcome.ticks;
        event.kind = EventKind::interrupted;
        sink->on_event(event);
    }
    if (recorder != nullptr) static_cast<RecordingSink&>(*sink).rethrow();
    performed.record = std::move(sink->record);
    performed.scored = score_record(request.loaded.scene, request.loaded.task, performed.targets,
                                    performed.record.samples, performed.record.events, limits);
    performed.wall_s = std::chrono::duration<double>(Clock::now() - begin).count();
    if (recorder != nullptr) {
        recorder->finish(
            attempt_result(performed.scored, performed.outcome, performed.wall_s, 0, 0, limits.name()));
    }
    return performed;
}

}  // namespace fulcrum::app
