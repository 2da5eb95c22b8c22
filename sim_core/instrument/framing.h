// SPDX-License-Identifier: Apache-2.0
// How a point lies in the camera's image: off the middle, level or not, larger or smaller than wanted. Any
// thread, no allocation, no exception.
#pragma once

#include "sim_core/instrument/poses.h"

namespace fulcrum {

struct Framing {
    double off_centre = 0;  ///< rad, between the line of sight and the point
    double horizon = 0;  ///< rad, by which the image's upward direction is turned from `up`, signed; 0 when
                         ///< the camera looks along it
    double size = 0;     ///< wanted distance over distance: above 1 is too near; 0 at the point itself
};

/// `up`: unit, patient frame. `distance`: m, at which the point has the wanted size.
Framing frame_of(const CameraPose& camera, const Vector3& point, double distance, const Vector3& up);
/// Framing::horizon alone.
double horizon_of(const Quaternion& orientation, const Vector3& up);

}  // namespace fulcrum
