// SPDX-License-Identifier: Apache-2.0
// Closest point on a triangle and the feature (face, edge, vertex) that it lies on (Ericson, Real-Time
// Collision Detection, 5.1.5: Voronoi regions).
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

enum class TriangleFeature : std::uint8_t { vertex_a, vertex_b, vertex_c, edge_ab, edge_bc, edge_ca, face };

struct TrianglePoint {
    Vector3 position = Vector3::Zero();     ///< m
    Vector3 barycentric = Vector3::Zero();  ///< weights of a, b, c: >= 0, sum 1
    TriangleFeature feature = TriangleFeature::face;
};

/// Point of triangle abc closest to p. A degenerate triangle is treated as its longest edge or its single
/// point.
TrianglePoint closest_point_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                        const Vector3& c);

/// Closest points of the segments p0 p1 and q0 q1, as parameters in [0, 1]. Parallel and zero-length segments
/// are handled.
struct SegmentPair {
    double s = 0.0, t = 0.0;
    Vector3 on_first = Vector3::Zero(), on_second = Vector3::Zero();
};
SegmentPair closest_points_of_segments(const Vector3& p0, const Vector3& p1, const Vector3& q0,
                                       const Vector3& q1);

}  // namespace fulcrum
