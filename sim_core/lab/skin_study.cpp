// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/skin_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_core/bowel/mean_value.h"
#include "sim_core/bowel/ring_windows.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {
namespace {

double microseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

// Ring of a vertex under one interpretation of the file's order; -1 for a cap centre.
struct Reading {
    int first, per_ring, rings;  // number of the first ring vertex
    int ring_of(std::int32_t vertex) const {
        const int place = vertex - first;
        return place < 0 || place >= per_ring * rings ? -1 : place / per_ring;
    }
};

bool has_edge(const MeshAdjacency& adjacency, std::int32_t a, std::int32_t b) {
    const auto around = adjacency.neighbours_of(a);
    return std::find(around.begin(), around.end(), b) != around.end();
}

bool fits(const TriangleMesh& cage, const MeshAdjacency& adjacency, const Reading& reading) {
    for (int r = 0; r < reading.rings; ++r) {
        const int start = reading.first + r * reading.per_ring;
        for (int k = 0; k < reading.per_ring; ++k) {
            if (!has_edge(adjacency, start + k, start + (k + 1) % reading.per_ring)) return false;
        }
    }
    for (const auto& triangle : cage.triangles) {
        int low = reading.rings, high = -1;
        bool cap = false;
        for (const auto v : triangle) {
            const int ring = reading.ring_of(v);
            cap = cap || ring < 0;
            if (ring < 0) continue;
            low = std::min(low, ring);
            high = std::max(high, ring);
        }
        const bool at_end = low == high && (low == 0 || low == reading.rings - 1);
        if (cap ? !at_end : (high - low > 1 || (low == high && !at_end))) return false;
    }
    return true;
}

RingLayout layout_of(const TriangleMesh& cage, const Reading& reading) {
    RingLayout layout;
    layout.per_ring = reading.per_ring;
    const auto at = [&](int r, int k) -> const Vector3& {
        return cage
            .vertices[static_cast<std::size_t>(reading.first + r * reading.per_ring + k % reading.per_ring)];
    };
    Vector3 centre[2] = {Vector3::Zero(), Vector3::Zero()}, area = Vector3::Zero();
    for (int r = 0; r < 2; ++r) {
        for (int k = 0; k < reading.per_ring; ++k) centre[r] += at(r, k) / reading.per_ring;
    }
    for (int k = 0; k < reading.per_ring; ++k) area += (at(0, k) - centre[0]).cross(at(0, k + 1) - centre[0]);
    const bool reversed = area.dot(centre[1] - centre[0]) < 0.0;
    for (int r = 0; r < reading.rings; ++r) {
        for (int k = 0; k < reading.per_ring; ++k) {
            const int place = reversed ? reading.per_ring - 1 - k : k;
            layout.ring_vertices.push_back(reading.first + r * reading.per_ring + place);
        }
    }
    return layout;
}

// One vertex's weights on cage vertices.
struct Row {
    std::vector<std::int32_t> vertex;
    std::vector<double> weight;
};

std::vector<Row> bind_global(const TriangleMesh& cage, const TriangleMesh& rest) {
    std::vector<Row> rows;
    MeanValueScratch scratch;
    const CageTopology topology(cage.triangles);
    std::vector<std::int32_t> all(cage.vertices.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
    for (const auto& point : rest.vertices) {
        Row row{all, std::vector<double>(all.size())};
        mean_value_weights(cage.vertices, topology, point, scratch, row.weight.data());
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<Row> bind_local(const TriangleMesh& cage, const RingLayout& layout, const TriangleMesh& rest) {
    std::vector<Vector3> ring_points;
    for (const auto v : layout.ring_vertices)
        ring_points.push_back(cage.vertices[static_cast<std::size_t>(v)]);
    RingWindows windows(std::move(ring_points), layout.per_ring, 1);
    std::vector<Row> rows;
    WindowWeights weights;
    for (const auto& point : rest.vertices) {
        windows.weights(windows.gap_of(point), point, weights);
        Row row;
        const auto first = layout.ring_vertices.begin() + weights.first * layout.per_ring;
        row.vertex.assign(first, first + static_cast<std::ptrdiff_t>(weights.weight.size()));
        row.weight = weights.weight;
        rows.push_back(std::move(row));
    }
    return rows;
}

Vector3 carry(const Row& row, const std::vector<Vector3>& cage) {
    Vector3 position = Vector3::Zero();
    for (std::size_t i = 0; i < row.weight.size(); ++i) {
        position += row.weight[i] * cage[static_cast<std::size_t>(row.vertex[i])];
    }
    return position;
}

}  // namespace

std::optional<RingLayout> find_rings(const TriangleMesh& cage) {
    const int count = static_cast<int>(cage.vertices.size());
    const MeshAdjacency adjacency = build_adjacency(cage);
    for (const int centres : {2, 0}) {
        for (const int first : {0, 1}) {
            if (centres == 0 && first == 1) continue;
            for (int per_ring = 3; 2 * per_ring <= count - centres; ++per_ring) {
                if ((count - centres) % per_ring != 0) continue;
                const Reading reading{first, per_ring, (count - centres) / per_ring};
                if (fits(cage, adjacency, reading)) return layout_of(cage, reading);
            }
        }
    }
    return std::nullopt;
}

nlohmann::json run_skin_study(const JsonDocument& study) {
    const TriangleMesh cage = mesh_of(study, "cage");
    const TriangleMesh rest = mesh_of(study, "rest");
    const TriangleMesh deformed = mesh_of(study, "deformed_cage");
    const std::string scope = study.root().contains("scope") ? text_of(study, "scope") : "local";
    const MeshReport report = check_mesh(cage);
    if (!report.watertight())
        study.fail("/cage", "the cage is not closed: " + report.complaint(), "give a closed cage");
    if (deformed.vertices.size() != cage.vertices.size()) {
        study.fail("/deformed_cage", "the deformed cage and the cage differ in their number of vertices",
                   "give the same vertices, moved");
    }
    if (scope != "global" && scope != "local")
        study.fail("/scope", "unknown scope", "give \"global\" or \"local\"");

    const auto bind_begin = std::chrono::steady_clock::now();
    std::vector<Row> rows;
    if (scope == "global") {
        rows = bind_global(cage, rest);
    } else {
        const auto layout = find_rings(cage);
        if (!layout) {
            study.fail("/cage", "the vertices of the cage do not form rings",
                       "write them ring by ring, cap centres last, or use the global scope");
        }
        rows = bind_local(cage, *layout, rest);
    }
    const double bind_us = microseconds_since(bind_begin);

    double sum_error = 0.0, linear_error = 0.0;
    for (std::size_t v = 0; v < rows.size(); ++v) {
        double sum = 0.0;
        for (const double w : rows[v].weight) sum += w;
        if (!std::isfinite(sum)) {
            study.fail("/rest", "vertex " + std::to_string(v) + " has no weights in this cage",
                       "put the mesh inside the cage");
        }
        sum_error = std::max(sum_error, std::abs(sum - 1.0));
        linear_error = std::max(linear_error, (carry(rows[v], cage.vertices) - rest.vertices[v]).norm());
    }
    std::vector<Vector3> positions(rows.size());
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t v = 0; v < rows.size(); ++v) positions[v] = carry(rows[v], deformed.vertices);
    const double time_us = microseconds_since(begin);

    nlohmann::json result;
    result["vertices"] = nlohmann::json::array();
    for (const auto& p : positions) result["vertices"].push_back({p.x(), p.y(), p.z()});
    result["weights_sum_error"] = sum_error;
    result["linear_error_m"] = linear_error;
    result["time_us"] = time_us;
    result["bind_us"] = bind_us;
    return result;
}

}  // namespace fulcrum::lab
