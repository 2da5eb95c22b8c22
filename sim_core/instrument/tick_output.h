// SPDX-License-Identifier: Apache-2.0
// Output of one haptic tick: the sample for the record and the contact report for the world.
#pragma once

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

/// One hand's contact as reported to the world; fixed size, crosses the input ring.
struct ContactReport {
    ToolKinematics tool;
    std::int32_t vertex = -1;  ///< surface vertex of the contact
    bool slipping = false;     ///< the traction exceeds what the jaws can hold
};

struct TickOutput {
    RigSample input;
    TickSample sample;
    ContactReport contact[hand_count];
    Vector3 device_force[hand_count] = {Vector3::Zero(), Vector3::Zero()};  ///< N, on the hand, after safety
};

}  // namespace fulcrum
