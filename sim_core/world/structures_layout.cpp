// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/structures_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double step = 0.003;       // m between points of a line
constexpr double gradient = 0.0005;  // m, half of the way over which the wall's slope is taken
constexpr double turn = 6.283185307179586;
constexpr double winding = 90;  // rad/m, of a vein's wandering

int points_over(double length) {
    return std::max(2, static_cast<int>(std::ceil(length / step)) + 1);
}

std::array<double, 2> slope_at(const FieldWall& wall, double x, double y) {
    return {(wall.height(x + gradient, y) - wall.height(x - gradient, y)) / (2 * gradient),
            (wall.height(x, y + gradient) - wall.height(x, y - gradient)) / (2 * gradient)};
}

FieldBed lay_bed(const FieldWall& wall, double cell) {
    FieldBed bed;
    bed.pool.cell = cell;
    bed.pool.columns = std::max(2, static_cast<int>(std::ceil((wall.left - wall.right) / cell)));
    bed.pool.rows = std::max(2, static_cast<int>(std::ceil((wall.cranial - wall.caudal) / cell)));
    bed.corner = Vector3(0.5 * (wall.left + wall.right - cell * bed.pool.columns),
                         0.5 * (wall.caudal + wall.cranial - cell * bed.pool.rows), 0);
    for (int row = 0; row < bed.pool.rows; ++row) {
        for (int column = 0; column < bed.pool.columns; ++column) {
            const double x = bed.corner.x() + (column + 0.5) * cell, y = bed.corner.y() + (row + 0.5) * cell;
            bed.pool.ground.push_back(wall.height(x, y));
            bed.slope.push_back(slope_at(wall, x, y));
        }
    }
    return bed;
}

}  // namespace

Vector3 FieldWall::normal(double x, double y) const {
    const std::array<double, 2> slope = slope_at(*this, x, y);
    return Vector3(-slope[0], -slope[1], 1).normalized();
}

StructuresLayout place_structures(const StructuresSpec& spec, const FieldWall& wall, std::uint64_t seed) {
    StructuresLayout layout;
    layout.bed = lay_bed(wall, spec.cell);
    Random random(seed, 0x5E1A5U);
    const double middle = 0.5 * (wall.left + wall.right), length = wall.cranial - wall.caudal;
    const int points = points_over(length);

    // The long veins: x by the share of the way up.
    std::array<double, 3> phase{};
    const auto long_vein = [&](int vein, double y) {
        static constexpr int side[3] = {0, -1, 1};
        return middle + side[vein] * spec.vein_lateral +
               spec.wander * math::sin(phase[static_cast<std::size_t>(vein)] + winding * (y - wall.caudal));
    };
    for (int vein = 0; vein < 3; ++vein) {
        phase[static_cast<std::size_t>(vein)] = random.uniform(0, turn);
        VeinPlace place;
        place.radius = spec.vessel_radius;
        for (int i = 0; i < points; ++i) {
            const double y = wall.caudal + length * i / (points - 1);
            place.line.push_back(wall.point(long_vein(vein, y), y));
        }
        layout.veins.push_back(place);
    }
    for (int rung = 0; rung < spec.rungs; ++rung) {
        const double y =
            wall.caudal + length * (rung + 0.5) / spec.rungs + spec.wander * random.uniform(-1, 1);
        const double from = long_vein(1, y), to = long_vein(2, y), start = random.uniform(0, turn);
        VeinPlace place;
        place.radius = spec.rung_radius;
        const int across = points_over(to - from);
        for (int i = 0; i < across; ++i) {
            const double share = static_cast<double>(i) / (across - 1), x = from + share * (to - from);
            // It ends in the veins that it joins.
            const double bow = spec.wander * 4 * share * (1 - share);
            place.line.push_back(wall.point(x, y + bow * math::sin(start + winding * (x - from))));
        }
        layout.veins.push_back(place);
    }
    for (const int side : {-1, 1}) {
        std::vector<Vector3> line;
        for (int i = 0; i < points; ++i) {
            const double share = static_cast<double>(i) / (points - 1);
            const double x =
                middle + side * (spec.nerve_cranial + share * (spec.nerve_caudal - spec.nerve_cranial));
            const double y = wall.cranial - share * length;
            line.push_back(wall.point(x, y) + spec.nerve_height * wall.normal(x, y));
        }
        layout.nerves.push_back(line);
    }
    return layout;
}

}  // namespace fulcrum
