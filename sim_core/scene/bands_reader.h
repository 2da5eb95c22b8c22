// SPDX-License-Identifier: Apache-2.0
// The part "bands" of a scene file.
#pragma once

#include "sim_core/scene/bands_spec.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

/// The schema has checked types and ranges. Throws InputError with place and hint for inconsistent values;
/// the caller checks tissue labels.
BandsSpec read_bands_spec(const JsonDocument& document, const nlohmann::json& node);

}  // namespace fulcrum
