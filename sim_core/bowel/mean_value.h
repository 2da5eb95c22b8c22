// SPDX-License-Identifier: Apache-2.0
// Mean value coordinates of a point in a closed triangle mesh (Ju, Schaefer, Warren 2005; vector form of
// Floater, Kos, Reimers 2005). Double precision; partition of unity and linear reproduction hold to rounding
// everywhere inside, on the cage and in the planes of its triangles, because each triangle's weights are
// solved with a residual at rounding.
#pragma once

#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Reusable work space of mean_value_weights; sized by the first call, then nothing is allocated for cages of
/// that size.
struct MeanValueScratch {
    std::vector<Vector3> direction;  ///< unit, point to cage vertex
    std::vector<double> distance;    ///< m
};

/// Weights of all cage vertices at `point`: sum 1, sum of weight * vertex = point. The cage is closed and
/// oriented outward. A point on a face, an edge or a vertex gets barycentric weights of that triangle.
/// weights has vertices.size() places.
void mean_value_weights(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles,
                        const Vector3& point, MeanValueScratch& scratch, double* weights);

}  // namespace fulcrum
