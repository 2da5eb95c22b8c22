// SPDX-License-Identifier: Apache-2.0
// Surfaces to cut, and a blade that follows them.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim_core/cutting/cut_mesh.h"
#include "tests/support/tube.h"

namespace fulcrum::test {

/// Sheet of columns x rows cells of `cell` m in the plane z = 0 from the origin, diagonals in turn.
inline TriangleMesh cut_sheet(int columns, int rows, double cell) {
    TriangleMesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) mesh.vertices.emplace_back(cell * i, cell * j, 0.0);
    const auto at = [columns](int i, int j) { return static_cast<std::int32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if ((i + j) % 2 == 0) {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            } else {
                mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    return mesh;
}

/// Numbers of the vertices on the border of cut_sheet.
inline std::vector<std::int32_t> border_of_sheet(int columns, int rows) {
    std::vector<std::int32_t> border;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            if (i == 0 || j == 0 || i == columns || j == rows)
                border.push_back(static_cast<std::int32_t>(j * (columns + 1) + i));
    return border;
}

/// A mesh with the positions its vertices have now.
struct Surface {
    CutMesh mesh;
    std::vector<Vector3> positions;
    Surface(const TriangleMesh& shape, const std::vector<std::int32_t>& fixed, int steps)
        : Surface(shape, fixed, CutMesh::capacity_for(shape, steps)) {}
    Surface(const TriangleMesh& shape, const std::vector<std::int32_t>& fixed, const CutCapacity& capacity)
        : mesh(shape, fixed, capacity),
          positions(static_cast<std::size_t>(mesh.capacity().vertices), Vector3::Zero()) {
        std::copy(shape.vertices.begin(), shape.vertices.end(), positions.begin());
    }
    /// A straight step at height z = 0 with +z as normal.
    BladeStep step(double x0, double y0, double x1, double y1, double width,
                   BladeEnd start = BladeEnd::square, BladeEnd end = BladeEnd::square) const {
        BladeStep s;
        s.from = Vector3(x0, y0, 0);
        s.to = Vector3(x1, y1, 0);
        s.width = width;
        s.depth = 2 * width;
        s.start = start;
        s.end = end;
        s.root = mesh.nearest_root(0.5 * (s.from + s.to), positions.data());
        return s;
    }
    CutReport cut(const BladeStep& s) { return mesh.cut(s, positions.data()); }
    /// A path in the plane, one step per segment, with round ends.
    int stroke(const std::vector<Eigen::Vector2d>& path, double width) {
        mesh.begin_stroke();
        int cuts = 0;
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
            cuts += cut(step(path[i].x(), path[i].y(), path[i + 1].x(), path[i + 1].y(), width,
                             i == 0 ? BladeEnd::square : BladeEnd::round))
                                .outcome == CutOutcome::cut
                        ? 1
                        : 0;
        return cuts;
    }
    CutCheck check() const { return check_cut(mesh, positions.data()); }
};

}  // namespace fulcrum::test
