// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/reference_cavity.h"

#include <map>
#include <utility>

#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {

TriangleMesh make_bowl(const Vector3& half_axes, int level, double bump) {
    const double golden = 1.618033988749895;
    std::vector<Vector3> unit;
    for (const double one : {-1.0, 1.0}) {
        for (const double other : {-golden, golden}) {
            unit.emplace_back(0, one, other);
            unit.emplace_back(one, other, 0);
            unit.emplace_back(other, 0, one);
        }
    }
    std::vector<Triangle> triangles;
    // The faces of an icosahedron are the triples of vertices at edge length 2 from each other.
    const auto count = static_cast<std::int32_t>(unit.size());
    const auto joined = [&](std::int32_t i, std::int32_t j) {
        return (unit[static_cast<std::size_t>(i)] - unit[static_cast<std::size_t>(j)]).norm() < 2.01;
    };
    for (std::int32_t i = 0; i < count; ++i) {
        for (std::int32_t j = i + 1; j < count; ++j) {
            for (std::int32_t k = j + 1; k < count; ++k) {
                if (!joined(i, j) || !joined(j, k) || !joined(i, k)) continue;
                const Vector3& a = unit[static_cast<std::size_t>(i)];
                const Vector3& b = unit[static_cast<std::size_t>(j)];
                const Vector3& c = unit[static_cast<std::size_t>(k)];
                const bool outward = (b - a).cross(c - a).dot(a + b + c) > 0;
                triangles.push_back(outward ? Triangle{i, j, k} : Triangle{i, k, j});
            }
        }
    }
    for (Vector3& vertex : unit) vertex.normalize();
    for (int split = 0; split < level; ++split) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t i, std::int32_t j) {
            const auto [place, added] =
                middles.try_emplace(std::minmax(i, j), static_cast<std::int32_t>(unit.size()));
            if (added) {
                unit.push_back(
                    (unit[static_cast<std::size_t>(i)] + unit[static_cast<std::size_t>(j)]).normalized());
            }
            return place->second;
        };
        std::vector<Triangle> finer;
        finer.reserve(4 * triangles.size());
        for (const Triangle& t : triangles) {
            const std::int32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
            finer.push_back({t[0], ab, ca});
            finer.push_back({t[1], bc, ab});
            finer.push_back({t[2], ca, bc});
            finer.push_back({ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    TriangleMesh mesh;
    mesh.triangles = std::move(triangles);
    mesh.vertices.reserve(unit.size());
    for (const Vector3& direction : unit) {
        const double wave =
            math::sin(9 * direction.x() + 1) * math::sin(8 * direction.y()) * math::cos(7 * direction.z());
        mesh.vertices.push_back((1.0 + bump * wave) * half_axes.cwiseProduct(direction));
    }
    return mesh;
}

std::vector<Vector3> coil(int count, double spacing, double radius, double width, double phase) {
    std::vector<Vector3> centres;
    centres.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        double sine = 0, cosine = 1;
        math::sin_cos((i * spacing + phase) / radius, sine, cosine);
        centres.emplace_back(width * (static_cast<double>(i) / count - 0.5), radius * cosine, radius * sine);
    }
    return centres;
}

}  // namespace fulcrum::lab
