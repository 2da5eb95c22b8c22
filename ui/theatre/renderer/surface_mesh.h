// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles prepared for the graphics pipeline: vertices split where one vertex needs several texture
// coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum::ui {

/// Vertices 0 .. base - 1 are the mesh's own; vertex base + i copies vertex source[i] with other coordinates.
struct SurfaceMesh {
    std::uint32_t base = 0;
    std::vector<std::uint32_t> source;
    std::vector<std::uint32_t> indices;  ///< three a triangle
    std::size_t blended_from = 0;    ///< first index of the triangles that need three planes (split_by_plane)
    std::vector<float> coordinates;  ///< two a vertex
    std::size_t vertices() const { return base + source.size(); }
};

/// The mesh with its own coordinates; triangles across the seam of u (0 .. 1 once around) get copies at u
/// + 1.
SurfaceMesh split_seam(const TriangleMesh& mesh);

/// Coordinates projected along the axis that a triangle faces, in tiles of `tile` metres. Triangles that face
/// no axis clearly come last, to be drawn with all three planes: the border between two projections never
/// shows.
SurfaceMesh split_by_plane(const TriangleMesh& mesh, double tile);

/// Normals of a mesh, three floats a vertex.
std::vector<float> float_normals(const TriangleMesh& mesh);
std::vector<float> float_positions(const TriangleMesh& mesh);

}  // namespace fulcrum::ui
