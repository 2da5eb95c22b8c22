// SPDX-License-Identifier: Apache-2.0
// Remaining tissue of a sheet, derived from its drawn triangles only: the reported cuts are compared with it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim_core/world/part/snapshot.h"

namespace fulcrum::test {

/// True if there is tissue at a rest position.
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

/// True if there is tissue all around a rest position: no blade has been there.
inline bool whole_around(const SheetView& sheet, const Vector3& place, double radius) {
    for (int k = 0; k < 17; ++k) {
        const double turn = 0.785398163397448 * k, size = k == 0 ? 0 : k < 9 ? 0.5 * radius : radius;
        const double x = place.x() + size * std::cos(turn), y = place.y() + size * std::sin(turn);
        if (!covered(sheet, x, y)) return false;
    }
    return true;
}

/// Across the marked line of a sheet, column by column, between two positions along it and two across: the
/// divided length, and the longest divided stretch that no reported path (from, to along the line, m) covers.
struct PartedLine {
    double parted = 0, longest_unreported = 0;  ///< m
    double unreported_at = 0;                   ///< m along the line, the end of that stretch
};
inline PartedLine parted_line(const SheetView& sheet, std::array<double, 2> along,
                              std::array<double, 2> across, const std::vector<std::array<double, 2>>& paths) {
    constexpr double column_width = 0.0004, spacing = 0.0001;
    PartedLine line;
    double unreported = 0;
    for (double x = along[0] + 0.5 * column_width; x < along[1]; x += column_width) {
        bool parted = false;
        for (double y = across[0]; y < across[1] && !parted; y += spacing) parted = !covered(sheet, x, y);
        const bool reported = std::any_of(paths.begin(), paths.end(), [&](const std::array<double, 2>& path) {
            return std::min(path[0], path[1]) <= x && std::max(path[0], path[1]) >= x;
        });
        line.parted += parted ? column_width : 0;
        unreported = parted && !reported ? unreported + column_width : 0;
        if (unreported <= line.longest_unreported) continue;
        line.longest_unreported = unreported;
        line.unreported_at = x;
    }
    return line;
}

}  // namespace fulcrum::test
