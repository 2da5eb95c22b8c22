// SPDX-License-Identifier: Apache-2.0
#include "sim_core/membrane/springs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double straight_enough = 0.766;  // cosine of 40 degrees

using Pair = std::pair<std::int32_t, std::int32_t>;
Pair ordered(std::int32_t a, std::int32_t b) {
    return a < b ? Pair{a, b} : Pair{b, a};
}

void check(const TriangleMesh& mesh) {
    for (const Vector3& vertex : mesh.vertices) {
        if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > 1e6)
            throw InputError("membrane", "vertices", "a vertex is not finite or exceeds 1e6 m",
                             "correct the mesh; its unit is the metre");
    }
    const auto count = static_cast<std::int32_t>(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        for (const std::int32_t v : t) {
            if (v < 0 || v >= count)
                throw InputError("membrane", "triangles", "a triangle uses a vertex that does not exist",
                                 "correct the mesh");
        }
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            throw InputError("membrane", "triangles", "a triangle uses a vertex twice",
                             "remove the triangle");
    }
    if (mesh.triangles.empty())
        throw InputError("membrane", "triangles", "the mesh has no triangle", "give at least one triangle");
}

// Mean over the triangles of each edge.
std::map<Pair, double> edge_zones(const TriangleMesh& mesh, const std::vector<double>& zones) {
    if (zones.size() != mesh.triangles.size())
        throw InputError("membrane", "zones", "the number of zones differs from the number of triangles",
                         "give one zone per triangle or none");
    std::map<Pair, std::pair<double, int>> sums;
    for (std::size_t t = 0; t < zones.size(); ++t) {
        if (!(zones[t] > 0 && zones[t] <= 1e6))
            throw InputError("membrane", "zones", "a zone is not above 0",
                             "give positive factors of the stiffness");
        for (std::size_t e = 0; e < 3; ++e) {
            auto& sum = sums[ordered(mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3])];
            sum.first += zones[t];
            ++sum.second;
        }
    }
    std::map<Pair, double> means;
    for (const auto& [edge, sum] : sums) means[edge] = sum.first / sum.second;
    return means;
}

}  // namespace

std::vector<MembraneSpring> derive_springs(const TriangleMesh& mesh, const MembraneMaterial& material) {
    check(mesh);
    // Opposite vertices of each edge; the map keeps the order the same on every machine.
    std::map<Pair, std::vector<std::int32_t>> opposite;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t e = 0; e < 3; ++e) opposite[ordered(t[e], t[(e + 1) % 3])].push_back(t[(e + 2) % 3]);
    }
    std::map<Pair, MembraneSpring> springs;
    const auto at = [&](std::int32_t v) -> const Vector3& {
        return mesh.vertices[static_cast<std::size_t>(v)];
    };
    const auto add = [&](std::int32_t a, std::int32_t b, SpringKind kind,
                         std::array<std::int32_t, 2> between) {
        if (a == b) return;
        const Pair pair = ordered(a, b);
        MembraneSpring spring;
        spring.first = pair.first;
        spring.second = pair.second;
        spring.kind = kind;
        spring.between = between;
        spring.stiffness = kind == SpringKind::structural ? material.structural_stiffness
                           : kind == SpringKind::shear    ? material.shear_stiffness
                                                          : material.bend_stiffness;
        spring.rest_length = (at(a) - at(b)).norm() / (1 + material.pre_strain);
        springs.emplace(pair, spring);
    };
    for (const auto& [edge, others] : opposite)
        add(edge.first, edge.second, SpringKind::structural, {-1, -1});
    for (const auto& [edge, others] : opposite) {
        if (others.size() >= 2) add(others[0], others[1], SpringKind::shear, {edge.first, edge.second});
    }
    std::vector<std::vector<std::int32_t>> ring(mesh.vertices.size());
    for (const auto& [edge, others] : opposite) {
        ring[static_cast<std::size_t>(edge.first)].push_back(edge.second);
        ring[static_cast<std::size_t>(edge.second)].push_back(edge.first);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (const std::int32_t j : ring[i]) {
            const Vector3 along = at(j) - mesh.vertices[i];
            std::int32_t best = -1;
            double best_cosine = straight_enough;
            for (const std::int32_t k : ring[static_cast<std::size_t>(j)]) {
                const Vector3 on = at(k) - at(j);
                const double size = along.norm() * on.norm();
                const double cosine = size > 0 ? along.dot(on) / size : 0;
                if (k != static_cast<std::int32_t>(i) && cosine > best_cosine) {
                    best_cosine = cosine;
                    best = k;
                }
            }
            if (best >= 0) add(static_cast<std::int32_t>(i), best, SpringKind::bend, {j, -1});
        }
    }
    if (!material.zones.empty()) {
        const std::map<Pair, double> zone = edge_zones(mesh, material.zones);
        for (auto& [pair, spring] : springs) {
            if (spring.kind == SpringKind::structural) spring.stiffness *= zone.at(pair);
            if (spring.kind == SpringKind::shear)
                spring.stiffness *= zone.at(ordered(spring.between[0], spring.between[1]));
            if (spring.kind == SpringKind::bend) {
                const std::int32_t middle = spring.between[0];
                spring.stiffness *=
                    0.5 * (zone.at(ordered(spring.first, middle)) + zone.at(ordered(middle, spring.second)));
            }
        }
    }
    std::vector<MembraneSpring> result;
    result.reserve(springs.size());
    for (const auto& [pair, spring] : springs) {
        if (spring.stiffness > 0) result.push_back(spring);
    }
    return result;
}

std::vector<double> lumped_masses(const TriangleMesh& mesh, double mass) {
    std::vector<double> area(mesh.vertices.size(), 0.0);
    double total = 0;
    for (const Triangle& t : mesh.triangles) {
        const double third = triangle_area(mesh.vertices[static_cast<std::size_t>(t[0])],
                                           mesh.vertices[static_cast<std::size_t>(t[1])],
                                           mesh.vertices[static_cast<std::size_t>(t[2])]) /
                             3;
        for (const std::int32_t v : t) area[static_cast<std::size_t>(v)] += third;
        total += 3 * third;
    }
    const double least = total > 0 ? 0.01 * total / static_cast<double>(area.size()) : 1.0;
    double sum = 0;
    for (double& a : area) sum += a = std::max(a, least);
    for (double& a : area) a *= mass / sum;
    return area;
}

}  // namespace fulcrum
