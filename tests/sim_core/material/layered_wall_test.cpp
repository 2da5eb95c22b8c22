// SPDX-License-Identifier: Apache-2.0
// Layered wall: composite stiffness compared with the layered-beam formula (parallel axes), indentation
// compared with the laws solved by bisection, the palpable nodule, the puncture limit.
#include "sim_core/material/layered_wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double stress(double young, double exponent, double e) {
    return young * e * std::exp(exponent * e * e);
}

// Depth under a pressure by bisection of each layer's own law.
double reference_depth(const LayeredWallSpec& spec, double pressure, double nodule) {
    const double nu = spec.poisson_ratio, factor = (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const auto compressed = [&](double young, double exponent) {
        double low = 0, high = 50;
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (low + high);
            (factor * stress(young, exponent, middle) < pressure ? low : high) = middle;
        }
        return 0.5 * (low + high);
    };
    double depth = pressure / spec.backing;
    for (std::size_t k = 0; k < spec.layers.size(); ++k) {
        const WallLayer& layer = spec.layers[k];
        const double lump = k == 0 ? nodule : 0;
        depth += (layer.thickness - lump) * compressed(layer.young, layer.exponent);
        if (lump > 0) depth += lump * compressed(spec.nodule.young, spec.nodule.exponent);
    }
    return depth;
}

LayeredWallSpec with_nodule() {
    LayeredWallSpec spec;
    spec.nodule.height = 0.0005;
    spec.nodule.radius = 0.006;
    return spec;
}

// The layered beam by its textbook formula, E I = sum of E_k (I_own + A d^2) over small pieces of each layer
// with the axis where the sum of E A y vanishes; independent of the ring formula.
TEST(LayeredWall, CompositeStiffnessMatchesTheLayeredBeam) {
    const std::vector<WallLayer> layers = bowel_wall_layers();
    const double outer_radius = 0.016, poisson = 0.35;
    double ea = 0, ea_y = 0, ei = 0, gj = 0;
    const int angles = 720, shells = 200;
    for (const bool second : {false, true}) {
        const double axis = second ? ea_y / ea : 0;
        if (!second) ea = 0;
        double outer = outer_radius;
        for (std::size_t k = layers.size(); k-- > 0;) {
            const double inner = outer - layers[k].thickness;
            for (int r = 0; r < shells; ++r) {
                const double low = inner + (outer - inner) * r / shells,
                             high = inner + (outer - inner) * (r + 1) / shells;
                for (int t = 0; t < angles; ++t) {
                    // A piece as a small rectangle, turned.
                    const double angle = 2 * std::acos(-1.0) * (t + 0.5) / angles,
                                 middle = 0.5 * (low + high);
                    const double width = middle * 2 * std::acos(-1.0) / angles, height = high - low;
                    const double area = width * height, y = middle * std::sin(angle), s = std::sin(angle),
                                 c = std::cos(angle);
                    const double own = area / 12 * (height * height * s * s + width * width * c * c);
                    if (!second) {
                        ea += layers[k].young * area;
                        ea_y += layers[k].young * area * y;
                    } else {
                        ei += layers[k].young * (own + area * (y - axis) * (y - axis));
                        gj += layers[k].young / (2 * (1 + poisson)) * area * middle * middle;
                    }
                }
            }
            outer = inner;
        }
    }
    const TubeStiffness tube = tube_stiffness(layers, outer_radius, poisson);
    EXPECT_NEAR(tube.axial, ea, 1e-9 * ea);
    EXPECT_NEAR(tube.bending, ei, 1e-4 * ei);
    EXPECT_NEAR(tube.torsional, gj, 1e-4 * gj);
    // The provisional layers are those of a bowel of 32.3 kPa.
    const TubeStiffness whole = tube_stiffness({{0.003, 32.3e3, 3.0}}, outer_radius, poisson);
    EXPECT_NEAR(tube.axial, whole.axial, 0.01 * whole.axial);
    // One layer in four parts is one layer.
    const TubeStiffness parts =
        tube_stiffness({{0.001, 2e4, 3}, {0.0005, 2e4, 3}, {0.001, 2e4, 3}, {0.0005, 2e4, 3}}, 0.016, 0.3);
    const TubeStiffness one = tube_stiffness({{0.003, 2e4, 3}}, 0.016, 0.3);
    EXPECT_NEAR(parts.bending, one.bending, 1e-12 * one.bending);
    EXPECT_NEAR(parts.torsional, one.torsional, 1e-12 * one.torsional);
}

TEST(LayeredWall, DepthIsTheSumOfTheLayersUnderOnePressure) {
    const LayeredWallSpec spec = with_nodule();
    const LayeredWall wall(spec);
    for (const double pressure : {10.0, 1e3, 1e4, 1e5, 6e5, 3e6}) {
        for (const double nodule : {0.0, 0.0002, 0.0005}) {
            const double depth = reference_depth(spec, pressure, nodule);
            EXPECT_NEAR(wall.depth_at(pressure, nodule), depth, 1e-12 * depth) << pressure << " " << nodule;
            double found, slope;
            wall.pressure_at(depth, nodule, found, slope);
            EXPECT_NEAR(found, pressure, 2e-4 * pressure + 1e-3) << pressure << " " << nodule;
        }
    }
}

TEST(LayeredWall, StiffensWithDepthAndItsTangentIsTheSlope) {
    const LayeredWall wall(with_nodule());
    const double area = 2e-5;
    for (const double nodule : {0.0, 0.0005}) {
        double force = 0, first = 0;
        for (int i = 1; i <= 400; ++i) {
            const double depth = 1e-5 * i, h = 1e-8;
            const Indentation at = wall.indent(depth, area, infinity, nodule);
            EXPECT_GT(at.force, force) << i;
            const double slope = (wall.indent(depth + h, area, infinity, nodule).force -
                                  wall.indent(depth - h, area, infinity, nodule).force) /
                                 (2 * h);
            EXPECT_NEAR(at.stiffness, slope, 1e-5 * slope) << i;
            force = at.force;
            if (i == 1) first = at.stiffness;
        }
        // Not linear: at 1.5 mm it is much stiffer than at rest.
        EXPECT_GT(wall.indent(0.0015, area, infinity, nodule).stiffness, 1.3 * first);
    }
    EXPECT_EQ(wall.indent(0, area, infinity).force, 0);
    EXPECT_EQ(wall.indent(-1e-3, area, infinity).force, 0);
    EXPECT_EQ(wall.indent(std::numeric_limits<double>::quiet_NaN(), area, infinity).force, 0);
    EXPECT_TRUE(std::isfinite(wall.indent(1e3, area, infinity).force));
}

TEST(LayeredWall, NoduleUnderSoftMucosaRaisesTheForce) {
    const LayeredWall wall(with_nodule());
    const double area = 2e-5;
    double before = infinity;
    for (const double distance : {0.0, 0.002, 0.004, 0.006, 0.02}) {
        const double force = wall.indent(0.001, area, infinity, wall.nodule_height(distance)).force;
        EXPECT_LE(force, before) << distance;
        before = force;
    }
    const double over = wall.indent(0.001, area, infinity, wall.nodule_height(0)).force;
    const double beside = wall.indent(0.001, area, infinity, wall.nodule_height(0.02)).force;
    std::printf("force at 1 mm over 20 mm2: %.4f N beside the nodule, %.4f N over it\n", beside, over);
    RecordProperty("force_ratio", std::to_string(over / beside));
    EXPECT_GT(over, 1.05 * beside);
    EXPECT_EQ(wall.nodule_height(0.006), 0);
    EXPECT_EQ(wall.nodule_height(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(LayeredWall, PuncturesAtTheLimit) {
    const LayeredWall wall{LayeredWallSpec{}};
    const double area = 2e-5, limit = 10.3;
    double low = 0, high = 0.05;
    ASSERT_TRUE(wall.indent(high, area, limit).punctured);
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (wall.indent(middle, area, limit).punctured ? high : low) = middle;
    }
    EXPECT_NEAR(wall.indent(low, area, limit).force, limit, 1e-9);
    const Indentation torn = wall.indent(high + 1e-3, area, limit);
    EXPECT_EQ(torn.force, limit);
    EXPECT_EQ(torn.stiffness, 0);
    // The same force over less area punctures earlier.
    EXPECT_TRUE(wall.indent(low, 2 * area, limit).punctured);
}

TEST(LayeredWall, RefusesInvalidWalls) {
    const auto refused = [](auto change) {
        LayeredWallSpec spec = with_nodule();
        change(spec);
        EXPECT_THROW(LayeredWall{spec}, std::invalid_argument);
    };
    refused([](LayeredWallSpec& s) { s.layers.clear(); });
    refused([](LayeredWallSpec& s) { s.layers[0].thickness = 0; });
    refused([](LayeredWallSpec& s) { s.layers[1].young = -1; });
    refused([](LayeredWallSpec& s) { s.layers[2].exponent = 1e9; });
    refused([](LayeredWallSpec& s) { s.poisson_ratio = 0.5; });
    refused([](LayeredWallSpec& s) { s.backing = 0; });
    refused([](LayeredWallSpec& s) { s.nodule.height = 0.01; });
    refused([](LayeredWallSpec& s) { s.nodule.radius = 0; });
    refused([](LayeredWallSpec& s) { s.nodule_layer = 9; });
    EXPECT_THROW(tube_stiffness(bowel_wall_layers(), 0.002, 0.3), std::invalid_argument);
}

}  // namespace
}  // namespace fulcrum
