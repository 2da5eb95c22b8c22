// SPDX-License-Identifier: Apache-2.0
// Triangle mesh used in all rooms, its adjacency, and a view of both for a patch or a whole surface. Lengths
// in m, in the frame of the mesh's owner. Triangles are counterclockwise seen from outside.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

using Triangle = std::array<std::int32_t, 3>;

/// Vertices and triangles; texture coordinates are optional (empty, or one per vertex).
struct TriangleMesh {
    std::vector<Vector3> vertices;    ///< m
    std::vector<Triangle> triangles;  ///< vertex indices, counterclockwise from outside
    std::vector<Eigen::Vector2d> texture_coordinates;
};

/// A range of indices inside a larger array; valid as long as that array.
struct IndexSpan {
    const std::int32_t* first = nullptr;
    std::int32_t count = 0;
    const std::int32_t* begin() const { return first; }
    const std::int32_t* end() const { return first + count; }
    std::int32_t size() const { return count; }
    std::int32_t operator[](std::int32_t i) const { return first[i]; }
};

/// Neighbourhood lists in compressed rows. Edge e of triangle (a, b, c) is ab, bc, ca for e = 0, 1, 2.
struct MeshAdjacency {
    std::vector<std::int32_t> triangle_neighbours;      ///< [3 t + e]: triangle across edge e, -1 at a border
    std::vector<std::int32_t> vertex_triangle_offsets;  ///< vertex_count + 1
    std::vector<std::int32_t> vertex_triangles;         ///< triangles around each vertex, ascending
    std::vector<std::int32_t> vertex_neighbour_offsets;  ///< vertex_count + 1
    std::vector<std::int32_t> vertex_neighbours;         ///< first ring of each vertex, ascending

    IndexSpan triangles_of(std::int32_t vertex) const;
    IndexSpan neighbours_of(std::int32_t vertex) const;
};

/// Builds the adjacency in O(n log n). If more than two triangles share an edge, the first two are kept
/// (check_mesh reports it). Throws InputError if a triangle refers to a vertex that does not exist.
MeshAdjacency build_adjacency(const TriangleMesh& mesh);

/// Non-owning view of the positions and adjacency of a surface or of a patch of one. Cheap to copy; any
/// thread.
struct SurfaceView {
    const Vector3* positions = nullptr;
    std::int32_t vertex_count = 0;
    const Triangle* triangles = nullptr;
    std::int32_t triangle_count = 0;
    const std::int32_t* triangle_neighbours = nullptr;
    const std::int32_t* vertex_triangle_offsets = nullptr;
    const std::int32_t* vertex_triangles = nullptr;
    const std::int32_t* vertex_neighbour_offsets = nullptr;
    const std::int32_t* vertex_neighbours = nullptr;

    IndexSpan triangles_of(std::int32_t vertex) const {
        return {vertex_triangles + vertex_triangle_offsets[vertex],
                vertex_triangle_offsets[vertex + 1] - vertex_triangle_offsets[vertex]};
    }
    IndexSpan neighbours_of(std::int32_t vertex) const {
        return {vertex_neighbours + vertex_neighbour_offsets[vertex],
                vertex_neighbour_offsets[vertex + 1] - vertex_neighbour_offsets[vertex]};
    }
    /// Triangle across edge e (0: ab, 1: bc, 2: ca), -1 at a border.
    std::int32_t neighbour(std::int32_t triangle, int edge) const {
        return triangle_neighbours[3 * triangle + edge];
    }
};

/// View of a mesh, optionally with other (deformed) positions: one per mesh vertex.
SurfaceView view_of(const TriangleMesh& mesh, const MeshAdjacency& adjacency,
                    const Vector3* positions = nullptr);

/// Twice the area of a triangle times its unit normal.
Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c);
/// Area of a triangle, m2.
double triangle_area(const Vector3& a, const Vector3& b, const Vector3& c);
/// Area-weighted unit normal at a vertex; zero where all triangles around it have no area.
Vector3 vertex_normal(const SurfaceView& surface, std::int32_t vertex);
/// Mean area of the triangles around a vertex, m2 (Eq. 3's a-bar); 0 for an isolated vertex.
double mean_triangle_area(const SurfaceView& surface, std::int32_t vertex);
/// Mean length of the edges that meet at a vertex, m; 0 for an isolated vertex.
double mean_edge_length(const SurfaceView& surface, std::int32_t vertex);
/// Area-weighted unit normals of all vertices.
std::vector<Vector3> vertex_normals(const TriangleMesh& mesh);
/// Volume enclosed by a closed, outward oriented mesh, m3 (divergence theorem).
double enclosed_volume(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles);
/// Total area, m2.
double surface_area(const TriangleMesh& mesh);

/// Result of check_mesh; indices are -1 if there is no bad element.
struct MeshReport {
    bool indices_valid = true;      ///< every triangle has three different, existing vertices
    bool finite = true;             ///< no NaN or infinity
    bool closed = true;             ///< every edge has exactly two triangles
    bool manifold_edges = true;     ///< no edge has more than two
    bool manifold_vertices = true;  ///< the triangles around every vertex form one fan
    bool oriented = true;           ///< neighbours traverse their common edge in opposite directions
    bool no_zero_area = true;       ///< no triangle without area
    bool no_stray_vertex = true;    ///< every vertex belongs to a triangle
    std::int32_t first_bad_triangle = -1;
    std::int32_t first_bad_vertex = -1;
    int euler_characteristic = 0;  ///< V - E + F: 2 for one closed tube with caps
    int components = 0;
    double volume = 0.0;  ///< m3, > 0 where closed and oriented outward

    /// Closed, manifold, consistently oriented, without zero-area triangles. Self-intersection is checked by
    /// find_self_intersection.
    bool watertight() const {
        return indices_valid && finite && closed && manifold_edges && manifold_vertices && oriented &&
               no_zero_area;
    }
    /// One line that names the first defect; empty if watertight.
    std::string complaint() const;
};

/// Checks topology and shape in O(n log n); never throws.
MeshReport check_mesh(const TriangleMesh& mesh);

}  // namespace fulcrum
