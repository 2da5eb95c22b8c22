// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cavity.h"

#include <cmath>

namespace fulcrum::test {
namespace {
constexpr double pi = 3.141592653589793;
}

TriangleMesh make_bowl(const Vector3& half_axes, int rings, int sectors, double bump) {
    TriangleMesh mesh;
    const auto add = [&](double polar, double around) {
        const double scale = 1.0 + bump * std::sin(5 * polar) * std::cos(4 * around);
        const Vector3 direction(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                                std::cos(polar));
        mesh.vertices.push_back(scale * half_axes.cwiseProduct(direction));
    };
    add(0, 0);
    for (int i = 1; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) add(pi * i / rings, 2 * pi * j / sectors);
    }
    add(pi, 0);
    const auto at = [&](int i, int j) { return 1 + (i - 1) * sectors + j % sectors; };
    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    for (int j = 0; j < sectors; ++j) {
        mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
        for (int i = 1; i + 1 < rings; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, j), last, at(rings - 1, j + 1)});
    }
    return mesh;
}

TriangleMesh make_floor(double side, int cells) {
    TriangleMesh mesh;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            mesh.vertices.emplace_back(side * (static_cast<double>(i) / cells - 0.5),
                                       side * (static_cast<double>(j) / cells - 0.5), 0.0);
        }
    }
    const auto at = [&](int i, int j) { return i * (cells + 1) + j; };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

std::vector<Vector3> coiled_centres(int count, double spacing, double phase) {
    // A helix along x whose coils have a radius of 30 mm and a pitch that fills the bowl.
    const double radius = 0.032, turns_per_metre = 1.0 / (2 * pi * radius);
    const double length = count * spacing;
    std::vector<Vector3> centres;
    for (int i = 0; i < count; ++i) {
        const double s = i * spacing + phase;
        const double angle = 2 * pi * turns_per_metre * s;
        centres.emplace_back(0.09 * (i * spacing / length - 0.5), radius * std::cos(angle),
                             radius * std::sin(angle));
    }
    return centres;
}

}  // namespace fulcrum::test
