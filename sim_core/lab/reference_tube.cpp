// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/reference_tube.h"

#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {
constexpr double pi = 3.14159265358979323846;
}

TriangleMesh make_tube(double length, int sections, int around, const TubeRadius& radius) {
    TriangleMesh mesh;
    for (int i = 0; i <= sections; ++i) {
        const double x = length * i / sections;
        for (int k = 0; k < around; ++k) {
            // Each circle is rotated by half a step relative to the last: near-equilateral triangles.
            const double angle = 2.0 * pi * (k + 0.5 * (i % 2)) / around;
            const double r = radius(x, angle);
            mesh.vertices.emplace_back(x, r * math::cos(angle), r * math::sin(angle));
        }
    }
    const auto start = static_cast<std::int32_t>(mesh.vertices.size()), end = start + 1;
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    mesh.vertices.emplace_back(length, 0.0, 0.0);
    for (int i = 0; i < sections; ++i) {
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            const int a = i * around + k, b = i * around + next, c = (i + 1) * around + next,
                      d = (i + 1) * around + k;
            if (i % 2 == 0) {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, c, d});
            } else {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            }
        }
    }
    const int last = sections * around;
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around;
        mesh.triangles.push_back({start, next, k});
        mesh.triangles.push_back({end, last + k, last + next});
    }
    return mesh;
}

TubeRadius plain_radius(double radius) {
    return [radius](double, double) { return radius; };
}

TubeRadius haustral_radius(double mean) {
    return [mean](double x, double angle) {
        const double bulge = std::abs(math::sin(pi * x / 0.030));
        return mean * (1.0 + 0.12 * (bulge - 0.64) * (1.0 - 0.4 * math::cos(3.0 * angle)) +
                       0.02 * math::cos(3.0 * angle));
    };
}

}  // namespace fulcrum::lab
