// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles prepared for the graphics pipeline: vertices split where one vertex needs several texture
// coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum::ui {

/// A run of indices, [first, last).
struct IndexRange {
    std::size_t first = 0, last = 0;
};

/// Neighbouring triangles that are drawn or left out together, finely or coarsely. Coarse triangles use every
/// second vertex; towards a fine neighbour they are stitched, so that no gap opens between the two.
struct SurfaceBand {
    IndexRange fine;
    IndexRange coarse;  ///< without its first and last strip; empty: always fine
    IndexRange first_plain, first_stitched, last_plain, last_stitched;
};

/// Vertices 0 .. base - 1 are the mesh's own; vertex base + i copies vertex source[i] with other coordinates.
struct SurfaceMesh {
    std::uint32_t base = 0;
    std::vector<std::uint32_t> source;
    std::vector<std::uint32_t> indices;  ///< three a triangle
    std::vector<SurfaceBand> bands;      ///< in order along the surface; together all of it
    double coarse_edge = 0;              ///< m, of a coarse triangle at rest; 0: there is none
    std::vector<float> coordinates;      ///< two a vertex
    std::size_t vertices() const { return base + source.size(); }
};

/// The mesh with its own coordinates. Triangles across the seam of u (0 .. 1 once around) get copies at u +
/// 1; a pole, where u has no value, gets a copy for each of its triangles. A tube of rows between two poles
/// (as make_cavity and make_bowel lay them out) also gets its coarse triangles.
SurfaceMesh make_surface(const TriangleMesh& mesh);

/// The bowel's: the serosa's tile is two circumferences long. domes: of a tube along x at rest; its ends wear
/// the tile flat, which going round would draw together in a point.
SurfaceMesh make_bowel_surface(const TriangleMesh& mesh, bool domes);

/// Adds to `chosen` what is to be drawn when fine[band] says which bands are fine and seen[band] which show
/// at all; bands in that order.
void choose_triangles(const SurfaceMesh& surface, const std::vector<std::size_t>& order,
                      const std::vector<char>& fine, std::vector<std::uint32_t>& chosen);

/// Normals of a mesh, three floats a vertex.
std::vector<float> float_normals(const TriangleMesh& mesh);
std::vector<float> float_positions(const TriangleMesh& mesh);

}  // namespace fulcrum::ui
