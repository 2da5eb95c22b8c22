// SPDX-License-Identifier: Apache-2.0
// Drives a task's monitor without a world: a test sets what hands and tissue do, tick by tick.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/task/monitor.h"
#include "sim_core/instrument/device.h"
#include "tests/support/support.h"

namespace fulcrum::monitor_bench {

class Events : public EventSink {
  public:
    Events() { list.reserve(4096); }
    void on_event(const Event& event) noexcept override { list.push_back(event); }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(list.begin(), list.end(), [&](const Event& e) { return e.kind == kind; }));
    }
    const Event& first(EventKind kind) const {
        const auto found =
            std::find_if(list.begin(), list.end(), [&](const Event& e) { return e.kind == kind; });
        static const Event none;
        EXPECT_NE(found, list.end()) << event_name(kind);
        return found == list.end() ? none : *found;
    }
    std::vector<Event> list;
};

/// Drives a monitor tick by tick: tips are set in metres, the rest through `sample` and `world`.
struct Bench {
    Scene scene;
    TaskDefinition task;
    TaskMonitor monitor;
    Events events;
    TickSample sample;
    WorldSnapshot world;
    std::vector<TickSample> pending;

    Bench(const std::string& task_file, const std::function<void(Scene&, TaskDefinition&)>& change = {},
          std::uint64_t seed = 1)
        : scene(), task(load(task_file, change, scene)), monitor(task, scene, seed) {
        for (HandSample& hand : sample.hand) hand.flags = hand_inside | hand_in_view;
        if (scene.bowel) {
            const int n = scene.bowel->segments;
            for (int i = 0; i <= n; ++i) {
                const double s = scene.bowel->length * i / n;
                world.bowel.node_arc_lengths.push_back(s);
                world.bowel.nodes.emplace_back(s - 0.45, 0.0, -0.05);
            }
        }
        pending.reserve(8);
    }
    static TaskDefinition load(const std::string& file,
                               const std::function<void(Scene&, TaskDefinition&)>& change, Scene& scene) {
        TaskDefinition task = load_task(test::source_path("assets/tasks/" + file));
        scene = load_scene(test::source_path("assets/scenes/" + task.scene));
        if (change) change(scene, task);
        return task;
    }
    void put(Hand hand, const Vector3& tip) {
        for (int i = 0; i < 3; ++i) {
            sample.hand[static_cast<int>(hand)].tip[i] =
                static_cast<std::int32_t>(std::lround(tip[i] / sample_length_unit));
        }
    }
    void force(Hand hand, double newton, int tissue) {
        sample.hand[static_cast<int>(hand)].force[2] = static_cast<std::int32_t>(std::lround(-newton * 1000));
        sample.hand[static_cast<int>(hand)].tissue = static_cast<std::int16_t>(tissue);
    }
    void tick() {
        ++sample.tick;
        pending.push_back(sample);
        if (pending.size() == static_cast<std::size_t>(scene.ticks_per_step)) flush();
    }
    void flush() {
        if (!pending.empty()) monitor.on_step(pending.data(), pending.size(), world, events);
        pending.clear();
    }
    void ticks(int n) {
        for (int i = 0; i < n; ++i) tick();
    }
    /// A straight movement at constant speed.
    void move(Hand hand, const Vector3& from, const Vector3& to, int n) {
        for (int i = 1; i <= n; ++i) {
            put(hand, from + (to - from) * i / n);
            tick();
        }
    }
    void grasp(Hand hand, double arc_length, int patch = 0) {
        GraspState& state = world.grasps[static_cast<int>(hand)];
        state.held = true;
        state.tissue = static_cast<std::int8_t>(scene.tissue_index(scene.bowel   ? scene.bowel->tissue
                                                                   : scene.sheet ? scene.sheet->tissue
                                                                                 : scene.bands->tissue));
        state.slipped = false;
        state.arc_length = arc_length;
        state.patch = patch;
        ticks(scene.ticks_per_step);
    }
    void let_go(Hand hand, bool slipped = false) {
        GraspState& state = world.grasps[static_cast<int>(hand)];
        state.held = false;
        state.slipped = slipped;
        ticks(scene.ticks_per_step);
    }
};

}  // namespace fulcrum::monitor_bench
