// SPDX-License-Identifier: GPL-3.0-or-later
// A documented trace as hands: tip positions, roll and jaw force become what a device would have said.
#pragma once

#include <string>
#include <vector>

#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"

namespace fulcrum::app {

/// Resampled to the scene's tick rate; a hand that the file does not describe rests at its start. Throws
/// InputError.
std::vector<RigSample> inputs_from_csv(const std::string& path, const Scene& scene);

}  // namespace fulcrum::app
