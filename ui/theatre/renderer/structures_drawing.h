// SPDX-License-Identifier: GPL-3.0-or-later
// Veins beneath a wall as sheets of a frame. UI thread.
#pragma once

#include "sim_core/world/part/structures_view.h"
#include "ui/theatre/renderer/ribbon.h"

namespace fulcrum::ui {

class StructuresDrawing {
  public:
    /// What it adds points into this object until the next call.
    void add(const StructuresView& view, SceneFrame& frame);

  private:
    Ribbons veins_;
};

}  // namespace fulcrum::ui
