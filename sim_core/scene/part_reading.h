// SPDX-License-Identifier: Apache-2.0
// What the reader of a part gets, and the readers of all parts (scene_parts.inc).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// A scene file while its parts are read: everything but parts and fidelity is in `scene` already, and so are
/// the parts before.
struct PartReading {
    const JsonDocument& document;
    Scene& scene;
    /// Throws InputError where the scene has no tissue of this label; `place` is the pointer of the part.
    void check_tissue(const std::string& place, const std::string& label) const;
};

// Each is called where the file has its part, with the part's node, and fills the member of the scene. The
// schema has checked types and ranges; inconsistent values are an InputError with place and hint.
#define SCENE_PART(type, name) void read_##name(const PartReading& reading, const nlohmann::json& node);
#include "sim_core/scene/scene_parts.inc"

}  // namespace fulcrum
