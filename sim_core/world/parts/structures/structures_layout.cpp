// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/structures/structures_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double step = 0.003;        // m between points of a vein
constexpr double nerve_step = 0.004;  // m between points of a nerve
constexpr double gradient = 0.0005;   // m, half of the way over which the wall's slope is taken
constexpr double turn = 6.283185307179586;
constexpr double winding = 90;      // rad/m, of a vein's wandering
constexpr double spreading = 0.25;  // m/s at which blood evens out between cells; provisional
constexpr double followed = 1.25;   // rad about the rectum to which blood is followed on the fascia

int points_over(double length, double by) {
    return std::max(2, static_cast<int>(std::ceil(length / by)) + 1);
}

std::array<double, 2> slope_at(const FieldWall& wall, double x, double y) {
    return {(wall.height(x + gradient, y) - wall.height(x - gradient, y)) / (2 * gradient),
            (wall.height(x, y + gradient) - wall.height(x, y - gradient)) / (2 * gradient)};
}

FieldBed lay_bed(const FieldWall& wall, double cell) {
    FieldBed bed;
    bed.pool.cell = cell;
    bed.pool.spread_time = cell / spreading;
    bed.pool.columns = std::max(2, static_cast<int>(std::ceil((wall.left - wall.right) / cell)));
    bed.pool.rows = std::max(2, static_cast<int>(std::ceil((wall.high - wall.low) / cell)));
    bed.corner = Vector3(0.5 * (wall.left + wall.right - cell * bed.pool.columns),
                         0.5 * (wall.low + wall.high - cell * bed.pool.rows), 0);
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

FieldWall presacral_wall(const SacralCurve& curve, double length) {
    FieldWall wall;
    const double radius = curve.fascia_radius();
    wall.cranial = length;
    wall.left = radius * math::sin(followed);
    wall.right = -wall.left;
    const double ring = curve.curve_radius + radius;
    wall.low = curve.centre.y() + ring * math::sin(curve.angle(0));
    wall.high = curve.centre.y() + ring * math::sin(curve.angle(length));
    wall.point = [curve, radius](double along, double across, double above) {
        return curve.point(along, across / radius, above);
    };
    // A torus from inside: its ring about the curve's centre, the fascia about the ring.
    wall.height = [curve, radius](double x, double y) {
        const double out = curve.curve_radius + std::sqrt(std::max(0.0, radius * radius - x * x));
        const double aside = y - curve.centre.y();
        return curve.centre.z() - std::sqrt(std::max(0.0, out * out - aside * aside));
    };
    return wall;
}

StructuresLayout place_structures(const StructuresSpec& spec, const FieldWall& wall, std::uint64_t seed) {
    StructuresLayout layout;
    layout.bed = lay_bed(wall, spec.cell);
    Random random(seed, 0x5E1A5U);
    const double length = wall.cranial - wall.caudal;

    // The long veins: how far from the middle, by the way along the wall.
    std::array<double, 3> phase{};
    const auto long_vein = [&](int vein, double along) {
        static constexpr int side[3] = {0, -1, 1};
        return side[vein] * spec.vein_lateral +
               spec.wander *
                   math::sin(phase[static_cast<std::size_t>(vein)] + winding * (along - wall.caudal));
    };
    const int points = points_over(length, step);
    for (int vein = 0; vein < 3; ++vein) {
        phase[static_cast<std::size_t>(vein)] = random.uniform(0, turn);
        VeinPlace place;
        place.radius = spec.vessel_radius;
        for (int i = 0; i < points; ++i) {
            const double along = wall.caudal + length * i / (points - 1);
            place.line.push_back(wall.point(along, long_vein(vein, along), 0));
        }
        layout.veins.push_back(place);
    }
    for (int rung = 0; rung < spec.rungs; ++rung) {
        const double along =
            wall.caudal + length * (rung + 0.5) / spec.rungs + spec.wander * random.uniform(-1, 1);
        const double from = long_vein(1, along), to = long_vein(2, along), start = random.uniform(0, turn);
        VeinPlace place;
        place.radius = spec.rung_radius;
        const int across = points_over(to - from, step);
        for (int i = 0; i < across; ++i) {
            const double share = static_cast<double>(i) / (across - 1), x = from + share * (to - from);
            // It ends in the veins that it joins.
            const double bow = spec.wander * 4 * share * (1 - share);
            place.line.push_back(wall.point(along + bow * math::sin(start + winding * (x - from)), x, 0));
        }
        layout.veins.push_back(place);
    }
    const int nerve_points = points_over(length, nerve_step);
    for (const int side : {-1, 1}) {
        std::vector<Vector3> line;
        for (int i = 0; i < nerve_points; ++i) {
            const double share = static_cast<double>(i) / (nerve_points - 1);
            const double across = spec.nerve_caudal + share * (spec.nerve_cranial - spec.nerve_caudal);
            line.push_back(wall.point(wall.caudal + share * length, side * across, spec.nerve_height));
        }
        layout.nerves.push_back(line);
    }
    return layout;
}

}  // namespace fulcrum
