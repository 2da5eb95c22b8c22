// SPDX-License-Identifier: Apache-2.0
// The accuracy rows of docs/QUALITY.md: the same cases that `fulcrum lab validate` prints, each within its
// tolerance.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/lab/catenary.h"
#include "sim_core/lab/validation_rooms.h"

namespace fulcrum::lab {
namespace {

void expect_passed(const std::vector<ValidationCase>& cases, std::size_t least) {
    EXPECT_GE(cases.size(), least);
    for (const ValidationCase& c : cases) {
        EXPECT_TRUE(c.passed) << c.model << ": " << c.name << ": " << c.quantity << " is " << c.value
                              << ", reference " << c.reference << ", error " << c.error << ' ' << c.error_unit
                              << ", tolerance " << c.tolerance;
        EXPECT_FALSE(c.source.empty()) << c.name;
        EXPECT_TRUE(std::isfinite(c.value)) << c.name;
    }
}

TEST(Validation, Rod) {
    expect_passed(rod_validation(), 16);
}
TEST(Validation, RodConstraints) {
    expect_passed(rod_constraint_validation(), 6);
}
TEST(Validation, LawsAndLayersOfTheWall) {
    expect_passed(material_validation(), 10);
}
TEST(Validation, Skinning) {
    expect_passed(skinning_validation(), 11);
}
TEST(Validation, Filter) {
    expect_passed(filter_validation(), 5);
}
TEST(Validation, Membrane) {
    expect_passed(membrane_validation(), 6);
}
TEST(Validation, Haptics) {
    expect_passed(haptic_validation(), 4);
}
TEST(Validation, Buckling) {
    expect_passed(buckling_validation(), 4);
}

TEST(ValidationCase, FailsOutsideItsToleranceAndOnNaN) {
    EXPECT_TRUE(relative_case("m", "n", "q", 1.01, 1, "s", 0.02).passed);
    EXPECT_FALSE(relative_case("m", "n", "q", 1.03, 1, "s", 0.02).passed);
    EXPECT_FALSE(relative_case("m", "n", "q", std::nan(""), 1, "s", 0.02).passed);
    EXPECT_FALSE(absolute_case("m", "n", "q", 0.1, 0, "s", 0.05).passed);
    EXPECT_TRUE(absolute_case("m", "n", "q", 0.1, 0, "s", 0.05, 4).passed);
}

TEST(Catenary, StiffChainIsTheHyperbolicCosine) {
    Catenary catenary;
    catenary.axial_stiffness = 1e12;
    const double tension = catenary_tension(catenary), a = tension / catenary.weight;
    EXPECT_NEAR(2 * a * std::sinh(catenary.span / (2 * a)), catenary.length, 1e-9);
    EXPECT_NEAR(catenary_point(catenary, tension, 0.5).z, -a * (std::cosh(catenary.span / (2 * a)) - 1),
                1e-9);
}

}  // namespace
}  // namespace fulcrum::lab
