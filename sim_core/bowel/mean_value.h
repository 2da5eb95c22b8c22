// SPDX-License-Identifier: Apache-2.0
// Mean value coordinates of a point in a closed triangle mesh (Ju, Schaefer, Warren 2005; vector form of
// Floater, Kos, Reimers 2005). Double precision. Partition of unity and linear reproduction hold to rounding
// everywhere inside, on the cage and in the planes of its triangles, because the weights of each triangle are
// solved with a residual at rounding level.
#pragma once

#include <array>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Triangles of a cage and its edges, computed once: every edge belongs to two triangles.
struct CageTopology {
    explicit CageTopology(std::vector<Triangle> cage_triangles);

    std::vector<Triangle> triangles;
    std::vector<std::array<std::int32_t, 2>> edges;           ///< lower vertex first
    std::vector<std::array<std::int32_t, 3>> triangle_edges;  ///< edges ab, bc, ca of each triangle
    std::vector<std::array<double, 3>> edge_signs;            ///< -1 where the triangle runs against the edge
};

/// Reusable work space; sized by the first call, then no allocation for cages of that size.
struct MeanValueScratch {
    std::vector<Vector3> direction;  ///< unit, point to cage vertex
    std::vector<double> distance;    ///< m
    std::vector<Vector3> cross;      ///< of the directions at an edge's ends
    std::vector<Vector3> sector;  ///< half the angle at the point times the unit normal of that cross product
};

/// Weights of all cage vertices at `point`: sum 1, sum of weight * vertex = point. The cage must be closed
/// and consistently oriented, and the point not outside it. On a face, an edge or a vertex the weights are
/// the barycentric ones of that triangle. weights has vertices.size() entries; they are not finite if the
/// point is outside and has no coordinates.
void mean_value_weights(const std::vector<Vector3>& vertices, const CageTopology& topology,
                        const Vector3& point, MeanValueScratch& scratch, double* weights);

}  // namespace fulcrum
