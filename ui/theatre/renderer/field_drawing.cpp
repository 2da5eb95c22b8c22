// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/field_drawing.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr double bed_thickness = 0.002;  // m
constexpr double outlet_radius = 0.002;
constexpr double least_blood = 0.0002;  // m, thinner films are not drawn
constexpr double darkest = 0.75;        // share of the light that smoke can take

void ball(SceneFrame& frame, const Vector3& centre, double radius, TargetLook look) {
    frame.targets.push_back({centre, radius, look, Hand::left});
}

}  // namespace

void FieldDrawing::lay_bed(const FieldView& view) {
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

// The blood's level over the bed, evened out between neighbours: a pool's edge is round. Where there is none
// it dips below the ground, so that the edge lies on it.
void FieldDrawing::lay_blood(const FieldView& view) {
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

void FieldDrawing::add(const FieldView& view, SceneFrame& frame) {
    lay_bed(view);
    // A wall that is drawn already needs no bed.
    if (!frame.enclosed)
        frame.sheets.push_back(bed_.drawn(bed_thickness, QVector3D(0.55F, 0.20F, 0.16F), 0.45F));
    nerves_.begin(view.nerves.size());
    for (const NerveView& seen : view.nerves) {
        Ribbon& nerve = nerves_.next();
        nerve.cord(seen.line, view.nerve_radius);
        frame.sheets.push_back(nerve.drawn(0, QVector3D(0.92F, 0.78F, 0.22F), 0.9F));
    }
    for (std::size_t i = 0; i < view.outlets.size(); ++i) {
        const OutletView& outlet = view.outlets[i];
        const bool trunk = outlet.band >= 0 && i % 2 == 0;
        if (outlet.clipped) {
            // What closes a trunk sits on its band, which is drawn with all its clips.
            if (!trunk) ball(frame, outlet.position, drawn_clip_radius, TargetLook::clip);
        } else if (outlet.flow > 0) {
            ball(frame, outlet.position, outlet_radius, TargetLook::bleeding);
        }
    }
    lay_blood(view);
    if (!blood_.triangles.empty())
        frame.sheets.push_back(blood_.drawn(0, QVector3D(0.17F, 0.004F, 0.008F), 1.0F));
    frame.brightness = 1 - darkest * view.smoke;
}

}  // namespace fulcrum::ui
