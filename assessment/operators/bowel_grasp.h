// SPDX-License-Identifier: Apache-2.0
// Positions of the jaws from which they can grasp a tube's wall.
#pragma once

#include "assessment/operators/limb.h"
#include "assessment/task/bowel_line.h"

namespace fulcrum {

/// Position of the tip for which the middle of the jaws is `off` m from the centre line: on the side of the
/// tube where the shaft passes, a little towards the trocar, never below the tube.
inline Vector3 tip_beside_tube(const Limb& limb, const LinePoint& point, double off) noexcept {
    const Vector3 axis = (point.position - limb.trocar().position).normalized();
    Vector3 side = axis.cross(point.tangent);
    if (side.norm() < 0.2)
        side = Vector3::UnitZ() - axis.z() * axis;  // the shaft runs along the bowel: take its top
    side.normalize();
    if (side.z() < 0) side = -side;
    const Vector3 outward = (0.95 * side - 0.3 * axis).normalized();
    const Vector3 middle = point.position + off * outward;
    const Vector3 shaft = (middle - limb.trocar().position).normalized();
    return middle + 0.5 * limb.spec().jaw_length * shaft;
}

/// A point of the approach.
inline Vector3 tip_above_tube(const Limb& limb, const Vector3& place, double hover) noexcept {
    const Vector3 out = (limb.trocar().position - place).normalized();
    return place + hover * (0.7 * out + Vector3(0, 0, 0.5));
}

}  // namespace fulcrum
