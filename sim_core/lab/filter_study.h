// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` with "model": "filter": the force filter on a given mesh (docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// {"model": "filter", "mesh", "vertex", "force_n", "sigma_m", "grade": "auto|0|1|2", "tip_box_m",
/// "tip_rotation"} gives
/// {"grade", "contact_area_m2", "local_triangle_area_m2", "sigma_m", "forces": [{"vertex", "force_n"}]},
/// vertices ascending. A fixed grade has no blending. Throws InputError.
nlohmann::json run_filter_study(const JsonDocument& study);

}  // namespace fulcrum::lab
