// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/device_trial.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "app/live/force_test.h"
#include "app/live/real_time.h"

namespace fulcrum::app {
namespace {

constexpr std::int64_t period = 1'000'000;  // ns
constexpr double us = 1e-3;                 // per ns

struct Histograms {
    DurationHistogram reader_wake, device_wake, pose_age, force_delay;
};

void run(DaemonClient& client, double peak, const std::atomic<bool>& stop, DeviceTrial& trial,
         Histograms& histograms) {
    trial.real_time = raise_priority(80);
    const StatePage& state = client.state();
    ForceCommand command;
    command.sequence = static_cast<std::uint64_t>(monotonic_ns());
    DevicePose before[device_slots];
    Vector3 first_place[device_slots] = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    ForceReport reported[2];
    const std::int64_t begin = monotonic_ns();
    std::int64_t deadline = begin + period;
    const auto device_period = static_cast<std::int64_t>(1e9 / client.facts().rate);
    while (!stop.load(std::memory_order_relaxed)) {
        sleep_until(deadline);
        const std::int64_t now = monotonic_ns();
        histograms.reader_wake.add(static_cast<double>(now - deadline) * us);
        ++trial.reader_ticks;
        if (now - deadline >= period) ++trial.reader_late;
        if (now - deadline >= 20 * period) deadline = now;
        deadline += period;
        for (int i = 0; i < device_slots; ++i) {
            DevicePose& pose = trial.newest[i];
            if (!client.facts().slot[i] || !state.pose[i].read(pose)) continue;
            if (pose.sequence == before[i].sequence) continue;
            if (before[i].sequence != 0 && pose.sequence == before[i].sequence + 1)
                histograms.device_wake.add(
                    static_cast<double>(std::abs(pose.time - before[i].time - device_period)) * us);
            histograms.pose_age.add(static_cast<double>(now - pose.time) * us);
            const Vector3 place(pose.position[0], pose.position[1], pose.position[2]);
            if (pose.present != 0 && place.allFinite()) {
                if (!trial.moved[i]) first_place[i] = place;
                if (!trial.moved[i]) trial.moved[i].emplace();
                trial.moved[i]->add(place - first_place[i]);
            }
            before[i] = pose;
        }
        const GentleForce gentle = gentle_force(static_cast<double>(now - begin) * 1e-9, peak);
        Vector3 force = Vector3::Zero();
        force[gentle.axis] = gentle.size;
        ++command.sequence;
        for (int axis = 0; axis < 3; ++axis) command.force[axis] = force[axis];
        for (int h = 0; h < 2; ++h) {
            if (!client.facts().force[h]) continue;
            ForceReport report;
            if (state.report[h].read(report) && report.command_time > reported[h].command_time) {
                histograms.force_delay.add(static_cast<double>(report.time - report.command_time) * us);
                reported[h] = report;
                trial.force_rendered = std::max(
                    trial.force_rendered, Vector3(report.force[0], report.force[1], report.force[2]).norm());
            }
            command.time = monotonic_ns();
            if (peak > 0) client.command().command[h].write(command);
        }
        trial.force_sent = std::max(trial.force_sent, force.norm());
    }
    trial.seconds = static_cast<double>(monotonic_ns() - begin) * 1e-9;
}

}  // namespace

DeviceTrial try_device(DaemonClient& client, double seconds, double peak_force,
                       const std::function<bool()>& go_on) {
    DeviceTrial trial;
    const auto histograms = std::make_unique<Histograms>();
    LoopReport at_begin, at_end;
    client.state().loop.read(at_begin);
    DevicePose first[device_slots];
    for (int i = 0; i < device_slots; ++i) client.state().pose[i].read(first[i]);
    std::atomic<bool> stop{false};
    std::thread reader([&] { run(client, peak_force, stop, trial, *histograms); });
    const std::int64_t until = monotonic_ns() + static_cast<std::int64_t>(seconds * 1e9);
    while (monotonic_ns() < until && client.poll() != DaemonClient::Health::ended && (!go_on || go_on()))
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop.store(true);
    reader.join();
    client.state().loop.read(at_end);
    trial.device_ticks = at_end.ticks - at_begin.ticks;
    trial.device_late = at_end.late - at_begin.late;
    trial.device_late_own = at_end.late_own - at_begin.late_own;
    for (int i = 0; i < device_slots; ++i) {
        if (client.facts().slot[i])
            trial.readings = std::max(trial.readings, trial.newest[i].sequence - first[i].sequence);
    }
    trial.rate = trial.seconds > 0 ? static_cast<double>(trial.readings) / trial.seconds : 0;
    trial.reader_wake = histograms->reader_wake.read();
    trial.device_wake = histograms->device_wake.read();
    trial.pose_age = histograms->pose_age.read();
    trial.force_delay = histograms->force_delay.read();
    return trial;
}

}  // namespace fulcrum::app
