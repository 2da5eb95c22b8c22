// SPDX-License-Identifier: GPL-3.0-or-later
// Cups of camera targets as the renderer draws them.
#pragma once

#include "sim_core/world/part/camera_targets_view.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

class CupsDrawing {
  public:
    /// Adds the cups to a frame: a wall of staves with a rim, open towards the lens that is to look in.
    void add(const CameraTargetsView& view, SceneFrame& frame) const;
};

}  // namespace fulcrum::ui
