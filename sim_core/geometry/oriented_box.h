// SPDX-License-Identifier: Apache-2.0
// Oriented box, its exact distance to points, segments and triangles, and its overlap with other boxes. Any
// thread; no allocation, no exception; inputs must be finite.
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

/// Two nearest points. overlap: m, depth by which the shapes must separate along `normal` if they intersect;
/// 0 otherwise.
struct Separation {
    double distance = 0;                                           ///< m, >= 0
    double overlap = 0;                                            ///< m, >= 0; only one of the two is not 0
    Vector3 on_box = Vector3::Zero(), on_other = Vector3::Zero();  ///< m
    Vector3 normal = Vector3::UnitZ();                             ///< unit, out of the box towards the other
};

/// Point against the box. Inside, overlap is the exit distance through the nearest face.
Separation separate_point(const OrientedBox& box, const Vector3& point);

/// Nearest points of the box and the segment p q. The squared distance along a segment is convex and its
/// derivative is linear between the crossings of face planes, so its zero is computed directly, without
/// iteration. A segment that enters the box has distance 0; overlap is then the least distance that moves the
/// whole segment out through a face.
Separation separate_segment(const OrientedBox& box, const Vector3& p, const Vector3& q);

/// Nearest points of the box and the triangle a b c: at an edge of the triangle or at a corner of the box,
/// unless the two intersect. Intersection is tested on the thirteen separating axes (Akenine-Moeller 2001;
/// Gottschalk et al. 1996); the least overlap is reported. A triangle without area is treated as its edges.
Separation separate_triangle(const OrientedBox& box, const Vector3& a, const Vector3& b, const Vector3& c);

/// Whether two boxes overlap (fifteen axes); sets `found` if they do. normal: outward from the first box.
bool boxes_overlap(const OrientedBox& box, const OrientedBox& other, Separation& found);

}  // namespace fulcrum
