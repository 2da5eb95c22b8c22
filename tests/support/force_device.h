// SPDX-License-Identifier: Apache-2.0
// Devices with force for tests of the haptic loop.
#pragma once

#include "sim_core/instrument/device.h"

namespace fulcrum::test {

/// Renders every force up to the scene's limit and any stiffness.
inline ForceOutput ideal_device() {
    ForceOutput device;
    device.damping = 1e7;
    device.stiffness = 1e12;
    return device;
}

/// As one on a desk: damping b 0.5 N s/m, 3.3 N for a moment and 0.88 N for long.
inline ForceOutput desk_device() {
    ForceOutput device;
    device.damping = 0.5;
    device.peak = 3.3;
    device.continuous = 0.88;
    return device;
}

}  // namespace fulcrum::test
