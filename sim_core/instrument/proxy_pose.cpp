// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/proxy_pose.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double least_shaft = 0.1;  // nearer to the trocar the tip would move too far
constexpr double most_lift = 0.1;    // m
constexpr double least_left = 1e-3;  // m of the shaft that stays
constexpr double enough = 1e-5;      // m
constexpr int sweeps = 20;

}  // namespace

void TouchList::add(const Vector3& normal, double depth, double shaft, std::int32_t vertex) {
    if (!(depth > 0) || !std::isfinite(depth) || !normal.allFinite() || !(normal.norm() > 0.5)) return;
    const Touch found{normal, depth, std::clamp(shaft, least_shaft, 1.0), vertex};
    if (count < static_cast<std::int32_t>(touch.size())) {
        touch[static_cast<std::size_t>(count++)] = found;
        return;
    }
    const auto least = std::min_element(touch.begin(), touch.end(),
                                        [](const Touch& a, const Touch& b) { return a.depth < b.depth; });
    if (least->depth < depth) *least = found;
}

Vector3 lift_out(const TouchList& touches) {
    Vector3 lift = Vector3::Zero();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double worst = 0;
        for (std::int32_t i = 0; i < touches.count; ++i) {
            const Touch& touch = touches.touch[static_cast<std::size_t>(i)];
            const double left = touch.depth - touch.shaft * touch.normal.dot(lift);
            if (!(left > 0)) continue;
            worst = std::max(worst, left);
            lift += left / touch.shaft * touch.normal;
        }
        if (worst < enough) break;
    }
    const double size = lift.norm();
    if (!std::isfinite(size)) return Vector3::Zero();
    return size > most_lift ? Vector3(lift * (most_lift / size)) : lift;
}

ToolPose lifted(const ToolPose& pose, const Vector3& lift) {
    if (!pose.inside || lift.isZero() || !lift.allFinite()) return pose;
    const Vector3 shaft = pose.tip + lift - pose.trocar;
    const double length = shaft.norm();
    // Never back through the trocar.
    if (!(length > least_left) || !(shaft.dot(pose.axis) > 0)) return pose;
    ToolPose drawn = pose;
    drawn.tip = pose.trocar + shaft;
    drawn.axis = shaft / length;
    drawn.insertion = length;
    drawn.orientation = Quaternion::FromTwoVectors(pose.axis, drawn.axis) * pose.orientation;
    return drawn;
}

}  // namespace fulcrum
