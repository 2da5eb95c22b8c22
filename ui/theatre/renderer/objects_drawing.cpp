// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/objects_drawing.h"

namespace fulcrum::ui {
namespace {

// As painted, sRGB: distinguished by brightness alone.
const QVector3D ring_hue(0.93F, 0.72F, 0.20F), peg_hue(0.62F, 0.66F, 0.70F);
const QVector3D tray_tint(0.05F, 0.075F, 0.095F);  // linear
constexpr int tray_columns = 26, tray_rows = 18;   // small enough for shadows at the vertices

}  // namespace

void ObjectsDrawing::lay_tray(const ObjectsView& view) {
    const Vector3 corner = view.centre - Vector3(view.half_length, view.half_width, 0);
    for (int row = 0; row <= tray_rows; ++row) {
        for (int column = 0; column <= tray_columns; ++column) {
            const Vector3 rest(2 * view.half_length * column / tray_columns,
                               2 * view.half_width * row / tray_rows, 0);
            rest_.push_back(rest);
            positions_.emplace_back(corner + rest);
        }
    }
    for (std::int32_t row = 0; row < tray_rows; ++row) {
        for (std::int32_t column = 0; column < tray_columns; ++column) {
            const std::int32_t a = row * (tray_columns + 1) + column, b = a + 1, c = a + tray_columns + 1,
                               d = c + 1;
            triangles_.push_back({a, b, d});
            triangles_.push_back({a, d, c});
        }
    }
}

void ObjectsDrawing::add(const ObjectsView& view, SceneFrame& frame) {
    frame.tubes.clear();
    if (view.objects.empty()) return;
    if (triangles_.empty()) lay_tray(view);
    DrawnSheet tray;
    tray.surface = {positions_.data(), rest_.data(),      positions_.size(),
                    triangles_.data(), triangles_.size(), 0.002};
    tray.tint = tray_tint;
    tray.tint_share = 0.96F;
    tray.relief = 0.2F;
    frame.sheets.push_back(tray);
    for (const PegView& peg : view.pegs) {
        const Vector3 end = peg.top - view.peg_radius * (peg.top - peg.foot).normalized();
        frame.tubes.push_back({peg.foot, end, view.peg_radius, peg_hue, -1});
    }
    const std::size_t count = view.corners.size();
    for (std::size_t i = 0; i < view.objects.size(); ++i) {
        const ObjectView& object = view.objects[i];
        for (std::size_t k = 0; k < count; ++k)
            frame.tubes.push_back({object.position + object.rotation * view.corners[k],
                                   object.position + object.rotation * view.corners[(k + 1) % count],
                                   view.tube_radius, ring_hue, static_cast<int>(i)});
    }
}

}  // namespace fulcrum::ui
