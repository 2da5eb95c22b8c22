// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/bands_drawing.h"

#include <algorithm>

#include "ui/theatre/renderer/field_drawing.h"

namespace fulcrum::ui {
namespace {

constexpr double band_width = 0.006, band_thickness = 0.0016;  // m
constexpr double vessel_radius = 0.0014;
constexpr float charred = 0.35F;  // share of its water that a black segment has lost

}  // namespace

void BandsDrawing::lay_band(const BandView& band, Ribbon& ribbon) const {
    ribbon.positions.resize(2 * strand_nodes);
    ribbon.rest.resize(ribbon.positions.size());
    ribbon.triangles.clear();
    for (int i = 0; i < strand_nodes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Vector3 along = band.position[static_cast<std::size_t>(std::min(i + 1, strand_segments))] -
                              band.position[static_cast<std::size_t>(std::max(i - 1, 0))];
        Vector3 across = Vector3::UnitZ().cross(along);
        across = across.norm() > 1e-9 ? Vector3(across.normalized()) : Vector3(Vector3::UnitY());
        ribbon.positions[2 * k] = band.position[k] - 0.5 * band_width * across;
        ribbon.positions[2 * k + 1] = band.position[k] + 0.5 * band_width * across;
        ribbon.rest[2 * k] = Vector3(0.002 * i, 0, 0);
        ribbon.rest[2 * k + 1] = Vector3(0.002 * i, band_width, 0);
        if (i + 1 == strand_nodes || (band.parted >> static_cast<unsigned>(i) & 1U) != 0) continue;
        const std::int32_t a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
        ribbon.triangles.push_back({a, c, d});
        ribbon.triangles.push_back({a, d, b});
    }
}

void BandsDrawing::add(const BandsView& view, SceneFrame& frame) {
    ribbons_.begin(view.bands.size() * (1 + strand_segments));
    const Vector3 above(0, 0, 0.5 * band_thickness);
    for (const BandView& band : view.bands) {
        Ribbon& flat = ribbons_.next();
        lay_band(band, flat);
        frame.sheets.push_back(flat.drawn(band_thickness, QVector3D(0.85F, 0.62F, 0.50F), 0.25F));
        for (std::size_t s = 0; s < strand_segments; ++s) {
            const bool burnt = band.char_share[s] > charred;
            if ((band.parted >> s & 1U) != 0 || (!burnt && band.vessel < 0)) continue;
            way_ = {band.position[s] + above, band.position[s + 1] + above};
            Ribbon& mark = ribbons_.next();
            mark.strip(way_, burnt ? 1.05 * band_width : 2 * vessel_radius);
            frame.sheets.push_back(burnt ? mark.drawn(0.0006, QVector3D(0.02F, 0.015F, 0.012F), 0.93F)
                                         : mark.drawn(vessel_radius, QVector3D(0.30F, 0.015F, 0.03F), 1.0F));
        }
        for (std::size_t n = 0; n < strand_nodes; ++n) {
            if ((band.clips >> n & 1U) != 0)
                frame.targets.push_back({band.position[n], drawn_clip_radius, TargetLook::clip, Hand::left});
        }
    }
}

}  // namespace fulcrum::ui
