// SPDX-License-Identifier: Apache-2.0
// EXP2 and the tube's section under it: the formula, its fit to the linear law, bending and coupling of the
// section compared with a fine sum over the wall, its derivatives compared with differences.
#include "sim_core/material/section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum {
namespace {

const std::vector<WallLayer> plain = {{0.003, 30.0e3, 3.0}};

// Force and moment by strips across the section (chords), not by rings and angles: Simpson in y with the
// chord's width in closed form.
void strips(const std::vector<WallLayer>& layers, double outer_radius, double strain, double curvature,
            double& force, double& moment) {
    force = moment = 0;
    double outer = outer_radius;
    for (std::size_t k = layers.size(); k-- > 0;) {
        const double inner = outer - layers[k].thickness, young = layers[k].young, a = layers[k].exponent;
        // y = R sin(phi) removes the square root at the border.
        for (const double sign : {1.0, -1.0}) {
            const double radius = sign > 0 ? outer : inner;
            const int steps = 2000;
            for (int i = 0; i <= steps; ++i) {
                const double phi = -0.5 * std::acos(-1.0) + std::acos(-1.0) * i / steps;
                const double weight =
                    (i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2)) * std::acos(-1.0) / steps / 3;
                const double y = radius * std::sin(phi), width = 2 * radius * std::cos(phi),
                             dy = radius * std::cos(phi);
                const double e = strain + curvature * y, stress = young * e * std::exp(a * e * e);
                force += sign * weight * stress * width * dy;
                moment += sign * weight * stress * y * width * dy;
            }
        }
        outer = inner;
    }
}

TEST(Exp2Law, MatchesItsFormulaAndFitsTheLinearLaw) {
    const Exp2 law;
    for (int i = 1; i <= 50; ++i) {
        const double e = -0.5 + 0.02 * i, expected = 30.0e3 * e * std::exp(3 * e * e);
        EXPECT_NEAR(exp2_stress(law, e), expected, 1e-13 * std::fabs(expected) + 1e-12);
        EXPECT_NEAR(exp2_energy_density(law, e), 30.0e3 / 6 * std::expm1(3 * e * e), 1e-13 * 1e4);
        const double h = 1e-5;
        EXPECT_NEAR(exp2_tangent(law, e), (exp2_stress(law, e + h) - exp2_stress(law, e - h)) / (2 * h),
                    1e-3);
        EXPECT_NEAR(exp2_stress(law, e),
                    (exp2_energy_density(law, e + h) - exp2_energy_density(law, e - h)) / (2 * h), 1e-4);
    }
    // The best line through the origin on 0 to 20 % (least squares) is 32.3 kPa.
    double top = 0, bottom = 0;
    for (int i = 1; i <= 2000; ++i) {
        const double e = 0.2 * i / 2000;
        top += e * exp2_stress(law, e);
        bottom += e * e;
    }
    EXPECT_NEAR(top / bottom, 32.3e3, 0.01 * 32.3e3);
}

TEST(TubeSection, StretchAndBendingTogetherMatchAFineSumOverStrips) {
    for (const bool layered : {false, true}) {
        const std::vector<WallLayer> layers = layered ? bowel_wall_layers() : plain;
        const TubeSection section(layers, 0.016);
        EXPECT_GE(section.points(), 16);
        for (const double strain : {0.0, -0.15, 0.1, 0.3}) {
            for (const double curvature :
                 {1e-3, 3.0, 10.0, 25.0}) {  // up to 40 % strain of bending at the rim
                double force, moment;
                strips(layers, 0.016, strain, curvature, force, moment);
                const BendingResponse b = section.bending(strain, curvature * curvature);
                const double n = section.axial(strain).force + b.by_strain, m = 2 * curvature * b.by_square;
                // One radius a layer leaves the fourth moment of a thin ring, (t / R)^2 / 12.
                EXPECT_NEAR(m, moment, (layered ? 1e-3 : 1e-9) * std::fabs(moment))
                    << strain << " " << curvature;
                EXPECT_NEAR(n, force, (layered ? 1e-3 : 1e-9) * std::fabs(force) + 1e-12)
                    << strain << " " << curvature;
            }
        }
    }
}

TEST(TubeSection, IsTheLinearSectionAtRest) {
    for (const auto& layers : {plain, bowel_wall_layers(), std::vector<WallLayer>{{0.016, 30e3, 3}}}) {
        const TubeSection section(layers, 0.016);
        const TubeStiffness rest = tube_stiffness(layers, 0.016, 0.35);
        EXPECT_NEAR(section.axial(0).tangent, rest.axial, 1e-12 * rest.axial);
        EXPECT_NEAR(2 * section.bending(0, 0).by_square, rest.bending, 1e-12 * rest.bending);
        EXPECT_EQ(section.bending(0, 0).energy, 0);
        EXPECT_EQ(section.bending(0.1, -1e-20).energy, 0);
    }
}

TEST(TubeSection, TangentIsTheDifferenceOfTheResponse) {
    for (const bool layered : {false, true}) {
        const TubeSection section(layered ? bowel_wall_layers() : plain, 0.016);
        // Small, medium, and beyond the range of the series.
        for (const double strain : {-0.4, -0.05, 0.0, 0.2, 0.9}) {
            for (const double square : {0.01, 20.0, 900.0, 6000.0}) {
                const double h = 1e-4, k = 1e-3 * square;
                const BendingResponse at = section.bending(strain, square);
                const auto slope = [](double p1, double m1, double p2, double m2, double step) {
                    return (8 * (p1 - m1) - (p2 - m2)) / (12 * step);
                };
                const BendingResponse e1 = section.bending(strain + h, square),
                                      e2 = section.bending(strain - h, square),
                                      e3 = section.bending(strain + 2 * h, square),
                                      e4 = section.bending(strain - 2 * h, square);
                const BendingResponse x1 = section.bending(strain, square + k),
                                      x2 = section.bending(strain, square - k),
                                      x3 = section.bending(strain, square + 2 * k),
                                      x4 = section.bending(strain, square - 2 * k);
                const double scale = 1e-7, noise = 1e-11 * at.energy / h + 1e-13;
                EXPECT_NEAR(at.by_strain, slope(e1.energy, e2.energy, e3.energy, e4.energy, h),
                            scale * std::fabs(at.by_strain) + noise);
                EXPECT_NEAR(at.by_strain_strain,
                            slope(e1.by_strain, e2.by_strain, e3.by_strain, e4.by_strain, h),
                            scale * at.by_strain_strain + noise / h);
                EXPECT_NEAR(at.by_strain_square,
                            slope(e1.by_square, e2.by_square, e3.by_square, e4.by_square, h),
                            scale * std::fabs(at.by_strain_square) + 1e-11 * at.by_square / h);
                EXPECT_NEAR(at.by_square, slope(x1.energy, x2.energy, x3.energy, x4.energy, k),
                            scale * at.by_square);
                EXPECT_NEAR(at.by_strain_square,
                            slope(x1.by_strain, x2.by_strain, x3.by_strain, x4.by_strain, k),
                            scale * std::fabs(at.by_strain_square) + 1e-15);
                EXPECT_NEAR(at.by_square_square,
                            slope(x1.by_square, x2.by_square, x3.by_square, x4.by_square, k),
                            scale * at.by_square_square + 1e-11 * at.by_square / k);
            }
        }
    }
}

TEST(TubeSection, SeriesAndClosedFormsAgree) {
    // zeta passes 1 and v passes 1/2 continuously.
    const TubeSection section(plain, 0.016);
    BendingResponse before = section.bending(0.3, 100);
    for (double square = 100.1; square < 4000; square *= 1.001) {
        const BendingResponse at = section.bending(0.3, square);
        const double step = square * 0.001 / 1.001;
        EXPECT_NEAR(at.energy - before.energy, 0.5 * step * (at.by_square + before.by_square),
                    1e-6 * at.by_square * step);
        EXPECT_NEAR(at.by_square - before.by_square,
                    0.5 * step * (at.by_square_square + before.by_square_square),
                    1e-5 * at.by_square_square * step);
        before = at;
    }
}

}  // namespace
}  // namespace fulcrum
