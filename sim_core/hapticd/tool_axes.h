// SPDX-License-Identifier: Apache-2.0
// Axes that a person names, and the roll of a tool whose orientation a device reports.
#pragma once

#include <optional>
#include <string_view>

#include "sim_core/numerics/types.h"

namespace fulcrum::hapticd {

/// The direction of "-z".
std::optional<Vector3> direction_of(std::string_view word);
/// Of "+x+z-y": the device's axes that point to the right, up and towards the person, as rows. Not always a
/// rotation.
std::optional<Matrix3> axes_of(std::string_view word);

/// rad about the direction to the tip, positive from trocar to tip, against the frame that leans from "into
/// the screen" to that direction without a turn. `tool`: device frame from the tool's; `shaft`: the direction
/// to the tip in the tool's frame, one of its axes.
double roll_of(const Matrix3& tool, const Vector3& shaft) noexcept;

}  // namespace fulcrum::hapticd
