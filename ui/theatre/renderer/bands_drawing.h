// SPDX-License-Identifier: GPL-3.0-or-later
// Bands, bed, nerve, vessels and blood of a snapshot as sheets and balls of a frame. UI thread.
#pragma once

#include <vector>

#include "sim_core/world/part/bands_view.h"
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
    /// A strip along a way, flat side up.
    static void lay_strip(const std::vector<Vector3>& way, double width, Ribbon& ribbon);
    /// A round cord along a way, whichever side is up.
    static void lay_cord(const std::vector<Vector3>& way, double radius, Ribbon& ribbon);
    void lay_blood(const BandsView& view);
    Ribbon& strip();
    Ribbon bed_, blood_;
    std::vector<Ribbon> bands_, strips_;
    std::size_t strips_used_ = 0;
    std::vector<Vector3> way_;
    std::vector<char> wet_;
    std::vector<double> depth_, before_;  // m of blood, evened out
};

}  // namespace fulcrum::ui
