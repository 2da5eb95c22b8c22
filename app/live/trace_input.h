// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a trace in the CSV format of docs/FORMATS.md into the readings of a device.
#pragma once

#include <string>
#include <vector>

#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"

namespace fulcrum::app {

/// Resamples to the scene's tick rate; a hand that is not in the file stays at its start. Throws InputError.
std::vector<RigSample> inputs_from_csv(const std::string& path, const Scene& scene);

}  // namespace fulcrum::app
