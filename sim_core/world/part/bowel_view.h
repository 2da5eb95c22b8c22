// SPDX-License-Identifier: Apache-2.0
// The bowel as the viewport, the monitor and the operators see it after a step (WorldSnapshot::bowel).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/bowel/skin.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/numerics/types.h"
#include "sim_core/world/part/used_vector.h"

namespace fulcrum {

/// The bowel's surface where it has been cut: what is drawn in place of some of the skin's triangles. Fixed
/// capacity, *_count valid; all but `fallen` changes with `topology` only. Vertices 0 .. first_vertex - 1 are
/// the skin's own.
struct BowelCutView {
    std::int32_t first_vertex = 0;
    std::int32_t vertex_count = 0, triangle_count = 0;
    UsedVector<std::int32_t>
        vertex_roots;                 ///< of vertex first_vertex + i: the skin's triangle that it lies in
    UsedVector<Vector3> barycentric;  ///< and where in it, of its corners
    UsedVector<Triangle> triangles;   ///< visible, counterclockwise from outside
    UsedVector<std::int32_t> triangle_roots;  ///< of each: the skin's triangle that it is a part of
    UsedVector<std::uint8_t> triangle_loose;  ///< of each: 0 hangs on, else 1 + place in `fallen`
    std::vector<std::uint8_t> hidden;  ///< by the skin's triangle, 1: it is not drawn itself; empty without
    std::array<Vector3, 8> fallen{};   ///< m, way that each piece that came free has made
    std::uint32_t topology = 0;
    double thickness = 0;                       ///< m, of the wall
    double visible_area = 0, removed_area = 0;  ///< m2 at rest

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(first_vertex, vertex_count, triangle_count, vertex_roots, barycentric, triangles,
              triangle_roots, triangle_loose, hidden, fallen, topology, thickness, visible_area,
              removed_area);
    }
};

/// Vectors are empty without a bowel; all but the dents have their final size from the start.
struct BowelView {
    std::vector<Vector3> nodes;            ///< m, of the centre line: n + 1
    std::vector<double> node_arc_lengths;  ///< m at rest: n + 1
    std::vector<RingFrame> rings;
    std::vector<double> ring_arc_lengths;  ///< m at rest
    std::vector<DentVertex> dents;         ///< fixed capacity, dent_count valid
    std::int32_t dent_count = 0;
    std::vector<Vector3> tether_anchors;  ///< mesentery root points; empty without tethers
    std::vector<double> tether_arc_lengths;
    std::vector<float> patch_damage;  ///< N s per tissue patch
    double solve_residual = 0;        ///< of the last solve: share of the largest force that was left
    double residual_penetration = 0;  ///< m, deepest sphere in the cavity after the step
    double floor_load = 0;            ///< N, sum of contact forces on the cavity
    BowelCutView cut;                 ///< empty where its tissue is not cut

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(nodes, node_arc_lengths, rings, ring_arc_lengths, dents, dent_count, tether_anchors,
              tether_arc_lengths, patch_damage, solve_residual, residual_penetration, floor_load, cut);
    }
};

}  // namespace fulcrum
