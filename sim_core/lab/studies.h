// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run`: a single model with given input and its full result.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fulcrum::lab {

/// Reads a study file, runs its model, returns the result document of docs/FORMATS.md. Throws InputError with
/// file, JSON pointer and hint.
nlohmann::json run_study(const std::string& path);

}  // namespace fulcrum::lab
