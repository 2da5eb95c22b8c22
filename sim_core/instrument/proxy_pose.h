// SPDX-License-Identifier: Apache-2.0
// The pose in which an instrument is drawn: the proxy, which stays on the surface of what the instrument
// touches while the device's own pose may be inside it. Pure functions, any thread, no allocation.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/instrument/poses.h"

namespace fulcrum {

/// Where an instrument is inside something.
struct Touch {
    Vector3 normal = Vector3::UnitZ();  ///< unit, out of it
    double depth = 0;                   ///< m along the normal, > 0
    double shaft = 1;                   ///< where on the shaft, 0 at the trocar, 1 at the tip
    std::int32_t vertex = -1;  ///< of the bowel's surface, which is drawn dented there; -1: not the bowel
};

/// The deepest touches of one instrument; fixed size.
struct TouchList {
    std::array<Touch, 6> touch;
    std::int32_t count = 0;

    /// Keeps the deepest ones. Without effect where depth or normal are not usable.
    void add(const Vector3& normal, double depth, double shaft = 1, std::int32_t vertex = -1);
};

/// Displacement of the tip, m, that takes the instrument out of all touches, to a hundredth of a millimetre
/// where they allow it. A touch on the shaft turns it about the trocar.
Vector3 lift_out(const TouchList& touches);

/// The pose with its tip displaced: shaft from the trocar to the new tip, turned by the smallest rotation.
ToolPose lifted(const ToolPose& pose, const Vector3& lift);

}  // namespace fulcrum
