// SPDX-License-Identifier: Apache-2.0
// Course of veins and nerves: on the wall, in front of it, as given by the scene; reproducible for a seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/parts/structures/structures_layout.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

SacralCurve curve() {
    return {Vector3(0, -0.07, 0.079), 0.123, -0.26, 0.015, 0.018};
}
constexpr double rectum = 0.12;

TEST(StructuresLayout, WallOfASacralHollowIsATorusFromInside) {
    const SacralCurve c = curve();
    const FieldWall wall = presacral_wall(c, rectum);
    for (double along = 0; along <= rectum; along += 0.0113) {
        for (double across = -0.04; across <= 0.0401; across += 0.0079) {
            const Vector3 p = wall.point(along, across, 0);
            EXPECT_NEAR(wall.height(p.x(), p.y()), p.z(), 1e-12);
            // In front of it, towards the centre line.
            const Vector3 above = wall.point(along, across, 0.004);
            EXPECT_NEAR((above - p).norm(), 0.004, 1e-12);
            EXPECT_NEAR((above - c.centre_line(along)).norm(), c.fascia_radius() - 0.004, 1e-12);
        }
    }
    const Vector3 low = wall.point(0, 0, 0), high = wall.point(rectum, 0, 0);
    EXPECT_NEAR(low.y(), wall.low, 1e-12);
    EXPECT_NEAR(high.y(), wall.high, 1e-12);
}

TEST(StructuresLayout, VeinsFollowTheWallAndRungsEndInTheLongVeins) {
    const FieldWall wall = presacral_wall(curve(), rectum);
    const StructuresSpec spec;
    const StructuresLayout layout = place_structures(spec, wall, 3);
    ASSERT_EQ(layout.veins.size(), 3U + static_cast<std::size_t>(spec.rungs));
    for (const VeinPlace& vein : layout.veins) {
        for (const Vector3& p : vein.line) EXPECT_NEAR(p.z(), wall.height(p.x(), p.y()), 1e-12);
    }
    for (int side = -1; side <= 1; ++side) {
        const VeinPlace& vein = layout.veins[side == 0 ? 0U : side < 0 ? 1U : 2U];
        EXPECT_EQ(vein.radius, spec.vessel_radius);
        const double radius = curve().fascia_radius();
        for (const Vector3& p : vein.line)
            EXPECT_LE(std::abs(radius * std::asin(p.x() / radius) - side * spec.vein_lateral),
                      spec.wander + 1e-9);
        EXPECT_NEAR(vein.line.front().y(), wall.low, 0.01);
    }
    for (std::size_t v = 3; v < layout.veins.size(); ++v) {
        const VeinPlace& rung = layout.veins[v];
        EXPECT_EQ(rung.radius, spec.rung_radius);
        for (const auto& [end, vein] : {std::pair{rung.line.front(), 1U}, std::pair{rung.line.back(), 2U}}) {
            double least = 1;
            for (std::size_t i = 0; i + 1 < layout.veins[vein].line.size(); ++i) {
                const Vector3 &a = layout.veins[vein].line[i], &b = layout.veins[vein].line[i + 1];
                const double share = std::clamp((end - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                least = std::min(least, (a + share * (b - a) - end).norm());
            }
            EXPECT_LT(least, 2e-4) << v;
        }
    }
}

TEST(StructuresLayout, NervesAreInFrontOfTheWallAndDivergeDownwards) {
    const FieldWall wall = presacral_wall(curve(), rectum);
    const StructuresSpec spec;
    const StructuresLayout layout = place_structures(spec, wall, 3);
    ASSERT_EQ(layout.nerves.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        const std::vector<Vector3>& line = layout.nerves[n];
        const double side = n == 0 ? -1 : 1;
        EXPECT_LT(line.front().y(), line.back().y());
        EXPECT_GT(side * line.front().x(), side * line.back().x());
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
            const double across =
                side * (spec.nerve_caudal + share * (spec.nerve_cranial - spec.nerve_caudal));
            EXPECT_NEAR((line[i] - wall.point(share * rectum, across, 0)).norm(), spec.nerve_height, 1e-12);
        }
    }
}

TEST(StructuresLayout, BedFollowsTheWall) {
    const FieldWall wall = presacral_wall(curve(), rectum);
    const StructuresSpec spec;
    const FieldBed bed = place_structures(spec, wall, 3).bed;
    for (double along = 0.005; along < rectum; along += 0.0117) {
        for (const double across : {-0.02, -0.011, 0.0, 0.007, 0.019}) {
            const Vector3 point = wall.point(along, across, 0);
            // Second order within half a cell: the fascia's radius is 33 mm, seen at 35 degrees at most.
            EXPECT_NEAR(bed.ground(point), point.z(), 3.5e-4) << along << " " << across;
        }
    }
    EXPECT_NEAR(bed.corner.x() + 0.5 * bed.pool.columns * bed.pool.cell, 0, 1e-12);
}

TEST(StructuresLayout, PositionsDependOnTheSeed) {
    const FieldWall wall = presacral_wall(curve(), rectum);
    const StructuresSpec spec;
    const StructuresLayout a = place_structures(spec, wall, 3), b = place_structures(spec, wall, 3),
                           c = place_structures(spec, wall, 4);
    int moved = 0;
    for (std::size_t v = 0; v < a.veins.size(); ++v) {
        EXPECT_EQ(a.veins[v].line, b.veins[v].line);
        moved += a.veins[v].line != c.veins[v].line ? 1 : 0;
    }
    EXPECT_EQ(moved, static_cast<int>(a.veins.size()));
    EXPECT_EQ(a.nerves, c.nerves);
}

/// Error text for C4's scene with other structures, or with another of its parts changed.
std::string refusal(const std::string& structures, const std::string& scene = "c4_posterior") {
    std::string text = read_text_file(test::source_path("assets/scenes/" + scene + ".json"), 1 << 20);
    const std::string from = "\"structures\": {}";
    const std::size_t at = text.find(from);
    if (at != std::string::npos) {
        text.replace(at, from.size(), "\"structures\": " + structures);
    } else {
        const std::string tissues = "\"tissues\": [";
        text.replace(
            text.find(tissues), tissues.size(),
            "\"structures\": " + structures +
                ", \"tissues\": [{\"label\": \"fascia\"}, {\"label\": \"nerve\"}, {\"label\": \"vein\"},");
    }
    try {
        parse_scene(text, "scene.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(StructuresSpec, InconsistentKeysAreRefusedWithPlaceAndHint) {
    EXPECT_EQ(refusal("{}"), "");
    EXPECT_EQ(refusal("{\"rungs\": 0, \"wander\": 0, \"nerve_height\": 0.003}"), "");
    EXPECT_NE(refusal("{\"rung_radius\": 0.002}").find("/structures/rung_radius"), std::string::npos);
    EXPECT_NE(refusal("{\"nerve_height\": 0.0005}").find("/structures/nerve_height"), std::string::npos);
    EXPECT_NE(refusal("{\"wander\": 0.009}").find("/structures/wander"), std::string::npos);
    EXPECT_NE(refusal("{\"veins\": 3}").find("veins"), std::string::npos);
    EXPECT_NE(refusal("{\"nerve_tissue\": \"liver\"}").find("liver"), std::string::npos);
    EXPECT_NE(refusal("{}", "b2_areolar").find("presacral"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
