// SPDX-License-Identifier: GPL-3.0-or-later
// Bands with the vessels, scorch marks and clips on them as sheets and balls of a frame. UI thread.
#pragma once

#include <vector>

#include "sim_core/world/part/bands_view.h"
#include "ui/theatre/renderer/ribbon.h"

namespace fulcrum::ui {

class BandsDrawing {
  public:
    /// What it adds points into this object until the next call.
    void add(const BandsView& view, SceneFrame& frame);

  private:
    void lay_band(const BandView& band, Ribbon& ribbon) const;
    Ribbons ribbons_;
    std::vector<Vector3> way_;
};

}  // namespace fulcrum::ui
