// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` with "model": "hand": the force at a handle from loads on the instrument beyond its
// trocar (docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// {"model": "hand", "trocar", "cases": [{"handle", "loads": [{"at", "force"}]}]} gives
/// {"cases": [{"hand_force", "shaft_torque_n_m"}]}. Places in m, forces of tissue on the instrument in N,
/// patient frame. Throws InputError.
nlohmann::json run_hand_study(const JsonDocument& study);

}  // namespace fulcrum::lab
