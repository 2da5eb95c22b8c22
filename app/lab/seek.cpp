// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/seek.h"

#include <time.h>

#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <random>

#include "app/live/frame_store.h"
#include "app/live/replay_moment.h"
#include "app/live/replay_player.h"
#include "assessment/assets/assets.h"
#include "assessment/attempt/engine_state.h"
#include "assessment/attempt/ghost.h"
#include "assessment/attempt/memory_sink.h"
#include "assessment/operators/operator.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/yardstick.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t seed = 2001;
constexpr std::uint32_t slice_ticks = 10;
constexpr double seek_limit_s = 0.2;
constexpr int take_overs = 10;
constexpr double taken_over_s = 1;  // for which a taken-over attempt is performed before it is replayed

/// Of processor time: all of it is one thread's work, and what else the machine does is left out.
double seconds_since(double begin) {
    return thread_seconds() - begin;
}

struct Seeks {
    std::string task;
    double length_s = 0, simulate_s = 0, frames_s = 0;
    std::size_t frames = 0, bytes = 0, plain_bytes = 0;
    double keep_s = 0, reopen_s = 0;  ///< writing the file of frames; opened again, until the end is shown
    bool reopened_identical = true;
    std::vector<double> times, kept_times;  ///< s, ascending; the latter from the file
    bool identical = true;
    std::vector<double> take_over_times;  ///< s, ascending
    bool taken_over_identical = true;
    double yardstick_s = 0;            ///< G, median of those between the seeks
    double ghost_s = 0, follow_s = 0;  ///< making the ghost; placing it for one picture
    std::size_t ghost_points = 0;
};

double median_of(const std::vector<double>& ascending) {
    return ascending[ascending.size() / 2];
}

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

/// Runs through the record once and leaves key frames.
void leave_frames(const LoadedTask& loaded, const AttemptRecord& record, FrameStore& frames,
                  Seeks& measured) {
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    ReplayCursor cursor(engine, record);
    frames.add(cursor);
    double since_frame = 0;
    while (!cursor.at_end()) {
        double begin = thread_seconds();
        cursor.run_to(cursor.tick() + slice_ticks);
        const double took = seconds_since(begin);
        measured.simulate_s += took;
        since_frame += took;
        if (!frames.wants(since_frame)) continue;
        begin = thread_seconds();
        frames.add(cursor);
        measured.frames_s += seconds_since(begin);
        since_frame = 0;
    }
    measured.identical = cursor.outcome().identical;
    measured.frames = frames.count();
    measured.bytes = frames.bytes();
    measured.plain_bytes = frames.plain_bytes();
}

void seek_anywhere(const LoadedTask& loaded, const AttemptRecord& record, const FrameStore& frames, int count,
                   Seeks& measured) {
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    ReplayCursor cursor(engine, record);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> anywhere(1, record.samples.back().tick);
    std::vector<double> yardsticks;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t tick = anywhere(random);
        double begin = thread_seconds();
        if (i % 10 == 0) {
            lab::time_yardstick_us();
            yardsticks.push_back(seconds_since(begin));
            begin = thread_seconds();
        }
        frames.put(tick, cursor);
        cursor.run_to(tick);
        measured.times.push_back(seconds_since(begin));
        measured.identical = measured.identical && cursor.outcome().identical;
    }
    std::sort(measured.times.begin(), measured.times.end());
    std::sort(yardsticks.begin(), yardsticks.end());
    measured.yardstick_s = median_of(yardsticks);
}

/// The frames go into a file and are found again: from opening the replay until its end is shown, then
/// anywhere. Frames of the first pass are not looked at.
void open_again(const LoadedTask& loaded, const AttemptRecord& record, const FrameStore& frames, int count,
                Seeks& measured) {
    const QTemporaryDir folder;
    FrameKeeping keeping;
    keeping.folder = folder.path().toStdString();
    keeping.name = loaded.task.id + ".frames";
    keeping.belongs = frames_belong_to(loaded.scene_text);
    const std::uint32_t last = record.samples.back().tick;
    double begin = thread_seconds();
    {
        FrameFileWriter writer(keeping, frames.frames(), last);
        while (writer.write_more()) {
        }
    }
    measured.keep_s = seconds_since(begin);
    begin = thread_seconds();
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    ReplayCursor cursor(engine, record);
    FrameStore kept;
    kept.restore(FrameFile::open(keeping));
    kept.put(last, cursor);
    cursor.run_to(last);
    measured.reopen_s = seconds_since(begin);
    measured.reopened_identical = kept.count() == frames.count() && cursor.outcome().identical;
    std::mt19937 random(3);
    std::uniform_int_distribution<std::uint32_t> anywhere(1, last);
    for (int i = 0; i < count; ++i) {
        const std::uint32_t tick = anywhere(random);
        begin = thread_seconds();
        kept.put(tick, cursor);
        cursor.run_to(tick);
        measured.kept_times.push_back(seconds_since(begin));
        measured.reopened_identical = measured.reopened_identical && cursor.outcome().identical;
    }
    std::sort(measured.kept_times.begin(), measured.kept_times.end());
}

/// The hands go back as they came, from the moment that `engine` is at.
AttemptRecord go_back(AttemptEngine& engine, const AttemptRecord& source, std::uint32_t from) {
    MemorySink sink;
    const auto m = static_cast<std::uint32_t>(engine.scene().ticks_per_step);
    const auto ticks = static_cast<std::uint32_t>(taken_over_s * engine.scene().tick_rate) / m * m;
    std::vector<TickOutput> outputs;
    for (std::uint32_t i = 1; i <= ticks; ++i) {
        RigSample input = source.inputs[from - std::min(i, from)];
        input.tick = engine.next_tick();
        outputs.push_back(engine.tick(input));
        sink.on_tick(outputs.back().input, outputs.back().sample);
        if (input.tick % m != 0) continue;
        engine.adopt(engine.world().local_models());
        engine.step(outputs.data(), outputs.size(), sink);
        outputs.clear();
    }
    return std::move(sink.record);
}

/// From random moments before the end of the attempt: a new engine at that moment, as the window makes it;
/// then what is performed from there is replayed from its own state.
void take_over_anywhere(const LoadedTask& loaded, const std::shared_ptr<const AttemptRecord>& record,
                        const FrameStore& frames, Seeks& measured) {
    const std::uint32_t last = settled_tick(*record, record->samples.back().tick);
    std::mt19937 random(2);
    std::uniform_int_distribution<std::uint32_t> anywhere(std::min(last, 1000U), last);
    const std::atomic<bool> stop{false};
    for (int i = 0; i < take_overs; ++i) {
        TraceMoment moment;
        moment.loaded = loaded;
        moment.seed = seed;
        moment.record = record;
        moment.tick = settled_tick(*record, anywhere(random));
        const double begin = thread_seconds();
        moment.frame = frames.state(moment.tick);
        AttemptEngine engine(loaded.scene, loaded.task, seed);
        moment.bring(engine, stop);
        engine.begin_here();
        measured.take_over_times.push_back(seconds_since(begin));
        const std::vector<std::uint8_t> state = engine_state(engine);
        const AttemptRecord taken = go_back(engine, *record, moment.tick);
        AttemptEngine again(loaded.scene, loaded.task, seed);
        restore_engine(again, state);
        ReplayCursor cursor(again, taken);
        cursor.run_to_end();
        measured.taken_over_identical = measured.taken_over_identical && cursor.outcome().identical;
    }
    std::sort(measured.take_over_times.begin(), measured.take_over_times.end());
}

void time_ghost(const LoadedTask& loaded, Seeks& measured) {
    double begin = thread_seconds();
    const std::shared_ptr<const GhostPath> path =
        make_ghost(loaded.scene, loaded.task, seed, [] { return true; });
    measured.ghost_s = seconds_since(begin);
    measured.ghost_points = path->points.size();
    GhostPace pace(path);
    begin = thread_seconds();
    // A trainee who moves as the ghost does: every point is looked for once.
    for (const GhostPoint& point : path->points) pace.follow(point.tools, point.goal);
    measured.follow_s = seconds_since(begin) / static_cast<double>(path->points.size());
}

Seeks measure(const std::string& id, double seconds, int count) {
    const LoadedTask loaded = load_task_and_scene(id);
    const auto record = std::make_shared<const AttemptRecord>(long_attempt(loaded, seconds));
    Seeks measured;
    measured.task = id;
    measured.length_s = record->samples.back().tick * loaded.scene.tick_period();
    FrameStore frames;
    leave_frames(loaded, *record, frames, measured);
    seek_anywhere(loaded, *record, frames, count, measured);
    open_again(loaded, *record, frames, count, measured);
    take_over_anywhere(loaded, record, frames, measured);
    time_ghost(loaded, measured);
    return measured;
}

lab::ResultTable practice_table(const std::vector<Seeks>& all) {
    lab::ResultTable table;
    table.name = "lab_take_over";
    table.columns = {"task",          "take over, median (ms)", "take over, worst (ms)",
                     "bit for bit",   "ghost made in (s)",      "ghost (s)",
                     "a picture (µs)"};
    for (const Seeks& one : all)
        table.rows.push_back(
            {one.task, lab::short_number(1e3 * median_of(one.take_over_times), 3),
             lab::short_number(1e3 * one.take_over_times.back(), 3), one.taken_over_identical ? "yes" : "no",
             lab::short_number(one.ghost_s, 3),
             lab::short_number(static_cast<double>(one.ghost_points) * GhostPath::spacing_s, 4),
             lab::short_number(1e6 * one.follow_s, 3)});
    return table;
}

double bytes_per_minute(const Seeks& one) {
    return static_cast<double>(one.bytes) * 60 / one.length_s;
}

nlohmann::json json_of_seeks(const Seeks& one) {
    return {{"task", one.task},
            {"attempt_s", one.length_s},
            {"simulate_s", one.simulate_s},
            {"frames_s", one.frames_s},
            {"frames", one.frames},
            {"bytes_per_minute", bytes_per_minute(one)},
            {"frame_bytes", one.plain_bytes},
            {"seek_median_s", median_of(one.times)},
            {"seek_worst_s", one.times.back()},
            {"yardstick_s", one.yardstick_s},
            {"identical", one.identical},
            {"keep_s", one.keep_s},
            {"opened_again_s", one.reopen_s},
            {"kept_seek_median_s", median_of(one.kept_times)},
            {"kept_seek_worst_s", one.kept_times.back()},
            {"kept_identical", one.reopened_identical},
            {"take_over_median_s", median_of(one.take_over_times)},
            {"take_over_worst_s", one.take_over_times.back()},
            {"taken_over_identical", one.taken_over_identical},
            {"ghost_s", one.ghost_s},
            {"ghost_points", one.ghost_points},
            {"ghost_follow_s", one.follow_s}};
}

lab::ResultTable reopened_table(const std::vector<Seeks>& all) {
    lab::ResultTable table;
    table.name = "lab_opened_again";
    table.columns = {"task",
                     "file written in (ms)",
                     "opened again: until the end is shown (ms)",
                     "seek, median (ms)",
                     "seek, worst (ms)",
                     "bit for bit"};
    for (const Seeks& one : all)
        table.rows.push_back(
            {one.task, lab::short_number(1e3 * one.keep_s, 3), lab::short_number(1e3 * one.reopen_s, 3),
             lab::short_number(1e3 * median_of(one.kept_times), 3),
             lab::short_number(1e3 * one.kept_times.back(), 3), one.reopened_identical ? "yes" : "no"});
    return table;
}

}  // namespace

Measured measure_seeks(const std::vector<std::string>& tasks, double seconds, int seeks) {
    std::string named;
    if (tasks != task_ids())
        for (const std::string& task : tasks) named += task + ' ';
    Measured measured{lab::ResultPage("lab_seek", "Seeking in a replay",
                                      "fulcrum lab seek " + named + "--output docs/results"),
                      {}};
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
                     "G (ms)",
                     "seek, worst (G)",
                     "bit for bit"};
    nlohmann::json document = nlohmann::json::array();
    std::vector<Seeks> all;
    double worst_of_all = 0;
    for (const std::string& task : tasks) {
        std::cerr << task << '\n';
        all.push_back(measure(task, seconds, seeks));
        const Seeks& one = all.back();
        const double median = median_of(one.times), worst = one.times.back();
        worst_of_all = std::max(worst_of_all, worst);
        const auto frames = static_cast<double>(one.frames), bytes = static_cast<double>(one.bytes);
        table.rows.push_back({task, lab::short_number(one.length_s, 4), lab::short_number(one.simulate_s, 3),
                              lab::short_number(one.frames_s, 3), std::to_string(one.frames),
                              lab::short_number(bytes / frames / 1024, 3),
                              lab::short_number(bytes_per_minute(one) / (1 << 20), 3),
                              lab::short_number(static_cast<double>(one.plain_bytes) / 1024, 4),
                              lab::short_number(1e3 * median, 3), lab::short_number(1e3 * worst, 3),
                              lab::short_number(1e3 * one.yardstick_s, 3),
                              lab::short_number(worst / one.yardstick_s, 3), one.identical ? "yes" : "no"});
        document.push_back(json_of_seeks(one));
    }
    measured.page.paragraph(
        "An attempt of the expert operator (seed 2001), continued with its own inputs backwards and "
        "forwards, was replayed once and left key frames; then each task was sought at " +
        std::to_string(seeks) +
        " random moments from any other. A seek makes the state of the key frame before the moment from the "
        "kept differences and simulates from there. Times are processor time of the one thread that does it. "
        "\"Bit for bit\": every sample and "
        "every state hash on the way is that of the record. G is the time of one 512 x 512 x 512 double "
        "matrix "
        "product, measured between the seeks, by which machines compare, as in lab_bench.md. The "
        "limit of a seek is " +
        lab::short_number(1e3 * seek_limit_s, 3) + " ms; the slowest of all took " +
        lab::short_number(1e3 * worst_of_all, 3) +
        " ms: " + (worst_of_all <= seek_limit_s ? "met." : "not met on this machine."));
    measured.page.table(table);
    measured.page.paragraph(
        "Opened again: the key frames of the first pass are in a file next to the store. The replay's engine "
        "is made, the file opened and checked, and the end of the attempt shown; then it was sought at " +
        std::to_string(seeks) +
        " random moments. Frames are read when they are needed and compared with their checksums. \"Bit for "
        "bit\": as above.");
    measured.page.table(reopened_table(all));
    measured.page.paragraph(
        "Taking over: a new engine is made and brought to one of " + std::to_string(take_overs) +
        " random moments before the attempt's end; that is what the window waits for before practice begins. "
        "From there the hands go back as they came for one second, and this new attempt is replayed from the "
        "state that it began with. The ghost is the path of the expert operator: it is simulated once for a "
        "task while the program runs, and placed again for each picture.");
    measured.page.table(practice_table(all));
    measured.document = {{"seeks", document}, {"seek_limit_s", seek_limit_s}};
    measured.page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
