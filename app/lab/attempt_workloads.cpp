// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/attempt_workloads.h"

#include <memory>
#include <vector>

#include "app/lab/plane_workload.h"
#include "app/live/performance.h"
#include "assessment/operators/operator.h"
#include "database/rows/trace_codec.h"

namespace fulcrum::app {
namespace {

/// With another rate of the tick than the scene's (0: that one), and steps of the world as often as there.
LoadedTask load_at(const std::string& task, int tick_rate) {
    LoadedTask loaded = load_task_and_scene(task);
    Scene& scene = loaded.scene;
    if (tick_rate == 0) return loaded;
    scene.ticks_per_step = tick_rate * scene.ticks_per_step / scene.tick_rate;
    scene.tick_rate = tick_rate;
    return loaded;
}

/// An expert performing a task, advanced tick by tick, so that what is timed is the real mix of approach,
/// grasp and traction.
struct Bench : public AttemptSink {
    LoadedTask loaded;
    AttemptEngine engine;
    std::unique_ptr<ObservingRig> rig;
    std::vector<TickOutput> outputs;
    std::uint32_t tick = 0;
    std::uint32_t ticks_per_step;

    explicit Bench(const std::string& task, double warm_seconds, int tick_rate = 0)
        : loaded(load_at(task, tick_rate)),
          engine(loaded.scene, loaded.task, 7),
          rig(make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 7)),
          ticks_per_step(static_cast<std::uint32_t>(loaded.scene.ticks_per_step)) {
        outputs.resize(ticks_per_step);
        // With a device that renders force, as the tick costs most: b of 0.5 N s/m.
        ForceOutput device;
        device.damping = 0.5;
        engine.use_devices({device, device});
        rig->observe(engine.initial_snapshot(), engine.display());
        for (int i = 0; i < static_cast<int>(warm_seconds * loaded.scene.tick_rate / ticks_per_step); ++i) {
            ticks();
            world();
        }
    }
    RigSample read() {
        RigSample input;
        input.tick = ++tick;
        rig->read(tick, input);
        input.tick = tick;
        return input;
    }
    void ticks() {
        for (std::uint32_t i = 0; i < ticks_per_step; ++i) {
            const RigSample input = read();
            outputs[i] = engine.tick(input);
        }
    }
    void world() {
        engine.step(outputs.data(), outputs.size(), *this);
        engine.adopt(engine.world().local_models());
        rig->observe(engine.world().snapshot(), engine.display());
    }
    void on_event(const Event& /*event*/) noexcept override {}
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& /*step*/) noexcept override {}
};

/// One tick of the haptic loop with its operator.
lab::Workload tick_workload(const char* name, double budget_mg, int tick_rate = 0) {
    lab::Workload tick;
    tick.name = name;
    tick.budget_mg = budget_mg;
    tick.samples = 4000;
    tick.prepare = [tick_rate] {
        auto bench = std::make_shared<Bench>("B1", 8.0, tick_rate);
        lab::Workload::Prepared prepared;
        // The world's step is not part of the tick: it runs between two timed ticks.
        prepared.step = [bench] {
            const RigSample input = bench->read();
            bench->outputs[(input.tick - 1) % bench->ticks_per_step] = bench->engine.tick(input);
        };
        prepared.between = [bench] {
            if (bench->tick % bench->ticks_per_step == 0) bench->world();
        };
        prepared.bytes = sizeof(LocalModels) * 2;
        return prepared;
    };
    return tick;
}

/// One step of the world of a task; `parts` are those whose bytes count.
lab::Workload world_workload(const char* name, const char* task, double budget_mg,
                             const std::set<std::string>& parts) {
    lab::Workload world;
    world.name = name;
    world.budget_mg = budget_mg;
    world.samples = 1500;
    world.prepare = [task, parts] {
        auto bench = std::make_shared<Bench>(task, 8.0);
        lab::Workload::Prepared prepared;
        prepared.step = [bench] { bench->engine.step(bench->outputs.data(), bench->outputs.size(), *bench); };
        prepared.between = [bench] {
            bench->engine.adopt(bench->engine.world().local_models());
            bench->rig->observe(bench->engine.world().snapshot(), bench->engine.display());
            bench->ticks();
        };
        prepared.bytes = bytes_of(bench->engine.world(), parts);
        if (!bench->loaded.scene.bowel) return prepared;
        prepared.error = [bench] {
            return std::optional<double>(bench->engine.world().snapshot().bowel.solve_residual);
        };
        prepared.error_unit = "relative rod residual of the last step";
        return prepared;
    };
    return world;
}

/// Encoding one second of record, as the recorder does once a second.
lab::Workload recording_workload() {
    lab::Workload recording;
    recording.name = "recording_1s";
    recording.samples = 100;
    recording.budget_mg = 0;
    recording.prepare = [] {
        Bench bench("B1", 4.0);
        auto samples = std::make_shared<std::vector<TickSample>>();
        auto inputs = std::make_shared<std::vector<RigSample>>();
        for (int i = 0; i < 200; ++i) {
            bench.ticks();
            for (const TickOutput& output : bench.outputs) {
                samples->push_back(output.sample);
                inputs->push_back(output.input);
            }
            bench.world();
        }
        auto codec = std::make_shared<database::TraceCodec>();
        auto bytes = std::make_shared<std::size_t>(
            codec->encode(samples->data(), samples->size(), inputs->data()).data.size() +
            codec->encode(inputs->data(), inputs->size()).data.size());
        lab::Workload::Prepared prepared;
        prepared.step = [codec, samples, inputs] {
            codec->encode(samples->data(), samples->size(), inputs->data());
            codec->encode(inputs->data(), inputs->size());
        };
        prepared.bytes = *bytes;
        prepared.error = [bytes] {
            return std::optional<double>(static_cast<double>(*bytes) * 600.0 / 1048576.0);
        };
        prepared.error_unit = "MiB per 10 min";
        return prepared;
    };
    return recording;
}

}  // namespace

std::size_t bytes_of(const World& world, const std::set<std::string>& parts) {
    std::size_t bytes = 0;
    for (const PartCost& cost : world.costs()) {
        if (parts.count(cost.part) != 0) bytes += cost.bytes;
    }
    return bytes;
}

std::vector<lab::Workload> attempt_workloads() {
    // At the paper's rate a tick may take the same share of its period.
    return {tick_workload("tick", 15),
            tick_workload("tick_1200hz", 12.5, 1200),
            world_workload("world_a3", "A3", 60, {"objects", "pegs"}),
            world_workload("world_b1", "B1", 90, {"rod", "collision", "cage_and_surface"}),
            plane_workload(),
            recording_workload()};
}

}  // namespace fulcrum::app
