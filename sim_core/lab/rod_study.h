// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` for a single rod: a JSON study as input, its full result as output (format in
// docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fulcrum {

/// Runs {"model": "rod", ...}. Throws InputError (file, JSON pointer, what is wrong, hint) on a bad study.
nlohmann::json run_rod_study(const nlohmann::json& study, const std::string& file);

}  // namespace fulcrum
