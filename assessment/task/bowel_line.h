// SPDX-License-Identifier: Apache-2.0
// The bowel's centre line in a snapshot, by arc length: what tasks count along and operators look at.
#pragma once

#include <vector>

#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

/// A place on the centre line; m, patient frame.
struct LinePoint {
    Vector3 position = Vector3::Zero();
    Vector3 tangent = Vector3::UnitX();  ///< unit, towards larger arc length
};

/// The centre line at a rest arc length, linear between nodes, clamped to its ends. A snapshot without a
/// bowel gives the origin. Allocates nothing, never throws.
LinePoint line_point(const std::vector<Vector3>& nodes, const std::vector<double>& arc_lengths,
                     double arc_length) noexcept;
inline LinePoint line_point(const WorldSnapshot& world, double arc_length) noexcept {
    return line_point(world.bowel.nodes, world.bowel.node_arc_lengths, arc_length);
}

}  // namespace fulcrum
