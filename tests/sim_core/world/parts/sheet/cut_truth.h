// SPDX-License-Identifier: Apache-2.0
// Where tissue of a sheet is left, by its drawn triangles alone: what a blade is said to have done is held
// against it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

/// Across the marked line of a sheet, column by column, between two places along it and two across: how much
/// of it is parted, and the longest stretch that is parted though no way (from, to along the line, m) leads
/// over it.
struct PartedLine {
    double parted = 0, longest_untold = 0;  ///< m
    double untold_at = 0;                   ///< m along the line, the end of that stretch
};
inline PartedLine parted_line(const SheetView& sheet, std::array<double, 2> along,
                              std::array<double, 2> across, const std::vector<std::array<double, 2>>& ways) {
    constexpr double column_width = 0.0004, spacing = 0.0001;
    PartedLine line;
    double untold = 0;
    for (double x = along[0] + 0.5 * column_width; x < along[1]; x += column_width) {
        bool parted = false;
        for (double y = across[0]; y < across[1] && !parted; y += spacing) parted = !covered(sheet, x, y);
        const bool told = std::any_of(ways.begin(), ways.end(), [&](const std::array<double, 2>& way) {
            return std::min(way[0], way[1]) <= x && std::max(way[0], way[1]) >= x;
        });
        line.parted += parted ? column_width : 0;
        untold = parted && !told ? untold + column_width : 0;
        if (untold <= line.longest_untold) continue;
        line.longest_untold = untold;
        line.untold_at = x;
    }
    return line;
}

}  // namespace fulcrum::test
