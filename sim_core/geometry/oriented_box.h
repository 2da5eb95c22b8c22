// SPDX-License-Identifier: Apache-2.0
// A box in any direction, and its exact distance from points, segments, triangles and other boxes. Any
// thread; no allocation, no exception; inputs are finite.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct OrientedBox {
    Vector3 centre = Vector3::Zero();       ///< m
    Matrix3 axes = Matrix3::Identity();     ///< columns: unit directions of its edges
    Vector3 half = Vector3::Constant(0.0);  ///< m, half the edges, >= 0

    Vector3 corner(int k) const {
        const Vector3 local((k & 1) != 0 ? half.x() : -half.x(), (k & 2) != 0 ? half.y() : -half.y(),
                            (k & 4) != 0 ? half.z() : -half.z());
        return centre + axes * local;
    }
};

/// Two nearest points. overlap: m, how far the shapes must part along `normal` where they meet; 0 apart.
struct Separation {
    double distance = 0;                                           ///< m, >= 0
    double overlap = 0;                                            ///< m, >= 0; only one of the two is not 0
    Vector3 on_box = Vector3::Zero(), on_other = Vector3::Zero();  ///< m
    Vector3 normal = Vector3::UnitZ();                             ///< unit, out of the box towards the other
};

/// Point against the box; inside, overlap is the way out through the nearest face.
Separation separate_point(const OrientedBox& box, const Vector3& point);

/// Nearest points of the box and the segment p q. The squared distance along a segment is convex with a
/// derivative linear between the places where the segment passes a face's plane: its zero is found, not
/// searched for. A segment that enters the box: distance 0, overlap the least way out of a face for all of
/// it.
Separation separate_segment(const OrientedBox& box, const Vector3& p, const Vector3& q);

/// Nearest points of the box and the triangle a b c. They are at an edge of the triangle or at a corner of
/// the box, unless the two meet; that is told by the thirteen separating axes (Akenine-Moeller 2001;
/// Gottschalk et al. 1996), whose least overlap is reported. Triangles without area are their segments.
Separation separate_triangle(const OrientedBox& box, const Vector3& a, const Vector3& b, const Vector3& c);

/// Nearest points of two boxes: at an edge of the one or of the other, unless they meet (fifteen axes).
/// normal: out of the first.
Separation separate_boxes(const OrientedBox& box, const OrientedBox& other);

}  // namespace fulcrum
