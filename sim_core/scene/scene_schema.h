// SPDX-License-Identifier: Apache-2.0
// The schema of scene files: what all scenes have (assets/schemas/scene/common.json) and a property for each
// part (NAME.json there), put together. assets/schemas/scene.schema.json is the same for other programs.
#pragma once

#include <string>

namespace fulcrum {

const std::string& scene_schema();

}  // namespace fulcrum
