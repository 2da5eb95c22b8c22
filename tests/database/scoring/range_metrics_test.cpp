// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics of a part of a record: hand by hand, from the columns that are needed, as from all at once.
#include "database/scoring/range_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "assessment/metrics/registry.h"
#include "database/rows/packed_ticks.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// Two hands and a scope that move and rest, press, grasp, cut and use energy, on several tissues; a pause, a
/// gap and a spike are in it.
database::Trace busy_record(int tissues, std::uint32_t ticks) {
    database::Trace trace;
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
        if (tick > 4000 && tick < 4200) continue;  // a gap
        const double t = tick * 1e-3;
        TickSample sample;
        sample.tick = tick;
        for (int h = 0; h < hand_count; ++h) {
            HandSample& hand = sample.hand[h];
            // A second of movement, half a second of rest.
            const double phase = std::fmod(t + 0.4 * h, 1.5),
                         moved = std::floor((t + 0.4 * h) / 1.5) + std::min(phase, 1.0);
            for (int axis = 0; axis < 3; ++axis) {
                const double place = 0.03 * std::sin(2.1 * moved + axis + h) + 2e-5 * std::sin(50 * t + axis);
                hand.tip[axis] = static_cast<std::int32_t>(std::lround(place / sample_length_unit));
                const double force = std::max(0.0, 3 * std::sin(1.7 * t + axis + h));
                hand.force[axis] = static_cast<std::int32_t>(std::lround(force / sample_force_unit));
            }
            const double turned = 0.4 * std::sin(moved + h);
            hand.axis[0] = static_cast<std::int32_t>(std::lround(std::sin(turned) / sample_axis_unit));
            hand.axis[2] = static_cast<std::int32_t>(std::lround(-std::cos(turned) / sample_axis_unit));
            hand.roll = static_cast<std::int32_t>(tick * 10);
            const bool grasps = std::fmod(t + 0.7 * h, 2.0) < 0.6;
            hand.jaw_force = grasps ? 1500 + static_cast<std::int32_t>(200 * std::sin(9 * t)) : 0;
            hand.jaw_area = grasps ? 30'000 : 0;
            hand.tissue = static_cast<std::int16_t>(grasps ? static_cast<int>(t) % (tissues + 1) - 1 : -1);
            hand.patch = static_cast<std::int16_t>(grasps ? static_cast<int>(2 * t) % 4 : -1);
            hand.flags = static_cast<std::uint16_t>(hand_inside | (std::sin(t) > -0.6 ? hand_in_view : 0) |
                                                    (std::sin(3 * t + h) > 0.7 ? hand_energy : 0) |
                                                    (std::sin(0.9 * t) > 0.8 ? hand_cutting : 0));
        }
        if (tick == 2500) sample.hand[0].force[1] += 30'000;  // a spike
        sample.camera.tip[0] = static_cast<std::int32_t>(200'000 * std::sin(0.5 * t));
        sample.camera.orientation[1] = static_cast<std::int32_t>(20'000'000 * std::sin(0.3 * t));
        RigSample input;
        input.tick = tick;
        trace.samples.push_back(sample);
        trace.inputs.push_back(input);
    }
    const auto event = [&](std::uint32_t tick, EventKind kind, int hand, int detail) {
        Event one;
        one.tick = tick;
        one.kind = kind;
        one.hand = static_cast<std::uint8_t>(hand);
        one.detail = detail;
        trace.events.push_back(one);
    };
    event(300, EventKind::first_movement, 0, 0);
    event(900, EventKind::target_shown, 0, 0);
    for (std::uint32_t tick = 1000; tick < ticks; tick += 1000) {
        event(tick, EventKind::grasp, static_cast<int>(tick / 1000 % 2), 3);
        event(tick + 500, EventKind::release, static_cast<int>(tick / 1000 % 2), 3);
        event(tick + 600, EventKind::target_reached, 1, 0);
    }
    event(6100, EventKind::pause, 0, 0);
    event(6400, EventKind::resume, 0, 0);
    std::stable_sort(trace.events.begin(), trace.events.end(),
                     [](const Event& a, const Event& b) { return a.tick < b.tick; });
    return trace;
}

database::Trace packed(const database::Trace& trace) {
    const auto ticks = std::make_shared<database::PackedTicks>();
    database::TraceCodec codec;
    constexpr std::size_t chunk = 1000;
    for (std::size_t first = 0; first < trace.samples.size(); first += chunk) {
        const std::size_t count = std::min(chunk, trace.samples.size() - first);
        EXPECT_TRUE(ticks->add(codec.encode(&trace.inputs[first], count),
                               codec.encode(&trace.samples[first], count, &trace.inputs[first])));
    }
    database::Trace result;
    result.ticks = ticks;
    result.events = trace.events;
    return result;
}

void expect_same(const std::vector<MetricResult>& a, const std::vector<MetricResult>& b,
                 const std::string& what) {
    ASSERT_EQ(a.size(), b.size()) << what;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::string row = what + ": " + a[i].id + "." + a[i].hand + "." + a[i].tissue;
        EXPECT_EQ(a[i].id + "." + a[i].hand + "." + a[i].tissue,
                  b[i].id + "." + b[i].hand + "." + b[i].tissue)
            << row;
        EXPECT_EQ(a[i].value, b[i].value) << row;
        EXPECT_EQ(a[i].absence, b[i].absence) << row;
        EXPECT_TRUE(a[i].absent_because == b[i].absent_because) << row;
        EXPECT_EQ(a[i].direction, b[i].direction) << row;
        EXPECT_EQ(a[i].count, b[i].count) << row;
        ASSERT_EQ(a[i].evidence.size(), b[i].evidence.size()) << row;
        for (std::size_t k = 0; k < a[i].evidence.size(); ++k) {
            EXPECT_EQ(a[i].evidence[k].begin, b[i].evidence[k].begin) << row;
            EXPECT_EQ(a[i].evidence[k].end, b[i].evidence[k].end) << row;
        }
    }
}

std::size_t values_in(const std::vector<MetricResult>& rows) {
    std::size_t count = 0;
    for (const MetricResult& row : rows) count += row.value.has_value() ? 1 : 0;
    return count;
}

TEST(RangeMetrics, AreTheSameHandByHandAsAllAtOnceForEveryTaskAndEveryMetric) {
    std::vector<std::string> every;
    for (const Metric& metric : metric_registry()) every.push_back(metric.descriptor.id);
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/tasks"))) {
        TaskDefinition task = load_task(entry.path().string());
        const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
        const database::Trace trace = busy_record(static_cast<int>(scene.tissues.size()), 7000);
        const database::Trace as_stored = packed(trace);
        for (const bool all : {false, true}) {
            if (all) task.metrics = every;
            const auto at_once = metrics_of_range(scene, task, 7, trace, 0.5, 6.8, {RangePasses::at_once});
            EXPECT_GT(values_in(at_once), 3U) << task.id;
            expect_same(metrics_of_range(scene, task, 7, as_stored, 0.5, 6.8, {RangePasses::hand_by_hand}),
                        at_once, task.id + (all ? ", every metric" : ""));
            expect_same(metrics_of_range(scene, task, 7, as_stored, 0.5, 6.8), at_once, task.id + ", packed");
        }
    }
}

TEST(RangeMetrics, OfNothingAndBeyondTheEndAreRowsWithoutValues) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const database::Trace trace = packed(busy_record(static_cast<int>(scene.tissues.size()), 2000));
    for (const auto& [from, to] : {std::pair{1.5, 0.5}, std::pair{50.0, 60.0}, std::pair{-5.0, -1.0},
                                   std::pair{1.0, 1e300}, std::pair{4.01, 4.19}})
        expect_same(metrics_of_range(scene, task, 7, trace, from, to, {RangePasses::hand_by_hand}),
                    metrics_of_range(scene, task, 7, trace, from, to, {RangePasses::at_once}),
                    std::to_string(from) + " to " + std::to_string(to));
}

TEST(RangeMetrics, APauseThatBeganBeforeThePartIsNoWork) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const database::Trace paused = busy_record(static_cast<int>(scene.tissues.size()), 9000);
    database::Trace lost = paused;
    for (Event& event : lost.events) {
        if (event.kind == EventKind::pause) event.kind = EventKind::device_lost;
        if (event.kind == EventKind::resume) event.kind = EventKind::device_back;
    }
    const auto value = [](const std::vector<MetricResult>& rows, const char* id, const char* hand) {
        const MetricResult* row = find_result(rows, id, hand, "");
        return row != nullptr ? row->value.value_or(-1) : -1;
    };
    for (const database::Trace* trace : std::initializer_list<const database::Trace*>{&paused, &lost}) {
        // From within the pause (6.1 to 6.4 s), from its end, from later, and a part of the pause alone.
        const auto within = metrics_of_range(scene, task, 7, *trace, 6.2, 8.0),
                   at_end = metrics_of_range(scene, task, 7, *trace, 6.4, 8.0),
                   later = metrics_of_range(scene, task, 7, *trace, 6.5, 8.0);
        EXPECT_NEAR(value(within, "time", ""), 1.6, 0.05);
        EXPECT_NEAR(value(at_end, "time", ""), 1.6, 0.05);
        EXPECT_NEAR(value(later, "time", ""), 1.5, 0.05);
        EXPECT_GT(value(within, "path_len", "left"), 0);
        EXPECT_NEAR(value(within, "path_len", "left"), value(at_end, "path_len", "left"), 1e-6);
        const auto nothing = metrics_of_range(scene, task, 7, *trace, 6.15, 6.35);
        EXPECT_LT(value(nothing, "time", ""), 1e-9) << "no time of work";
        expect_same(metrics_of_range(scene, task, 7, packed(*trace), 6.2, 8.0, {RangePasses::hand_by_hand}),
                    within, "from within a pause");
    }
}

TEST(RangeMetrics, StopAsSoonAsNobodyWantsThem) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/B2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const database::Trace trace = packed(busy_record(static_cast<int>(scene.tissues.size()), 2000));
    RangeOptions options{RangePasses::hand_by_hand};
    int asked = 0;
    options.stop = [&] { return ++asked > 1'000'000; };
    const std::size_t rows = metrics_of_range(scene, task, 7, trace, 0, 2, options).size();
    EXPECT_GT(rows, 0U);
    const int whole = asked;
    EXPECT_GT(whole, 4) << "asked in each pass";
    for (int until = 0; until < whole; ++until) {
        asked = 0;
        options.stop = [&] { return asked++ == until; };
        EXPECT_TRUE(metrics_of_range(scene, task, 7, trace, 0, 2, options).empty()) << until;
        EXPECT_EQ(asked, until + 1) << "and nothing more is computed";
    }
}

}  // namespace
}  // namespace fulcrum
