// SPDX-License-Identifier: Apache-2.0
#include "sim_core/geometry/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"

namespace fulcrum {
namespace {

constexpr double least_axis = 1e-9;  // sine below which two directions count as parallel and give no axis

Vector3 into(const OrientedBox& box, const Vector3& point) {
    return box.axes.transpose() * (point - box.centre);
}
Vector3 out_of(const OrientedBox& box, const Vector3& local) {
    return box.centre + box.axes * local;
}

// Sets distance and normal from the two points.
Separation between(const Vector3& on_box, const Vector3& on_other) {
    Separation found;
    found.on_box = on_box;
    found.on_other = on_other;
    const Vector3 difference = on_other - on_box;
    found.distance = difference.norm();
    if (found.distance > 0) found.normal = difference / found.distance;
    return found;
}

// Squared distance of a local point, and its nearest point in the box.
double outside2(const Vector3& half, const Vector3& local, Vector3& nearest) {
    nearest = local.cwiseMax(-half).cwiseMin(half);
    return (local - nearest).squaredNorm();
}

// Overlap of the projections of two shapes on an axis; keeps the axis of least overlap. Returns false if the
// axis separates them.
struct LeastOverlap {
    double size = std::numeric_limits<double>::infinity();
    Vector3 normal = Vector3::UnitZ();  // local, out of the box

    bool take(const Vector3& axis, double box_reach, double low, double high) {
        const double length = axis.norm();
        if (!(length > least_axis)) return true;
        const double up = box_reach - low, down = high + box_reach;  // exit distances along +axis and -axis
        if (up < 0 || down < 0) return false;
        if (std::min(up, down) < size * length) {
            size = std::min(up, down) / length;
            normal = (up <= down ? axis : Vector3(-axis)) / length;
        }
        return true;
    }
};

// True if the box (centred, axis-aligned) and the convex hull of the points intersect, tested on the cross
// products of their edges.
template <int points, int edges>
bool meet(const Vector3& half, const Vector3 (&point)[points], const Vector3 (&edge)[edges],
          const Vector3* normals, int normal_count, LeastOverlap& least) {
    const auto parted = [&](const Vector3& axis) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vector3& p : point) {
            low = std::min(low, axis.dot(p));
            high = std::max(high, axis.dot(p));
        }
        return !least.take(axis, half.dot(axis.cwiseAbs()), low, high);
    };
    for (int k = 0; k < 3; ++k) {
        if (parted(Vector3::Unit(k))) return false;
    }
    for (int k = 0; k < normal_count; ++k) {
        if (parted(normals[k])) return false;
    }
    for (const Vector3& along : edge) {
        const double length = along.norm();
        if (!(length > 0)) continue;
        for (int k = 0; k < 3; ++k) {
            if (parted(Vector3::Unit(k).cross(along / length))) return false;
        }
    }
    return true;
}

Separation meeting(const OrientedBox& box, const LeastOverlap& least, const Vector3& local_point) {
    Separation found;
    found.overlap = least.size;
    found.normal = box.axes * least.normal;
    Vector3 nearest;
    outside2(box.half, local_point, nearest);
    found.on_box = found.on_other = out_of(box, nearest);
    return found;
}

}  // namespace

Separation separate_point(const OrientedBox& box, const Vector3& point) {
    const Vector3 local = into(box, point);
    Vector3 nearest;
    if (outside2(box.half, local, nearest) > 0) return between(out_of(box, nearest), point);
    Separation found;
    found.on_other = point;
    int face = 0;
    const Vector3 room = box.half - local.cwiseAbs();
    found.overlap = room.minCoeff(&face);
    const double side = local[face] < 0 ? -1.0 : 1.0;
    found.normal = side * box.axes.col(face);
    found.on_box = point + found.overlap * found.normal;
    return found;
}

Separation separate_segment(const OrientedBox& box, const Vector3& p, const Vector3& q) {
    const Vector3 from = into(box, p), along = into(box, q) - from;
    // Parameters at which the segment crosses the planes of the faces, ascending.
    double place[8];
    int places = 0;
    place[places++] = 0.0;
    for (int k = 0; k < 3; ++k) {
        if (along[k] == 0.0) continue;
        for (const double side : {-1.0, 1.0}) {
            const double t = (side * box.half[k] - from[k]) / along[k];
            if (t > 0 && t < 1) place[places++] = t;
        }
    }
    place[places++] = 1.0;
    std::sort(place, place + places);
    const auto slope = [&](double t) {
        const Vector3 local = from + t * along;
        Vector3 nearest;
        outside2(box.half, local, nearest);
        return (local - nearest).dot(along);
    };
    // The derivative increases with t: its zero is in the first interval whose end value is not negative.
    double best = 1.0, before = slope(0.0);
    if (!(before < 0)) {
        best = 0.0;
    } else {
        for (int i = 1; i < places; ++i) {
            const double after = slope(place[i]);
            if (after >= 0) {
                const double share = before / (before - after);
                best = place[i - 1] + share * (place[i] - place[i - 1]);
                break;
            }
            before = after;
        }
    }
    const Vector3 local = from + best * along;
    Vector3 nearest;
    if (outside2(box.half, local, nearest) > 0) return between(out_of(box, nearest), p + best * (q - p));
    const Vector3 points[2] = {from, from + along}, edges[1] = {along};
    LeastOverlap least;
    if (!meet(box.half, points, edges, nullptr, 0, least)) least.size = 0;  // they touch within rounding
    return meeting(box, least, local);
}

Separation separate_triangle(const OrientedBox& box, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 points[3] = {into(box, a), into(box, b), into(box, c)};
    const Vector3 edges[3] = {points[1] - points[0], points[2] - points[1], points[0] - points[2]};
    Vector3 normal = edges[0].cross(edges[1]);
    const double area2 = normal.norm();
    if (area2 > 0) normal /= area2;
    LeastOverlap least;
    if (meet(box.half, points, edges, &normal, area2 > 0 ? 1 : 0, least)) {
        const Vector3 foot =
            closest_point_on_triangle(Vector3::Zero(), points[0], points[1], points[2]).position;
        return meeting(box, least, foot);
    }
    Separation best = separate_segment(box, a, b);
    for (const Separation& edge : {separate_segment(box, b, c), separate_segment(box, c, a)}) {
        if (edge.distance < best.distance) best = edge;
    }
    for (int k = 0; k < 8; ++k) {
        const Vector3 corner = box.corner(k);
        const Vector3 foot = closest_point_on_triangle(corner, a, b, c).position;
        if ((foot - corner).norm() < best.distance) best = between(corner, foot);
    }
    return best;
}

bool boxes_overlap(const OrientedBox& box, const OrientedBox& other, Separation& found) {
    Vector3 points[8];
    for (int k = 0; k < 8; ++k) points[k] = into(box, other.corner(k));
    const Matrix3 turn = box.axes.transpose() * other.axes;
    const Vector3 edges[3] = {turn.col(0), turn.col(1), turn.col(2)};
    LeastOverlap least;
    if (!meet(box.half, points, edges, edges, 3, least)) return false;
    found = meeting(box, least, into(box, other.centre));
    return true;
}

}  // namespace fulcrum
