// SPDX-License-Identifier: Apache-2.0
// Where veins and nerves run: on the wall, before it, as the scene's few numbers say; the same for a seed.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/structures_layout.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// A hollow: steep towards its caudal end, as the sacrum's is.
FieldWall hollow() {
    FieldWall wall;
    wall.right = -0.035;
    wall.left = 0.035;
    wall.caudal = -0.05;
    wall.cranial = 0.03;
    wall.height = [](double x, double y) { return -0.05 + 4 * x * x + 6 * (y - 0.01) * (y - 0.01); };
    return wall;
}

TEST(StructuresLayout, VeinsRunOnTheWallAndRungsEndInTheLongOnes) {
    const FieldWall wall = hollow();
    const StructuresSpec spec;
    const StructuresLayout layout = place_structures(spec, wall, 3);
    ASSERT_EQ(layout.veins.size(), 3U + static_cast<std::size_t>(spec.rungs));
    for (const VeinPlace& vein : layout.veins) {
        for (const Vector3& p : vein.line) EXPECT_NEAR(p.z(), wall.height(p.x(), p.y()), 1e-15);
    }
    for (int side = -1; side <= 1; ++side) {
        const VeinPlace& vein = layout.veins[side == 0 ? 0U : side < 0 ? 1U : 2U];
        EXPECT_EQ(vein.radius, spec.vessel_radius);
        for (const Vector3& p : vein.line)
            EXPECT_LE(std::abs(p.x() - side * spec.vein_lateral), spec.wander + 1e-12);
        EXPECT_NEAR(vein.line.back().y() - vein.line.front().y(), wall.cranial - wall.caudal, 1e-12);
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

TEST(StructuresLayout, NervesStandBeforeTheWallAndDivergeDownwards) {
    const FieldWall wall = hollow();
    const StructuresSpec spec;
    const StructuresLayout layout = place_structures(spec, wall, 3);
    ASSERT_EQ(layout.nerves.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        const std::vector<Vector3>& line = layout.nerves[n];
        const double side = n == 0 ? -1 : 1;
        EXPECT_GT(line.front().y(), line.back().y());
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
            const double x = side * (spec.nerve_cranial + share * (spec.nerve_caudal - spec.nerve_cranial));
            const double y = wall.cranial - share * (wall.cranial - wall.caudal);
            EXPECT_NEAR((line[i] - wall.point(x, y)).norm(), spec.nerve_height, 1e-12);
            EXPECT_NEAR((line[i] - wall.point(x, y)).dot(wall.normal(x, y)), spec.nerve_height, 1e-12);
        }
    }
}

TEST(StructuresLayout, TheBedFollowsTheWallsSlope) {
    const FieldWall wall = hollow();
    const StructuresSpec spec;
    const FieldBed bed = place_structures(spec, wall, 3).bed;
    for (double x = wall.right; x <= wall.left; x += 0.0037) {
        for (double y = wall.caudal; y <= wall.cranial; y += 0.0041) {
            const Vector3 point = wall.point(x, y);
            // Second order within half a cell: 4 and 6 1/m of curvature over 2.5 mm.
            EXPECT_NEAR(bed.ground(point), point.z(), 10 * 0.25 * spec.cell * spec.cell + 1e-12);
            EXPECT_NEAR(bed.height(point + 0.003 * wall.normal(x, y)), 0.003, 2.5e-4);
        }
    }
}

TEST(StructuresLayout, PlacesComeFromTheSeed) {
    const FieldWall wall = hollow();
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

std::string refusal(const std::string& structures) {
    std::string text = read_text_file(test::source_path("assets/scenes/b2_areolar.json"), 1 << 20);
    const std::string from = "\"tissues\": [";
    text.replace(
        text.find(from), from.size(),
        "\"structures\": " + structures +
            ", \"tissues\": [{\"label\": \"fascia\"}, {\"label\": \"nerve\"}, {\"label\": \"vein\"},");
    try {
        parse_scene(text, "scene.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(StructuresSpec, KeysThatMakeNoSenseAreRefusedByPlaceAndMend) {
    EXPECT_EQ(refusal("{}"), "");
    EXPECT_EQ(refusal("{\"rungs\": 0, \"wander\": 0, \"nerve_height\": 0.003}"), "");
    EXPECT_NE(refusal("{\"rung_radius\": 0.002}").find("/structures/rung_radius"), std::string::npos);
    EXPECT_NE(refusal("{\"nerve_height\": 0.0005}").find("/structures/nerve_height"), std::string::npos);
    EXPECT_NE(refusal("{\"wander\": 0.009}").find("/structures/wander"), std::string::npos);
    EXPECT_NE(refusal("{\"veins\": 3}").find("veins"), std::string::npos);
    EXPECT_NE(refusal("{\"nerve_tissue\": \"liver\"}").find("liver"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum
