// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a device that fulcrum-hapticd drives as a live attempt does, once a millisecond, and measures rate,
// jitter and delays; optionally with a gentle force.
#pragma once

#include <functional>

#include "app/live/histogram.h"
#include "sim_core/devices/daemon_client.h"

namespace fulcrum::app {

struct DeviceTrial {
    double seconds = 0;
    double rate = 0;  ///< Hz, new readings
    std::uint64_t readings = 0;
    std::uint64_t reader_ticks = 0;
    std::uint64_t reader_late = 0;  ///< ticks of the reader that began a period or more late
    std::uint64_t device_ticks = 0, device_late = 0, device_late_own = 0;
    Durations reader_wake;  ///< delay of the reader's ticks: what the program has without the daemon
    Durations device_wake;  ///< difference of two readings from the device's period
    Durations pose_age;     ///< from reading the device to the program's tick that uses it
    Durations force_delay;  ///< from the program's command to the device's tick that renders it
    double force_sent = 0, force_rendered = 0;  ///< N, largest
    DevicePose newest[device_slots];
    std::optional<WorkspaceBox> moved[device_slots];  ///< from the first reading; none: it did not answer
    bool real_time = false;                           ///< of the reader
};

/// `peak_force`: N; the force rises to it over a second along each axis in turn; 0: none is sent. Returns
/// early where `go_on` becomes false or the daemon ends.
DeviceTrial try_device(DaemonClient& client, double seconds, double peak_force,
                       const std::function<bool()>& go_on = {});

}  // namespace fulcrum::app
