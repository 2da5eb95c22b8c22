// SPDX-License-Identifier: Apache-2.0
#include "sim_core/geometry/closest_point.h"

#include <algorithm>

namespace fulcrum {
namespace {

struct SegmentPoint {
    double t;
    Vector3 position;
    double distance_squared;
};

SegmentPoint closest_on_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
    const Vector3 ab = b - a;
    const double length_squared = ab.squaredNorm();
    const double t = length_squared > 0.0 ? std::clamp((p - a).dot(ab) / length_squared, 0.0, 1.0) : 0.0;
    const Vector3 position = a + t * ab;
    return {t, position, (p - position).squaredNorm()};
}

TriangleFeature edge_feature(double t, TriangleFeature from, TriangleFeature to, TriangleFeature edge) {
    return t <= 0.0 ? from : (t >= 1.0 ? to : edge);
}

// Tests the three edges separately, for triangles without a usable plane.
TrianglePoint closest_on_edges(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
    const SegmentPoint ab = closest_on_segment(p, a, b), bc = closest_on_segment(p, b, c),
                       ca = closest_on_segment(p, c, a);
    using F = TriangleFeature;
    if (ab.distance_squared <= bc.distance_squared && ab.distance_squared <= ca.distance_squared) {
        return {ab.position, Vector3(1.0 - ab.t, ab.t, 0.0),
                edge_feature(ab.t, F::vertex_a, F::vertex_b, F::edge_ab)};
    }
    if (bc.distance_squared <= ca.distance_squared) {
        return {bc.position, Vector3(0.0, 1.0 - bc.t, bc.t),
                edge_feature(bc.t, F::vertex_b, F::vertex_c, F::edge_bc)};
    }
    return {ca.position, Vector3(ca.t, 0.0, 1.0 - ca.t),
            edge_feature(ca.t, F::vertex_c, F::vertex_a, F::edge_ca)};
}

}  // namespace

TrianglePoint closest_point_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                        const Vector3& c) {
    using F = TriangleFeature;
    const Vector3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {a, Vector3(1, 0, 0), F::vertex_a};
    const Vector3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) return {b, Vector3(0, 1, 0), F::vertex_b};
    const Vector3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) return {c, Vector3(0, 0, 1), F::vertex_c};

    const double vc = d1 * d4 - d3 * d2;
    const double vb = d5 * d2 - d1 * d6;
    const double va = d3 * d6 - d5 * d4;
    // Twice the area, squared. For a sliver the sub-areas are rounding noise and the plane is undefined.
    const double sum = va + vb + vc;
    const double scale = std::max(ab.squaredNorm(), ac.squaredNorm());
    if (!(sum > 1e-20 * scale * scale)) return closest_on_edges(p, a, b, c);
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double t = d1 / (d1 - d3);
        return {a + t * ab, Vector3(1.0 - t, t, 0.0), F::edge_ab};
    }
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double t = d2 / (d2 - d6);
        return {a + t * ac, Vector3(1.0 - t, 0.0, t), F::edge_ca};
    }
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {b + t * (c - b), Vector3(0.0, 1.0 - t, t), F::edge_bc};
    }
    const double v = vb / sum, w = vc / sum;
    return {a + v * ab + w * ac, Vector3(1.0 - v - w, v, w), F::face};
}

SegmentPair closest_points_of_segments(const Vector3& p0, const Vector3& p1, const Vector3& q0,
                                       const Vector3& q1) {
    const Vector3 d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
    const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
    SegmentPair pair;
    if (a <= 0.0 && e <= 0.0) {
        pair.s = pair.t = 0.0;
    } else if (a <= 0.0) {
        pair.t = std::clamp(f / e, 0.0, 1.0);
    } else {
        const double c = d1.dot(r);
        if (e <= 0.0) {
            pair.s = std::clamp(-c / a, 0.0, 1.0);
        } else {
            const double b = d1.dot(d2), denominator = a * e - b * b;
            // Parallel within rounding: every s is equally close, use the start.
            pair.s = denominator > 1e-14 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
            pair.t = (b * pair.s + f) / e;
            if (pair.t < 0.0) {
                pair.t = 0.0;
                pair.s = std::clamp(-c / a, 0.0, 1.0);
            } else if (pair.t > 1.0) {
                pair.t = 1.0;
                pair.s = std::clamp((b - c) / a, 0.0, 1.0);
            }
        }
    }
    pair.on_first = p0 + pair.s * d1;
    pair.on_second = q0 + pair.t * d2;
    return pair;
}

}  // namespace fulcrum
