// SPDX-License-Identifier: Apache-2.0
// Cups to look into and a tip to follow, as the viewport, the monitor and the operators see them after a step
// (WorldSnapshot::camera_targets). The ball in cup i is WorldSnapshot::targets[i]; the tip is the last one.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct CameraTarget {
    Vector3 ball = Vector3::Zero();   ///< m
    Vector3 mouth = Vector3::Zero();  ///< m, middle of the cup's rim
    Vector3 axis = Vector3::UnitZ();  ///< unit, out of the cup
    Vector3 eye = Vector3::Zero();    ///< m, a place of the lens from which the ball is framed
    double post = 0;                  ///< rad, turn of the light post there
};

struct CameraTargetsView {
    std::vector<CameraTarget> targets;                                ///< empty without Scene::camera_targets
    double ball_radius = 0, cup_radius = 0, wall = 0, cup_depth = 0;  ///< m
    double distance = 0;            ///< m, from the lens at which a ball or the tip has the wanted size
    Vector3 tip = Vector3::Zero();  ///< m
    Vector3 tip_velocity = Vector3::Zero();  ///< m/s

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(targets, ball_radius, cup_radius, wall, cup_depth, distance, tip, tip_velocity);
    }

    /// Whether the ball's middle is seen from `eye` through the cup's mouth.
    bool looks_into(const CameraTarget& target, const Vector3& eye) const noexcept {
        const Vector3 line = eye - target.ball;
        const double up = line.dot(target.axis);
        if (up <= cup_depth) return false;
        const Vector3 at_mouth = target.ball + line * (cup_depth / up);
        return (at_mouth - target.mouth).norm() < cup_radius;
    }
};

}  // namespace fulcrum
