// SPDX-License-Identifier: Apache-2.0
// Mean value coordinates of a point in a closed triangle mesh (Ju, Schaefer, Warren 2005; vector form of
// Floater, Kos, Reimers 2005). Double precision; partition of unity and linear reproduction hold to rounding
// everywhere inside, on the cage and in the planes of its triangles, because each triangle's weights are
// solved with a residual at rounding.
#pragma once

#include <array>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Triangles of a cage with their edges found once: every edge serves two triangles.
struct CageTopology {
    explicit CageTopology(std::vector<Triangle> cage_triangles);

    std::vector<Triangle> triangles;
    std::vector<std::array<std::int32_t, 2>> edges;           ///< lower vertex first
    std::vector<std::array<std::int32_t, 3>> triangle_edges;  ///< edges ab, bc, ca of each triangle
    std::vector<std::array<double, 3>> edge_signs;            ///< -1 where the triangle runs against the edge
};

/// Reusable work space; sized by the first call, then nothing is allocated for cages of that size.
struct MeanValueScratch {
    std::vector<Vector3> direction;  ///< unit, point to cage vertex
    std::vector<double> distance;    ///< m
    std::vector<Vector3> cross;      ///< of the directions at an edge's ends
    std::vector<Vector3> sector;  ///< half the angle at the point times the unit normal of that cross product
};

/// Weights of all cage vertices at `point`: sum 1, sum of weight * vertex = point. The cage is closed and
/// consistently oriented; the point is not outside it. On a face, an edge or a vertex the weights are that
/// triangle's barycentric ones. weights has vertices.size() places; they are not finite where the point is
/// outside and has no coordinates.
void mean_value_weights(const std::vector<Vector3>& vertices, const CageTopology& topology,
                        const Vector3& point, MeanValueScratch& scratch, double* weights);

}  // namespace fulcrum
