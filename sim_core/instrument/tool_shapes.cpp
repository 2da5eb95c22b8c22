// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/tool_shapes.h"

#include <algorithm>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double far_apart = -1e9;  // m

// The box's normal points to the other shape; it is reversed if the box is the first shape.
void keep_deeper(const Separation& found, double radius, bool box_is_first, SolidContact& deepest) {
    const double depth = found.overlap > 0 ? radius + found.overlap : radius - found.distance;
    if (!(depth > deepest.depth)) return;
    deepest.depth = depth;
    deepest.normal = box_is_first ? Vector3(-found.normal) : found.normal;
    deepest.point = found.on_box;
    deepest.by_jaw = true;
}

}  // namespace

ToolShape tool_shape(const InstrumentModel& instrument, const ToolKinematics& tool) {
    ToolShape shape;
    shape.trocar = tool.trocar;
    shape.tip = tool.tip;
    shape.radius = instrument.shaft_radius;
    if (!instrument.has_jaws) return shape;
    shape.jaws = 2;
    const Vector3 hinge = tool.tip - instrument.jaw_length * tool.axis;
    double sine = 0, cosine = 1;
    math::sin_cos(0.5 * std::clamp(tool.jaw_angle, 0.0, instrument.jaw_opening), sine, cosine);
    for (int k = 0; k < 2; ++k) {
        const double side = k == 0 ? 1.0 : -1.0;
        OrientedBox& jaw = shape.jaw[k];
        jaw.axes.col(0) = tool.rotation.col(0);
        jaw.axes.col(2) = cosine * tool.rotation.col(2) + side * sine * tool.rotation.col(1);
        jaw.axes.col(1) = jaw.axes.col(2).cross(jaw.axes.col(0));
        jaw.half =
            Vector3(0.5 * instrument.tip_box.y(), 0.25 * instrument.tip_box.z(), 0.5 * instrument.jaw_length);
        jaw.centre =
            hinge + 0.5 * instrument.jaw_length * jaw.axes.col(2) + side * jaw.half.y() * jaw.axes.col(1);
    }
    return shape;
}

SolidContact collide_shapes(const ToolShape& first, const ToolShape& second) {
    SolidContact deepest;
    const SegmentPair pair = closest_points_of_segments(first.trocar, first.tip, second.trocar, second.tip);
    const Vector3 between = pair.on_first - pair.on_second;
    const double distance = between.norm();
    deepest.depth = first.radius + second.radius - distance;
    deepest.point = 0.5 * (pair.on_first + pair.on_second);
    if (distance > 1e-9) {
        deepest.normal = between / distance;
    } else {
        const Vector3 across = (first.tip - first.trocar).cross(second.tip - second.trocar);
        if (across.norm() > 1e-12) deepest.normal = across.normalized();
    }
    // A jaw cannot penetrate deeper than a ball around it: skip it if the ball is no deeper than the best so
    // far, or does not touch at all.
    const auto cannot_improve = [&](const OrientedBox& jaw, const Vector3& other, double radius) {
        return jaw.half.norm() + radius - (jaw.centre - other).norm() < std::max(deepest.depth, 0.0);
    };
    const auto jaw_on_shaft = [&](const OrientedBox& jaw, const ToolShape& shaft, bool jaw_is_first) {
        const SegmentPair near = closest_points_of_segments(shaft.trocar, shaft.tip, jaw.centre, jaw.centre);
        if (cannot_improve(jaw, near.on_first, shaft.radius)) return;
        keep_deeper(separate_segment(jaw, shaft.trocar, shaft.tip), shaft.radius, jaw_is_first, deepest);
    };
    for (int k = 0; k < first.jaws; ++k) jaw_on_shaft(first.jaw[k], second, true);
    for (int m = 0; m < second.jaws; ++m) jaw_on_shaft(second.jaw[m], first, false);
    for (int k = 0; k < first.jaws; ++k) {
        for (int m = 0; m < second.jaws; ++m) {
            if (cannot_improve(first.jaw[k], second.jaw[m].centre, second.jaw[m].half.norm())) continue;
            Separation found;
            if (boxes_overlap(first.jaw[k], second.jaw[m], found)) keep_deeper(found, 0.0, true, deepest);
        }
    }
    return deepest;
}

SolidContact collide_sphere(const ToolShape& tool, const Vector3& centre, double radius) {
    SolidContact deepest;
    const SegmentPair pair = closest_points_of_segments(tool.trocar, tool.tip, centre, centre);
    const Vector3 between = pair.on_first - centre;
    const double distance = between.norm();
    deepest.depth = tool.radius + radius - distance;
    deepest.point = pair.on_first;
    if (distance > 1e-12) deepest.normal = between / distance;
    for (int k = 0; k < tool.jaws; ++k)
        keep_deeper(separate_point(tool.jaw[k], centre), radius, true, deepest);
    return deepest;
}

SolidContact collide_triangle(const ToolShape& tool, const Vector3& a, const Vector3& b, const Vector3& c) {
    SolidContact deepest;
    deepest.depth = far_apart;
    for (int k = 0; k < tool.jaws; ++k)
        keep_deeper(separate_triangle(tool.jaw[k], a, b, c), 0.0, true, deepest);
    return deepest;
}

}  // namespace fulcrum
