// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run`: one model alone on given input, its full result.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fulcrum::lab {

/// Reads a study file, runs the model it names, returns the result document of docs/FORMATS.md. Throws
/// InputError with file, JSON pointer and hint.
nlohmann::json run_study(const std::string& path);

}  // namespace fulcrum::lab
