// SPDX-License-Identifier: Apache-2.0
// Output of one haptic tick: the sample for the record and the contact report for the world.
#pragma once

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/instrument/proxy_pose.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

/// One hand's contact as reported to the world; fixed size, crosses the input ring.
struct ContactReport {
    ToolKinematics tool;
    std::int32_t vertex = -1;  ///< surface vertex of the contact
    TouchList touches;         ///< how deep the instrument is in what it touches
    bool slipping = false;     ///< the traction exceeds what the jaws can hold
};

/// Eq. 8 began to reduce what a hand feels in this tick (event stability_limited).
struct StabilityLimit {
    bool limited = false;
    float stiffness = 0;  ///< N/m, rendered at the hand afterwards
};

struct TickOutput {
    RigSample input;
    TickSample sample;
    ContactReport contact[hand_count];
    Vector3 device_force[hand_count] = {Vector3::Zero(), Vector3::Zero()};  ///< N, on the hand, after safety
    double device_torque[hand_count] = {0, 0};  ///< N m about the shaft, on the hand, after safety
    StabilityLimit limited[hand_count];
};

}  // namespace fulcrum
