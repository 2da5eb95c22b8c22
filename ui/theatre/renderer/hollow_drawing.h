// SPDX-License-Identifier: GPL-3.0-or-later
// The sacral hollow to be drawn: the presacral fascia and the walls that close the pelvis round about it, the
// rectum in its mesorectal envelope, the septa between as fibres and fat, char on what energy divided.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/anatomy/rectum.h"
#include "sim_core/scene/scene.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

class HollowDrawing {
  public:
    /// A scene with a rectum and a presacral wall.
    HollowDrawing(const Scene& scene, const WorldSnapshot& first);
    /// Adds to the frame's sheets. What it adds points into this object and the snapshot until the next call.
    void add(const WorldSnapshot& snapshot, SceneFrame& frame);

  private:
    struct Surface {
        std::vector<Vector3> positions, rest;
        std::vector<Triangle> triangles;
        std::uint64_t version = 0;
    };
    void lay_walls(const RectumParameters& rectum);
    void lay_envelope(const WorldSnapshot& snapshot);
    void learn_septa(const SheetView& view);
    void blacken(const WorldSnapshot& snapshot);
    static DrawnSheet drawn(const Surface& surface, SheetWear wear);

    Surface fascia_, walls_, envelope_;
    double skin_radius_, mesorectum_;  // m
    std::vector<double> septum_at_;    // m along the rectum, caudal first
    // Places of the septa's vertices as they were made, on a grid of rest coordinates, and which triangles
    // meet there.
    double grid_x_ = 0, grid_y_ = 0, lowest_ = 0;  // m
    int grid_columns_ = 0, grid_rows_ = 0;
    std::vector<std::vector<std::int32_t>> triangles_at_;
    std::vector<float> char_at_, burnt_;
};

}  // namespace fulcrum::ui
