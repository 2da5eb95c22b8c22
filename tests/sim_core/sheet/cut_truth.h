// SPDX-License-Identifier: Apache-2.0
// Where tissue of a sheet is left, by its drawn triangles alone: what a blade is said to have done is held
// against it.
#pragma once

#include <array>
#include <cmath>

#include "sim_core/world/snapshot.h"

namespace fulcrum::test {

/// Whether there is tissue at a place at rest.
inline bool covered(const SheetView& sheet, double x, double y) {
    for (std::size_t t = 0; t < static_cast<std::size_t>(sheet.triangle_count); ++t) {
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] =
                sheet.rest[static_cast<std::size_t>(sheet.triangles[t][c])].head<2>() - Eigen::Vector2d(x, y);
        const auto turn_of = [&](std::size_t a, std::size_t b) {
            return p[a].x() * p[b].y() - p[a].y() * p[b].x();
        };
        const double u = turn_of(0, 1), v = turn_of(1, 2), w = turn_of(2, 0);
        if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
    }
    return false;
}

/// Whether tissue is left all around a place at rest: no blade has been there.
inline bool whole_around(const SheetView& sheet, const Vector3& place, double radius) {
    for (int k = 0; k < 17; ++k) {
        const double turn = 0.785398163397448 * k, size = k == 0 ? 0 : k < 9 ? 0.5 * radius : radius;
        const double x = place.x() + size * std::cos(turn), y = place.y() + size * std::sin(turn);
        if (!covered(sheet, x, y)) return false;
    }
    return true;
}

}  // namespace fulcrum::test
