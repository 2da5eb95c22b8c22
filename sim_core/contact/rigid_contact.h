// SPDX-License-Identifier: Apache-2.0
// Contact of a tool with rigid objects: targets and the wall. Haptic thread, no allocation.
#pragma once

#include "sim_core/contact/tool_contact.h"

namespace fulcrum {

/// Tip against the rigid spheres of the model: target_force, target, target_distance.
void touch_targets(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                   ToolContactResult& result);

/// The last few centimetres of the shaft against the static wall: sets wall_force. Walks on the immutable
/// cavity from the triangle of the previous tick, or from the model's seed.
void touch_wall(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                ToolContactState& state, ToolContactResult& result);

/// World side: finds the seed for touch_wall, within reach (m) of the tip; no cavity: none.
void seed_wall(const CavityModel* cavity, const ToolKinematics& tool, double reach, LocalModel& model);

}  // namespace fulcrum
