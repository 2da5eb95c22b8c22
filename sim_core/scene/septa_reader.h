// SPDX-License-Identifier: Apache-2.0
// Reads and checks a scene's `presacral` and `septa`.
#pragma once

#include "sim_core/scene/json_document.h"
#include "sim_core/scene/septa_spec.h"

namespace fulcrum {

/// node: the object at "/presacral", checked against the schema. Throws InputError.
/// length: m, of the rectum.
PresacralSpec read_presacral_spec(const JsonDocument& document, const nlohmann::json& node, double length);
/// node: the object at "/septa". length: m, of the rectum; radius: m, of its muscularis. Throws InputError.
SeptaSpec read_septa_spec(const JsonDocument& document, const nlohmann::json& node,
                          const PresacralSpec& presacral, double length, double radius);

}  // namespace fulcrum
