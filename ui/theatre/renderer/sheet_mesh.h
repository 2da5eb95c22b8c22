// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet of tissue with its thickness: two faces and, along every rim, the cut through it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum::ui {

/// An edge of a triangle in its direction, by vertices.
using SheetEdge = std::array<std::int32_t, 2>;

/// What is to be drawn; pointers are only read during the call.
struct SheetSurface {
    const Vector3* positions = nullptr;  ///< m, patient frame, `vertices` of them
    const Vector3* rest = nullptr;       ///< m, where they were at rest: x and y carry the texture
    std::size_t vertices = 0;
    const Triangle* triangles = nullptr;  ///< visible ones, equally oriented where they share an edge
    std::size_t count = 0;
    double thickness = 0.0012;             ///< m; 0: one face without rims, seen from both sides
    const float* burnt = nullptr;          ///< null, or one a vertex, 0 .. 1: charred
    const Vector3* normals = nullptr;      ///< null: of the triangles' areas; else one a vertex, unit
    const std::int32_t* places = nullptr;  ///< null, or one a vertex: the same number, the same place
    const SheetEdge* beside =
        nullptr;  ///< of triangles that are drawn elsewhere: where these adjoin is no rim
    std::size_t beside_count = 0;
    bool wall =
        false;  ///< of a hollow: positions are its outer face, and it shows its layers instead of char
};

/// Vertices for the pipeline: position 3, normal 3, coordinates 2 (m at rest), detail 1 (0 .. 1: how
/// much it is charred, of a wall how deep it lies; 4 more on a cut).
class SheetMesh {
  public:
    static constexpr std::size_t floats = 9;
    static constexpr float cut_detail = 4;

    /// Replaces what was there. Normals are smooth over the faces; a rim keeps its crease. Triangles that
    /// name a vertex out of range are left out. Allocates only while it grows.
    void build(const SheetSurface& surface);
    const std::vector<float>& vertices() const { return vertices_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }
    std::size_t rim_edges() const { return rim_edges_; }

  private:
    struct Edge {
        std::uint64_t key;
        std::int32_t from, to;
    };
    void add_edge(const SheetSurface& surface, std::int32_t from, std::int32_t to);
    void add(const Vector3& position, const Vector3& normal, const Vector3& rest, float detail);
    std::vector<float> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<Vector3> normals_;
    std::vector<Edge> edges_;
    std::size_t rim_edges_ = 0;
};

}  // namespace fulcrum::ui
