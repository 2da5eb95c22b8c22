// SPDX-License-Identifier: Apache-2.0
// The part "bowel" of a scene file.
#pragma once

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// The schema has checked types and ranges. Throws InputError with place and hint for inconsistent values;
/// the caller checks the tissue's label.
BowelSpec read_bowel_spec(const JsonDocument& document, const nlohmann::json& node);

}  // namespace fulcrum
