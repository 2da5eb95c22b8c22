// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run`: a single model with given input and its full result.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace fulcrum {
class JsonDocument;
}

namespace fulcrum::lab {

/// A model that a study file can name, its keys in addition to "model", and what runs it.
struct Study {
    const char* model;
    nlohmann::json (*run)(const JsonDocument& study);
    std::vector<const char*> keys;
};

/// Reads a study file, runs its model, returns the result document of docs/FORMATS.md. Throws InputError with
/// file, JSON pointer and hint. `more`: models in addition to those of this room.
nlohmann::json run_study(const std::string& path, const std::vector<Study>& more = {});

}  // namespace fulcrum::lab
