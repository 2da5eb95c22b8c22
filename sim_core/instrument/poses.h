// SPDX-License-Identifier: Apache-2.0
// Poses of the instruments and of the scope, patient frame.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct ToolPose {
    Vector3 tip = Vector3::Zero();                    ///< m, patient frame
    Vector3 axis = Vector3(0, 0, -1);                 ///< unit, trocar to tip
    Vector3 trocar = Vector3::Zero();                 ///< m
    Quaternion orientation = Quaternion::Identity();  ///< tool frame: z along the axis, roll applied
    double roll = 0, jaw_angle = 0;                   ///< rad
    double jaw_force = 0;                             ///< N
    double insertion = 0;                             ///< m
    bool inside = false;
};

struct CameraPose {
    Vector3 position = Vector3::Zero();               ///< scope tip, m
    Quaternion orientation = Quaternion::Identity();  ///< camera (-z forward, +y up) to patient frame
    double field_of_view = 1.2;                       ///< rad, full angle of the round image
};

}  // namespace fulcrum
