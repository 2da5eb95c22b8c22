// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/bands_drawing.h"

#include <algorithm>

namespace fulcrum::ui {
namespace {

constexpr double band_width = 0.006, band_thickness = 0.0016, bed_thickness = 0.002;  // m
constexpr double vessel_radius = 0.0014, outlet_radius = 0.002, clip_radius = 0.0018;
constexpr double least_blood = 0.0004;  // m, thinner films are not drawn
constexpr float charred = 0.35F;        // share of its water that a black segment has lost
constexpr double darkest = 0.75;        // share of the light that smoke can take

void ball(SceneFrame& frame, const Vector3& centre, double radius, TargetLook look) {
    frame.targets.push_back({centre, radius, look, Hand::left});
}

}  // namespace

void BandsDrawing::lay_bed(const BandsView& view) {
    if (!bed_.positions.empty()) return;
    for (int row = 0; row < view.rows; ++row) {
        for (int column = 0; column < view.columns; ++column) {
            const auto index = static_cast<std::size_t>(row * view.columns + column);
            const Vector3 place(view.corner.x() + (column + 0.5) * view.cell,
                                view.corner.y() + (row + 0.5) * view.cell,
                                static_cast<double>(view.ground[index]) - 0.5 * bed_thickness);
            bed_.positions.push_back(place);
            if (row == 0 || column == 0) continue;
            const std::int32_t d = row * view.columns + column, c = d - 1, b = d - view.columns, a = b - 1;
            bed_.triangles.push_back({a, b, d});
            bed_.triangles.push_back({a, d, c});
        }
    }
    bed_.rest = bed_.positions;
}

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
    lay_bed(view);
    bands_.resize(view.bands.size());
    const auto sheet = [&](const Ribbon& ribbon, double thickness) {
        DrawnSheet drawn;
        drawn.surface = {ribbon.positions.data(), ribbon.rest.data(),      ribbon.positions.size(),
                         ribbon.triangles.data(), ribbon.triangles.size(), thickness};
        frame.sheets.push_back(drawn);
    };
    sheet(bed_, bed_thickness);
    for (std::size_t b = 0; b < view.bands.size(); ++b) {
        const BandView& band = view.bands[b];
        lay_band(band, bands_[b]);
        sheet(bands_[b], band_thickness);
        for (std::size_t s = 0; s < strand_segments; ++s) {
            const Vector3 middle = 0.5 * (band.position[s] + band.position[s + 1]);
            if (band.char_share[s] > charred) {
                ball(frame, middle, 0.0018, TargetLook::charred);
            } else if (band.vessel >= 0 && s % 2 == 0) {
                ball(frame, middle, vessel_radius, TargetLook::vessel);
            }
        }
        if (band.clip_node >= 0)
            ball(frame, band.position[static_cast<std::size_t>(band.clip_node)], clip_radius,
                 TargetLook::clip);
    }
    for (const Vector3& point : view.nerve) ball(frame, point, view.nerve_radius, TargetLook::nerve);
    for (const OutletView& outlet : view.outlets) {
        if (outlet.clipped) {
            ball(frame, outlet.position, clip_radius, TargetLook::clip);
        } else if (outlet.flow > 0) {
            ball(frame, outlet.position, outlet_radius, TargetLook::bleeding);
        }
    }
    // Blood as flat caps of large balls: together they look like a pool.
    const double radius = 1.4 * view.cell;
    for (int row = 0; row < view.rows; ++row) {
        for (int column = 0; column < view.columns; ++column) {
            const auto index = static_cast<std::size_t>(row * view.columns + column);
            const auto depth = static_cast<double>(view.blood[index]);
            if (depth < least_blood) continue;
            const Vector3 centre(view.corner.x() + (column + 0.5) * view.cell,
                                 view.corner.y() + (row + 0.5) * view.cell,
                                 static_cast<double>(view.ground[index]) - radius + 0.35 * view.cell + depth);
            ball(frame, centre, radius, TargetLook::blood);
        }
    }
    frame.brightness = 1 - darkest * view.smoke;
}

}  // namespace fulcrum::ui
