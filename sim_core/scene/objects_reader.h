// SPDX-License-Identifier: Apache-2.0
// The part "objects" of a scene file.
#pragma once

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/objects_spec.h"

namespace fulcrum {

/// The schema has checked types and ranges. Throws InputError with place and hint for inconsistent values;
/// the caller checks tissue labels.
ObjectsSpec read_objects_spec(const JsonDocument& document, const nlohmann::json& node);

}  // namespace fulcrum
