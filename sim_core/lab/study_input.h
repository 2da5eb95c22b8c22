// SPDX-License-Identifier: Apache-2.0
// Reading a study file's keys: each error names file, line, key and a hint.
#pragma once

#include <string>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// Text at a top-level key; missing or empty is an error.
std::string text_of(const JsonDocument& study, const std::string& key);
/// Finite number within [least, most]; `fallback` if the key is missing.
double number_of(const JsonDocument& study, const std::string& key, double fallback, double least,
                 double most);
/// As number_of, but the key is required.
double number_of(const JsonDocument& study, const std::string& key, double least, double most);
/// Array of `count` finite numbers, each of at most `most` in magnitude; `fallback` if the key is missing
/// (empty: the key is required).
std::vector<double> numbers_of(const JsonDocument& study, const std::string& key, std::size_t count,
                               const std::vector<double>& fallback, double most);
/// Array of `count` finite numbers, each of at most `most` in magnitude; `pointer` is its place in the study.
std::vector<double> numbers_at(const JsonDocument& study, const nlohmann::json& value,
                               const std::string& pointer, std::size_t count, double most);
/// List of vertex numbers, each below `vertices`; none if the key is missing.
std::vector<std::int32_t> vertex_list_of(const JsonDocument& study, const std::string& key,
                                         std::size_t vertices);
/// Mesh file at a key: relative to the study file's folder, else to the working directory.
TriangleMesh mesh_of(const JsonDocument& study, const std::string& key);

}  // namespace fulcrum::lab
