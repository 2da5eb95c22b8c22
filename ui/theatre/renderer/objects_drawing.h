// SPDX-License-Identifier: GPL-3.0-or-later
// Rings, pegs and tray as the renderer draws them.
#pragma once

#include <vector>

#include "sim_core/world/part/objects_view.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

class ObjectsDrawing {
  public:
    /// Adds them to a frame, which points into this object until the next call.
    void add(const ObjectsView& view, SceneFrame& frame);

  private:
    void lay_tray(const ObjectsView& view);

    std::vector<Vector3> positions_, rest_;
    std::vector<Triangle> triangles_;
};

}  // namespace fulcrum::ui
