// SPDX-License-Identifier: Apache-2.0
// The dynamic point of Maciel and De (2008), on a segment: it walks from the last triangle through adjacency
// to the point of the surface that the shaft is nearest to, or penetrates deepest.
//
// The point q of the surface that corresponds to a point x of the shaft is the one whose smooth normal passes
// through x:
//     x = q + phi n(q),   n the interpolated vertex normals.
// It is a god-object without friction: it stays on the side from which it came. Because n is continuous over
// the mesh, so are q and the signed distance phi (a closest point would jump between facets below the
// surface). Along the shaft phi is smallest where n is perpendicular to it, or at the tip.
//
// A surface provides corner(t), position(v), normal(v) and neighbour(t, edge); edges as in MeshAdjacency. No
// allocation, no exception; the walk ends on every surface.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

struct WalkOptions {
    int iterations = 16;      ///< steps across triangles and along the shaft in one tick
    double tolerance = 1e-7;  ///< m, motion of the point at which the walk ends
    double curvature_radius =
        0.016;                    ///< m, of the surface across the shaft; sets Newton's step along the shaft
    double longest_step = 0.004;  ///< m along the shaft in one iteration
};

/// State of the walk; copyable. Triangle numbers are those of the surface.
struct WalkPoint {
    std::int32_t triangle = -1;
    Vector3 barycentric = Vector3(1.0 / 3, 1.0 / 3, 1.0 / 3);
    double shaft = 1.0;                  ///< fraction of the segment, 0 .. 1
    Vector3 position = Vector3::Zero();  ///< q, m
    Vector3 normal = Vector3::Zero();    ///< n(q), unit, outward
    Vector3 on_shaft = Vector3::Zero();  ///< x, m
    double distance = 0;                 ///< phi, m, < 0 below the surface
    int iterations = 0;
    bool at_border = false;  ///< the walk reached the mesh border or a triangle without area: search again
    bool converged = false;
};

/// The interpolated vertex normal, made a unit vector, of a triangle with this (unscaled) facet normal of
/// squared length face2. Where it is almost in the triangle's plane (a fold), the facet normal is used.
inline Vector3 smooth_normal(const Vector3& interpolated, const Vector3& face, double face2) noexcept {
    const double size = interpolated.norm();
    const double lean = face.dot(interpolated);
    if (size > 1e-6 && std::abs(lean) > 0.2 * size * std::sqrt(face2)) return interpolated / size;
    return (lean < 0 ? -face : face) / std::sqrt(face2);
}

/// Barycentric coordinates of a point on the common edge of two triangles, in the second one.
inline Vector3 carried_across(const Vector3& weights, const Triangle& from, const Triangle& to) noexcept {
    Vector3 carried = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t m = 0; m < 3; ++m) {
            if (to[k] == from[m]) carried[static_cast<int>(k)] = weights[static_cast<int>(m)];
        }
    }
    const double sum = carried.sum();
    return sum > 0 ? Vector3(carried / sum) : Vector3(Vector3::Constant(1.0 / 3));
}

/// Moves point from its triangle, barycentric coordinates and shaft fraction, for the segment from `from` (0)
/// to `to` (1).
template <typename Surface>
void walk_surface(Surface& surface, const Vector3& from, const Vector3& to, const WalkOptions& options,
                  WalkPoint& point) {
    const Vector3 segment = to - from;
    const double length = segment.norm();
    point.at_border = point.converged = false;
    bool placed = false;
    point.shaft = std::clamp(point.shaft, 0.0, 1.0);
    Vector3 last = Vector3::Constant(1e9);
    std::int32_t came_from = -1;
    double slope_before = 0, caution = 1;
    for (point.iterations = 1; point.iterations <= options.iterations; ++point.iterations) {
        const Triangle& corner = surface.corner(point.triangle);
        const Vector3& a = surface.position(corner[0]);
        const Vector3 ab = surface.position(corner[1]) - a, ac = surface.position(corner[2]) - a;
        const Vector3 face = ab.cross(ac);
        const double face2 = face.squaredNorm();
        if (!(face2 > 1e-30)) {
            point.at_border = true;
            return;
        }
        const Vector3& weight = point.barycentric;
        const Vector3 normal =
            smooth_normal(weight[0] * surface.normal(corner[0]) + weight[1] * surface.normal(corner[1]) +
                              weight[2] * surface.normal(corner[2]),
                          face, face2);
        const Vector3 x = from + point.shaft * segment;
        const double along = face.dot(a - x) / face.dot(normal);
        const Vector3 q = x + along * normal;
        const Vector3 aq = q - a;
        Vector3 weights;
        weights[2] = ab.cross(aq).dot(face) / face2;
        weights[1] = aq.cross(ac).dot(face) / face2;
        weights[0] = 1.0 - weights[1] - weights[2];
        int lowest = 0;
        const double least = weights.minCoeff(&lowest);
        point.on_shaft = x;
        if (least < -1e-9) {
            // Beyond the edge across from the lowest corner.
            const int edge = (lowest + 1) % 3;
            const std::int32_t next = surface.neighbour(point.triangle, edge);
            weights = weights.cwiseMax(0.0);
            weights /= weights.sum();
            if (next >= 0 && next != came_from) {
                point.barycentric = carried_across(weights, corner, surface.corner(next));
                came_from = point.triangle;
                point.triangle = next;
                continue;
            }
            if (next < 0) point.at_border = true;
            // Two triangles point at each other across their edge: the point is on the edge.
        }
        came_from = -1;
        placed = true;
        point.barycentric = weights;
        point.position = a + weights[1] * ab + weights[2] * ac;
        point.normal = normal;
        point.distance = (x - point.position).dot(normal);
        if (point.at_border) return;
        const double slope = length > 0 ? normal.dot(segment) / length : 0.0;
        if (slope * slope_before < 0) caution *= 0.5;
        slope_before = slope;
        const double newton = -slope * std::max(options.curvature_radius + point.distance, 0.002) * caution;
        const double step = std::clamp(newton, -options.longest_step, options.longest_step);
        const double before = point.shaft;
        if (length > 0) point.shaft = std::clamp(point.shaft + step / length, 0.0, 1.0);
        const double moved = std::abs(point.shaft - before) * length;
        if (moved < options.tolerance && (point.position - last).norm() < options.tolerance) {
            point.shaft = before;
            point.converged = true;
            return;
        }
        last = point.position;
    }
    if (!placed) point.at_border = true;  // too far for the allowed iterations
}

}  // namespace fulcrum
