// SPDX-License-Identifier: Apache-2.0
// What one haptic tick leaves behind: the record's sample and what the world must know of the contact.
#pragma once

#include "sim_core/haptics/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum {

/// One hand's contact as the world needs it; fixed size, crosses the input ring.
struct ContactReport {
    ToolKinematics tool;
    std::int32_t vertex = -1;  ///< surface vertex of the contact
    bool slipping = false;     ///< the jaws cannot hold what they pull
};

struct TickOutput {
    RigSample input;
    TickSample sample;
    ContactReport contact[hand_count];
    Vector3 device_force[hand_count] = {Vector3::Zero(), Vector3::Zero()};  ///< N, on the hand, after safety
};

}  // namespace fulcrum
