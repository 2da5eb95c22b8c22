// SPDX-License-Identifier: Apache-2.0
// The part "structures" of a scene file.
#pragma once

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/structures_spec.h"

namespace fulcrum {

/// The schema has checked types and ranges. Throws InputError with place and hint for inconsistent values;
/// the caller checks tissue labels.
StructuresSpec read_structures_spec(const JsonDocument& document, const nlohmann::json& node);

}  // namespace fulcrum
