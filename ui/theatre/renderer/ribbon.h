// SPDX-License-Identifier: GPL-3.0-or-later
// Strips and cords of triangles along a way, as sheets of a frame. UI thread.
#pragma once

#include <vector>

#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

struct Ribbon {
    std::vector<Vector3> positions, rest;  ///< m
    std::vector<Triangle> triangles;

    /// A strip along a way, flat side up; m.
    void strip(const std::vector<Vector3>& way, double width);
    /// A round cord along a way, whichever side is up; m.
    void cord(const std::vector<Vector3>& way, double radius);
    /// Points into this ribbon, which stays where it is until the frame is drawn.
    DrawnSheet drawn(double thickness, const QVector3D& tint, float share) const;
};

/// The ribbons of one frame; the next frame uses their memory again.
class Ribbons {
  public:
    /// Before the first next(): the frame points at them, so they must not move.
    void begin(std::size_t most);
    Ribbon& next();

  private:
    std::vector<Ribbon> ribbons_;
    std::size_t used_ = 0;
};

}  // namespace fulcrum::ui
