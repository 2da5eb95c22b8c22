// SPDX-License-Identifier: Apache-2.0
// The part "camera_targets" of a scene file.
#pragma once

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Adds the part to a scene whose other parts are read, if the file has it. The schema has checked types and
/// ranges. Throws InputError with place and hint for inconsistent values, and for a scene that has neither
/// instruments nor this part.
void read_camera_targets(const JsonDocument& document, Scene& scene);

}  // namespace fulcrum
