// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/filter_study.h"

#include <map>
#include <nlohmann/json.hpp>

#include "sim_core/bowel/force_filter.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {
namespace {

FilterMode mode_of(const JsonDocument& study) {
    const auto& root = study.root();
    const nlohmann::json value = root.contains("grade") ? root["grade"] : nlohmann::json("auto");
    if (value == "auto") return FilterMode::adaptive;
    if (value == "0" || value == 0) return FilterMode::grade_0;
    if (value == "1" || value == 1) return FilterMode::grade_1;
    if (value == "2" || value == 2) return FilterMode::grade_2;
    study.fail("/grade", "unknown grade", "give \"auto\", \"0\", \"1\" or \"2\"");
}

TipBox tip_of(const JsonDocument& study) {
    TipBox tip;
    const auto edges = numbers_of(study, "tip_box_m", 3, {tip.edges[0], tip.edges[1], tip.edges[2]}, 1.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(edges[i] >= 0.0))
            study.fail("/tip_box_m", "an edge is negative", "give the three edges in metres");
        tip.edges[static_cast<int>(i)] = edges[i];
    }
    const auto rotation = numbers_of(study, "tip_rotation", 4, {1.0, 0.0, 0.0, 0.0}, 1e6);
    const Quaternion quaternion(rotation[0], rotation[1], rotation[2], rotation[3]);
    if (!(quaternion.norm() > 1e-9))
        study.fail("/tip_rotation", "the quaternion is zero", "give [w, x, y, z]");
    tip.axes = quaternion.normalized().toRotationMatrix();
    return tip;
}

}  // namespace

nlohmann::json run_filter_study(const JsonDocument& study) {
    const TriangleMesh mesh = mesh_of(study, "mesh");
    const MeshAdjacency adjacency = build_adjacency(mesh);
    const double last = static_cast<double>(mesh.vertices.size()) - 1.0;
    const double vertex_number = number_of(study, "vertex", 0.0, last);
    const auto vertex = static_cast<std::int32_t>(vertex_number);
    if (vertex != vertex_number)
        study.fail("/vertex", "the vertex is not a whole number", "give the number of a vertex, from 0");
    const auto components = numbers_of(study, "force_n", 3, {}, 1e6);
    const Vector3 force(components[0], components[1], components[2]);
    FilterOptions options;
    options.mode = mode_of(study);
    options.sigma = number_of(study, "sigma_m", 0.0, 0.0, 1.0);

    FilteredForce filtered;
    filter_force(view_of(mesh, adjacency), vertex, tip_of(study), options, filtered);
    if (filtered.overflow) {
        study.fail("/vertex",
                   "the contact has more than " + std::to_string(filter_capacity) + " vertices in two rings",
                   "choose a vertex with fewer neighbours");
    }
    std::map<std::int32_t, Vector3> forces;
    for (std::int32_t i = 0; i < filtered.count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        forces[filtered.vertex[n]] = filtered.weight[n] * force;
    }
    nlohmann::json result;
    result["grade"] = filtered.grade;
    result["contact_area_m2"] = filtered.contact_area;
    result["local_triangle_area_m2"] = filtered.local_triangle_area;
    result["sigma_m"] = filtered.sigma;
    result["forces"] = nlohmann::json::array();
    for (const auto& [number, part] : forces) {
        result["forces"].push_back({{"vertex", number}, {"force_n", {part.x(), part.y(), part.z()}}});
    }
    return result;
}

}  // namespace fulcrum::lab
