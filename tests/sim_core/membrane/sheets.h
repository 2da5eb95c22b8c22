// SPDX-License-Identifier: Apache-2.0
// Sheets that the membrane's tests share.
#pragma once

#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::test {

/// rows x columns vertices over width (x) and height (y), z = 0; diagonals alternate.
inline TriangleMesh sheet(int columns, int rows, double width = 0.1, double height = 0.1) {
    TriangleMesh mesh;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c)
            mesh.vertices.emplace_back(width * c / (columns - 1), height * r / (rows - 1), 0);
    }
    for (int r = 0; r + 1 < rows; ++r) {
        for (int c = 0; c + 1 < columns; ++c) {
            const int a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            if ((r + c) % 2 == 0) {
                mesh.triangles.push_back({a, b, e});
                mesh.triangles.push_back({a, e, d});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, e, d});
            }
        }
    }
    return mesh;
}

inline void shake(std::vector<Vector3>& vectors, double size, std::uint64_t seed) {
    Random random(seed);
    for (Vector3& v : vectors) v += size * Vector3(random.normal(), random.normal(), random.normal());
}

}  // namespace fulcrum::test
