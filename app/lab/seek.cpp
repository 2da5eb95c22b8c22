// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/seek.h"

#include <algorithm>
#include <chrono>
#include <random>

#include "app/services/frame_store.h"
#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/lab/chart.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t seed = 2001;
constexpr std::uint32_t slice_ticks = 10;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Seeks {
    std::string task;
    double length_s = 0, simulate_s = 0, frames_s = 0;
    std::size_t frames = 0, bytes = 0, plain_bytes = 0;
    std::vector<double> times;  ///< s, ascending
    bool identical = true;
};

/// The expert's inputs until the attempt ends, then the same backwards, forwards, and so on: a long attempt
/// whose hands keep working on the tissue.
class LongRig : public ObservingRig {
  public:
    LongRig(std::unique_ptr<ObservingRig> performer, const AttemptEngine& engine)
        : expert_(std::move(performer)), engine_(engine) {}
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        if (!engine_.ended()) expert_->observe(world, display);
    }
    void read(std::uint32_t tick, RigSample& sample) override {
        if (!engine_.ended()) {
            expert_->read(tick, sample);
            made_.push_back(sample);
            return;
        }
        const std::size_t length = made_.size(), place = (tick - 1) % (2 * length);
        sample = made_[place < length ? place : 2 * length - 1 - place];
        sample.tick = tick;
    }
    void write_force(Hand hand, const Vector3& force) override { expert_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return expert_->has_force(hand); }
    double damping(Hand hand) const override { return expert_->damping(hand); }

  private:
    std::unique_ptr<ObservingRig> expert_;
    const AttemptEngine& engine_;
    std::vector<RigSample> made_;
};

AttemptRecord long_attempt(const LoadedTask& loaded, double seconds) {
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    LongRig rig(make_operator(OperatorLevel::expert, loaded.task, loaded.scene, seed), engine);
    MemorySink sink;
    run_headless(engine, rig, sink, [seconds](double now) { return now < seconds; });
    // The monitor has ended the attempt; ticks and steps continue as before.
    const auto ticks = static_cast<std::uint32_t>(seconds * loaded.scene.tick_rate);
    const auto m = static_cast<std::uint32_t>(loaded.scene.ticks_per_step);
    std::vector<TickOutput> outputs;
    for (std::uint32_t tick = engine.next_tick(); tick <= ticks; ++tick) {
        RigSample input;
        rig.read(tick, input);
        outputs.push_back(engine.tick(input));
        sink.on_tick(outputs.back().input, outputs.back().sample);
        if (tick % m != 0) continue;
        engine.adopt(engine.world().local_models());
        engine.step(outputs.data(), outputs.size(), sink);
        outputs.clear();
    }
    return std::move(sink.record);
}

Seeks measure(const std::string& id, double seconds, int count) {
    const LoadedTask loaded = load_task_and_scene(id);
    const AttemptRecord record = long_attempt(loaded, seconds);
    Seeks measured;
    measured.task = id;
    measured.length_s = record.samples.back().tick * loaded.scene.tick_period();
    FrameStore frames;
    {
        AttemptEngine engine(loaded.scene, loaded.task, seed);
        ReplayCursor cursor(engine, record);
        frames.add(cursor);
        double since_frame = 0;
        while (!cursor.at_end()) {
            Clock::time_point begin = Clock::now();
            cursor.run_to(cursor.tick() + slice_ticks);
            const double took = seconds_since(begin);
            measured.simulate_s += took;
            since_frame += took;
            if (!frames.wants(since_frame)) continue;
            begin = Clock::now();
            frames.add(cursor);
            measured.frames_s += seconds_since(begin);
            since_frame = 0;
        }
        measured.identical = cursor.outcome().identical;
    }
    measured.frames = frames.count();
    measured.bytes = frames.bytes();
    measured.plain_bytes = frames.plain_bytes();
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    ReplayCursor cursor(engine, record);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> anywhere(1, record.samples.back().tick);
    for (int i = 0; i < count; ++i) {
        const std::uint32_t tick = anywhere(random);
        const Clock::time_point begin = Clock::now();
        FrameStore::put(frames.before(tick), cursor);
        cursor.run_to(tick);
        measured.times.push_back(seconds_since(begin));
        measured.identical = measured.identical && cursor.outcome().identical;
    }
    std::sort(measured.times.begin(), measured.times.end());
    return measured;
}

}  // namespace

Measured measure_seeks(const std::vector<std::string>& tasks, double seconds, int seeks) {
    Measured measured{
        lab::ResultPage("lab_seek", "Seeking in a replay", "fulcrum lab seek --output docs/results"), {}};
    lab::ResultTable table;
    table.name = "lab_seek";
    table.columns = {"task",
                     "attempt (s)",
                     "simulated in (s)",
                     "frames made in (s)",
                     "key frames",
                     "KiB per frame",
                     "MiB per minute",
                     "uncompressed (KiB per frame)",
                     "seek, median (ms)",
                     "seek, worst (ms)",
                     "bit for bit"};
    nlohmann::json document = nlohmann::json::array();
    for (const std::string& task : tasks) {
        const Seeks one = measure(task, seconds, seeks);
        const double median = one.times[one.times.size() / 2], worst = one.times.back();
        const auto frames = static_cast<double>(one.frames), bytes = static_cast<double>(one.bytes);
        const double per_minute = bytes * 60 / one.length_s;
        table.rows.push_back({task, lab::short_number(one.length_s, 4), lab::short_number(one.simulate_s, 3),
                              lab::short_number(one.frames_s, 3), std::to_string(one.frames),
                              lab::short_number(bytes / frames / 1024, 3),
                              lab::short_number(per_minute / (1 << 20), 3),
                              lab::short_number(static_cast<double>(one.plain_bytes) / 1024, 4),
                              lab::short_number(1e3 * median, 3), lab::short_number(1e3 * worst, 3),
                              one.identical ? "yes" : "no"});
        document.push_back({{"task", task},
                            {"attempt_s", one.length_s},
                            {"simulate_s", one.simulate_s},
                            {"frames_s", one.frames_s},
                            {"frames", one.frames},
                            {"bytes_per_minute", per_minute},
                            {"frame_bytes", one.plain_bytes},
                            {"seek_median_s", median},
                            {"seek_worst_s", worst},
                            {"identical", one.identical}});
    }
    measured.page.paragraph(
        "An attempt of the expert operator (seed 2001), continued with its own inputs backwards and "
        "forwards, "
        "was replayed once and left key frames; then each task was sought at " +
        std::to_string(seeks) +
        " random moments from any other. A seek unpacks the key frame before the moment and simulates from "
        "there. \"Bit for bit\": every sample and every state hash on the way is that of the record.");
    measured.page.table(table);
    measured.document = {{"seeks", document}};
    measured.page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
