// SPDX-License-Identifier: Apache-2.0
#include "sim_core/cutting/blade.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double most_length = 1e6;  // m: beyond it squares lose precision
constexpr double cosine_22 = 0.92387953251128674, sine_22 = 0.38268343236508977;  // 22.5 degrees

bool usable(const Vector3& v) {
    return v.allFinite() && v.cwiseAbs().maxCoeff() < most_length;
}

void add(BladeRegion& region, const Vector3& normal, double offset) {
    region.planes[static_cast<std::size_t>(region.count++)] = {normal, offset};
}

// The four sides of half an octagon inscribed in the circle of half the width about an end.
void add_round_end(BladeRegion& region, const Vector3& centre, const Vector3& outward) {
    const double apothem = region.half_width * cosine_22;
    const Vector3 normals[] = {
        cosine_22 * region.left + sine_22 * outward, sine_22 * region.left + cosine_22 * outward,
        cosine_22 * outward - sine_22 * region.left, sine_22 * outward - cosine_22 * region.left};
    for (const Vector3& n : normals) add(region, n, n.dot(centre) + apothem);
}

}  // namespace

BladeFault make_region(const BladeStep& step, BladeRegion& region) {
    region = BladeRegion();
    if (!usable(step.from) || !usable(step.to) || !usable(step.normal) || !std::isfinite(step.width) ||
        !std::isfinite(step.depth))
        return BladeFault::not_finite;
    if (!(step.width > 0) || !(step.depth > 0) || step.width > most_length || step.depth > most_length)
        return BladeFault::no_width;
    const double length_of_normal = step.normal.norm();
    if (!(length_of_normal > 0)) return BladeFault::no_advance;
    const Vector3 normal = step.normal / length_of_normal;
    const Vector3 advance = step.to - step.from;
    const double rise = normal.dot(advance);
    const Vector3 across = advance - rise * normal;
    const double length = across.norm();
    if (!(length > 1e-6 * step.width)) return BladeFault::no_advance;

    region.along = across / length;
    region.left = normal.cross(region.along);
    region.from = step.from;
    region.to = step.to;
    region.half_width = 0.5 * step.width;
    region.reach = step.depth + 0.5 * std::abs(rise);
    region.centre = 0.5 * (step.from + step.to);
    const double half_length = 0.5 * length + region.half_width;
    region.radius = std::sqrt(half_length * half_length + region.half_width * region.half_width +
                              region.reach * region.reach);
    // The borders first: the ends do not split again what is beyond the borders.
    add(region, region.left, region.left.dot(step.from) + region.half_width);
    add(region, -region.left, -region.left.dot(step.from) + region.half_width);
    if (step.start == BladeEnd::round)
        add_round_end(region, step.from, -region.along);
    else
        add(region, -region.along, -region.along.dot(step.from));
    if (step.end == BladeEnd::round)
        add_round_end(region, step.to, region.along);
    else
        add(region, region.along, region.along.dot(step.to));
    add(region, normal, normal.dot(region.centre) + region.reach);
    add(region, -normal, -normal.dot(region.centre) + region.reach);
    return BladeFault::none;
}

bool BladeRegion::near(const Vector3& a, const Vector3& b, const Vector3& c, double margin) const {
    const Vector3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const double ball = radius + margin;
    if ((low - centre).maxCoeff() > ball || (centre - high).maxCoeff() > ball) return false;
    for (int k = 0; k < count; ++k) {
        const BladePlane& plane = planes[static_cast<std::size_t>(k)];
        if (std::min({plane.distance(a), plane.distance(b), plane.distance(c)}) > margin) return false;
    }
    return true;
}

bool BladeRegion::meets(const Vector3& a, const Vector3& b, const Vector3& c, double inset) const {
    // Sutherland and Hodgman's clipping; each plane adds at most one corner.
    constexpr std::size_t room = 3 + most_planes;
    Vector3 rooms[2][room];
    double distances[room];
    Vector3* corners = rooms[0];
    Vector3* kept = rooms[1];
    corners[0] = a;
    corners[1] = b;
    corners[2] = c;
    std::size_t size = 3;
    for (int k = 0; k < count; ++k) {
        const BladePlane& plane = planes[static_cast<std::size_t>(k)];
        std::size_t within = 0;
        for (std::size_t i = 0; i < size; ++i) {
            distances[i] = plane.distance(corners[i]) + inset;
            within += distances[i] <= 0 ? 1U : 0U;
        }
        if (within == 0) return false;
        if (within == size) continue;
        std::size_t next = 0;
        for (std::size_t i = 0; i < size && next < room; ++i) {
            const std::size_t j = i + 1 == size ? 0 : i + 1;
            const double d = distances[i], e = distances[j];
            if (d <= 0) kept[next++] = corners[i];
            if (((d < 0 && e > 0) || (d > 0 && e < 0)) && next < room)
                kept[next++] = corners[i] + d / (d - e) * (corners[j] - corners[i]);
        }
        size = next;
        std::swap(corners, kept);
    }
    return true;
}

double BladeRegion::distance_from_path(const Vector3& x, double& side) const {
    const double length = along.dot(to - from);
    const double s = std::clamp(along.dot(x - from), 0.0, length);
    side = left.dot(x - from);
    const double ahead = along.dot(x - from) - s;
    return std::sqrt(ahead * ahead + side * side);
}

}  // namespace fulcrum
