// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/bands_drawing.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr double band_width = 0.006, band_thickness = 0.0016, bed_thickness = 0.002;  // m
constexpr double vessel_radius = 0.0014, outlet_radius = 0.002, clip_radius = 0.0018;
constexpr double shown_of_vein = 0.85;  // of its radius: the rest lies beneath
constexpr double least_blood = 0.0002;  // m, thinner films are not drawn
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

void BandsDrawing::lay_strip(const std::vector<Vector3>& way, double width, Ribbon& ribbon) {
    ribbon.positions.clear();
    ribbon.rest.clear();
    ribbon.triangles.clear();
    double reached = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const Vector3 along = way[std::min(i + 1, way.size() - 1)] - way[i == 0 ? 0 : i - 1];
        Vector3 across = Vector3::UnitZ().cross(along);
        across = across.norm() > 1e-9 ? Vector3(across.normalized()) : Vector3(Vector3::UnitY());
        if (i > 0) reached += (way[i] - way[i - 1]).norm();
        for (const double side : {-0.5, 0.5}) {
            ribbon.positions.push_back(way[i] + side * width * across);
            ribbon.rest.emplace_back(reached, side * width, 0);
        }
        if (i == 0) continue;
        const auto d = static_cast<std::int32_t>(2 * i + 1), c = d - 1, b = d - 2, a = d - 3;
        ribbon.triangles.push_back({a, c, d});
        ribbon.triangles.push_back({a, d, b});
    }
}

void BandsDrawing::lay_cord(const std::vector<Vector3>& way, double radius, Ribbon& ribbon) {
    constexpr int around = 7;  // the last lies on the first: the texture's seam
    ribbon.positions.clear();
    ribbon.rest.clear();
    ribbon.triangles.clear();
    Vector3 across = Vector3::UnitX();
    double reached = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const Vector3 along = (way[std::min(i + 1, way.size() - 1)] - way[i == 0 ? 0 : i - 1]).normalized();
        // Carried on from the point before, so that the cord is not twisted.
        across -= along * along.dot(across);
        if (across.norm() < 1e-6) across = along.unitOrthogonal();
        across.normalize();
        const Vector3 up = along.cross(across);
        if (i > 0) reached += (way[i] - way[i - 1]).norm();
        for (int k = 0; k < around; ++k) {
            const double turn = 2 * 3.14159265358979323846 * k / (around - 1);
            ribbon.positions.push_back(way[i] + radius * (std::cos(turn) * across + std::sin(turn) * up));
            ribbon.rest.emplace_back(reached, radius * turn, 0);
            if (i == 0 || k == 0) continue;
            const auto d = static_cast<std::int32_t>(ribbon.positions.size()) - 1, c = d - 1, b = d - around,
                       a = b - 1;
            ribbon.triangles.push_back({a, d, b});
            ribbon.triangles.push_back({a, c, d});
        }
    }
}

// The blood's level over the bed, evened out between neighbours: a pool's edge is round. Where there is none
// it dips below the ground, so that the edge lies on it.
void BandsDrawing::lay_blood(const BandsView& view) {
    blood_.positions = bed_.positions;
    blood_.rest = bed_.rest;
    blood_.triangles.clear();
    constexpr double steep = 4;  // of the pool's edge
    wet_.assign(blood_.positions.size(), 0);
    depth_.assign(view.blood.begin(), view.blood.end());
    for (int pass = 0; pass < 2; ++pass) {
        before_ = depth_;
        for (int row = 0; row < view.rows; ++row) {
            for (int column = 0; column < view.columns; ++column) {
                const auto at = [&](int r, int c) {
                    return before_[static_cast<std::size_t>(std::clamp(r, 0, view.rows - 1) * view.columns +
                                                            std::clamp(c, 0, view.columns - 1))];
                };
                depth_[static_cast<std::size_t>(row * view.columns + column)] =
                    0.4 * at(row, column) + 0.15 * (at(row - 1, column) + at(row + 1, column) +
                                                    at(row, column - 1) + at(row, column + 1));
            }
        }
    }
    for (std::size_t i = 0; i < wet_.size(); ++i) {
        wet_[i] = depth_[i] >= least_blood ? 1 : 0;
        blood_.positions[i].z() =
            static_cast<double>(view.ground[i]) + std::min(depth_[i], steep * (depth_[i] - least_blood));
    }
    const auto wet = [this](std::int32_t v) { return wet_[static_cast<std::size_t>(v)] != 0; };
    for (const Triangle& triangle : bed_.triangles) {
        if (std::any_of(triangle.begin(), triangle.end(), wet)) blood_.triangles.push_back(triangle);
    }
}

BandsDrawing::Ribbon& BandsDrawing::strip() {
    return strips_[strips_used_++];
}

void BandsDrawing::add(const BandsView& view, SceneFrame& frame) {
    lay_bed(view);
    bands_.resize(view.bands.size());
    strips_used_ = 0;
    // Room for all strips first: what the frame points at must stay where it is.
    strips_.resize(std::max(strips_.size(),
                            view.bands.size() * strand_segments + view.nerves.size() + view.veins.size()));
    const auto sheet = [&](const Ribbon& ribbon, double thickness, const QVector3D& tint, float share) {
        DrawnSheet drawn;
        drawn.surface = {ribbon.positions.data(), ribbon.rest.data(),      ribbon.positions.size(),
                         ribbon.triangles.data(), ribbon.triangles.size(), thickness};
        drawn.tint = tint;
        drawn.tint_share = share;
        frame.sheets.push_back(drawn);
    };
    const Vector3 above(0, 0, 0.5 * band_thickness);
    // A wall that is drawn already needs no bed; its veins shine through it, blue.
    if (!frame.enclosed) sheet(bed_, bed_thickness, QVector3D(0.55F, 0.20F, 0.16F), 0.45F);
    for (const VeinView& vein : view.veins) {
        Ribbon& blue = strip();
        lay_cord(vein.line, shown_of_vein * vein.radius, blue);
        sheet(blue, 0, QVector3D(0.07F, 0.12F, 0.40F), 0.85F);
    }
    for (std::size_t b = 0; b < view.bands.size(); ++b) {
        const BandView& band = view.bands[b];
        lay_band(band, bands_[b]);
        sheet(bands_[b], band_thickness, QVector3D(0.85F, 0.62F, 0.50F), 0.25F);
        for (std::size_t s = 0; s < strand_segments; ++s) {
            const bool burnt = band.char_share[s] > charred;
            if ((band.parted >> s & 1U) != 0 || (!burnt && band.vessel < 0)) continue;
            way_ = {band.position[s] + above, band.position[s + 1] + above};
            Ribbon& mark = strip();
            lay_strip(way_, burnt ? 1.05 * band_width : 2 * vessel_radius, mark);
            if (burnt) {
                sheet(mark, 0.0006, QVector3D(0.02F, 0.015F, 0.012F), 0.93F);
            } else {
                sheet(mark, vessel_radius, QVector3D(0.30F, 0.015F, 0.03F), 1.0F);
            }
        }
        if (band.clip_node >= 0)
            ball(frame, band.position[static_cast<std::size_t>(band.clip_node)], clip_radius,
                 TargetLook::clip);
    }
    for (const NerveView& seen : view.nerves) {
        Ribbon& nerve = strip();
        lay_cord(seen.line, view.nerve_radius, nerve);
        sheet(nerve, 0, QVector3D(0.92F, 0.78F, 0.22F), 0.9F);
    }
    for (const OutletView& outlet : view.outlets) {
        if (outlet.clipped) {
            ball(frame, outlet.position, clip_radius, TargetLook::clip);
        } else if (outlet.flow > 0) {
            ball(frame, outlet.position, outlet_radius, TargetLook::bleeding);
        }
    }
    lay_blood(view);
    if (!blood_.triangles.empty()) sheet(blood_, 0, QVector3D(0.17F, 0.004F, 0.008F), 1.0F);
    frame.brightness = 1 - darkest * view.smoke;
}

}  // namespace fulcrum::ui
