// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/framing.h"

#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {

namespace {

constexpr double level = 1e-3;  // length of `up` in the image below which it has no direction there

}  // namespace

double horizon_of(const Quaternion& orientation, const Vector3& up) {
    const Vector3 in_camera = orientation.conjugate() * up;
    if (in_camera.x() * in_camera.x() + in_camera.y() * in_camera.y() < level * level) return 0;
    return math::atan2(in_camera.x(), in_camera.y());
}

Framing frame_of(const CameraPose& camera, const Vector3& point, double distance, const Vector3& up) {
    Framing framing;
    framing.horizon = horizon_of(camera.orientation, up);
    const Vector3 local = camera.orientation.conjugate() * (point - camera.position);
    const double away = local.norm();
    if (away < 1e-9) return framing;
    framing.off_centre = math::acos(-local.z() / away);
    framing.size = distance / away;
    return framing;
}

}  // namespace fulcrum
