// SPDX-License-Identifier: Apache-2.0
// Copies scene keys that the schema has checked; an absent key keeps its default.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/fibre_spec.h"

namespace fulcrum::scene_json {

constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

template <typename T>
void copy(const nlohmann::json& node, const char* key, T& value) {
    if (node.contains(key)) value = node.at(key).get<T>();
}
inline void copy(const nlohmann::json& node, const char* key, Vector3& value) {
    if (!node.contains(key)) return;
    for (int i = 0; i < 3; ++i) value[i] = node.at(key).at(static_cast<std::size_t>(i)).get<double>();
}
inline void copy(const nlohmann::json& node, const char* key, std::optional<FibreSpec>& value) {
    if (!node.contains(key)) return;
    value = FibreSpec();
    copy(node.at(key), "strength_n_m", value->strength);
    copy(node.at(key), "speed_m_s", value->speed);
}
inline void copy_degrees(const nlohmann::json& node, const char* key, double& radians) {
    if (node.contains(key)) radians = node.at(key).get<double>() * radians_per_degree;
}

}  // namespace fulcrum::scene_json
