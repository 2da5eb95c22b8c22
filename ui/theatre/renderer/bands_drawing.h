// SPDX-License-Identifier: GPL-3.0-or-later
// Bands, bed, nerve, vessels and blood of a snapshot as sheets and balls of a frame. UI thread.
#pragma once

#include <vector>

#include "sim_core/world/bands_view.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

class BandsDrawing {
  public:
    /// Adds to the frame's sheets and targets, and lets smoke dim its light. What it adds points into this
    /// object until the next call.
    void add(const BandsView& view, SceneFrame& frame);

  private:
    struct Ribbon {
        std::vector<Vector3> positions, rest;
        std::vector<Triangle> triangles;
    };
    void lay_bed(const BandsView& view);
    void lay_band(const BandView& band, Ribbon& ribbon) const;
    Ribbon bed_;
    std::vector<Ribbon> bands_;
};

}  // namespace fulcrum::ui
