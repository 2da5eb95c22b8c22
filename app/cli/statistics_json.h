// SPDX-License-Identifier: GPL-3.0-or-later
// Results of the statistics of a curriculum as JSON, one form for commands and studies.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "assessment/learning/learning_curve.h"

namespace fulcrum::app {

/// {"models": [...], "best": name}. Precondition: not empty.
nlohmann::json curves_json(const std::vector<CurveFit>& fits);
/// {"icc": {...}, "cronbach_alpha": x}. `ratings[target][rater]`. Throws std::invalid_argument.
nlohmann::json agreement_json(const std::vector<std::vector<double>>& ratings);

}  // namespace fulcrum::app
