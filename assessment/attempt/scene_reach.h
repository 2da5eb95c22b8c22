// SPDX-License-Identifier: Apache-2.0
// Where the handles of a task have to go.
#pragma once

#include <array>
#include <optional>

#include "assessment/attempt/engine.h"
#include "sim_core/instrument/workspace.h"

namespace fulcrum {

/// For each hand that has an instrument and something to reach.
using SceneReach = std::array<std::optional<WorkspaceBox>, hand_count>;

/// Box around the places of a hand's handle with which its tip is at what the task works on (its own targets,
/// else bowel, sheet, bands, structures and objects as they are at the start) and where it begins: from
/// there, in the frame of a device. What is further away than the instrument is long is left out.
SceneReach scene_reach(const Scene& scene, const WorldSnapshot& at_start);
inline SceneReach scene_reach(const AttemptEngine& engine) {
    return scene_reach(engine.scene(), engine.initial_snapshot());
}

}  // namespace fulcrum
