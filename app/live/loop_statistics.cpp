// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/loop_statistics.h"

#include <nlohmann/json.hpp>

namespace fulcrum::app {
namespace {

nlohmann::json durations_json(const Durations& d) {
    return {{"p50", d.p50_us}, {"p99", d.p99_us}, {"p99.9", d.p999_us}, {"worst", d.worst_us}};
}

}  // namespace

nlohmann::json statistics_json(const LoopStatistics& statistics) {
    nlohmann::json json = {{"ticks", statistics.ticks},
                           {"missed_by_program", statistics.missed_by_program},
                           {"missed_by_scheduler", statistics.missed_by_scheduler},
                           {"late_steps", statistics.late_steps},
                           {"lost_samples", statistics.lost_samples},
                           {"waits_in_ticks", statistics.waits_in_ticks},
                           {"preemptions_in_ticks", statistics.preemptions_in_ticks},
                           {"page_faults_in_ticks", statistics.page_faults_in_ticks},
                           {"wake_us", durations_json(statistics.wake)},
                           {"tick_us", durations_json(statistics.tick)},
                           {"tick_own_us", durations_json(statistics.own)},
                           {"step_us", durations_json(statistics.step)},
                           {"real_time_priority", statistics.real_time_priority}};
    if (const auto& device = statistics.device)
        json["device"] = {{"pose_age_us", durations_json(device->pose_age)},
                          {"force_delay_us", durations_json(device->force_delay)},
                          {"jitter_us", durations_json(device->jitter)},
                          {"ticks", device->device_ticks},
                          {"late", device->device_late},
                          {"late_own", device->device_late_own},
                          {"real_time_priority", device->real_time_priority}};
    return json;
}

}  // namespace fulcrum::app
