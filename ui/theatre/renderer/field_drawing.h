// SPDX-License-Identifier: GPL-3.0-or-later
// Bed, nerves, bleeding vessels, clips on them, blood and smoke of a snapshot as sheets and balls of a frame.
// UI thread.
#pragma once

#include <vector>

#include "sim_core/world/part/field_view.h"
#include "ui/theatre/renderer/ribbon.h"

namespace fulcrum::ui {

constexpr double drawn_clip_radius = 0.0018;  // m

class FieldDrawing {
  public:
    /// Adds to the frame's sheets and targets, and lets smoke dim its light. What it adds points into this
    /// object until the next call.
    void add(const FieldView& view, SceneFrame& frame);

  private:
    void lay_bed(const FieldView& view);
    void lay_blood(const FieldView& view);
    Ribbon bed_, blood_;
    Ribbons nerves_;
    std::vector<char> wet_;
    std::vector<double> depth_, before_;  // m of blood, evened out
};

}  // namespace fulcrum::ui
