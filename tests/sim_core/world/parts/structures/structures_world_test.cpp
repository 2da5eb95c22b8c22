// SPDX-License-Identifier: Apache-2.0
// Structures in the world of C4: their course, the effect of a pressed hook, absence in other scenes,
// reproducibility.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/parts/structures/structures_part.h"
#include "tests/sim_core/world/parts/bands/bands_stage.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

using test::BandsStage;

Scene posterior_scene(const std::string& variant = "") {
    return load_scene(test::source_path("assets/scenes/c4_posterior" + variant + ".json"));
}

TEST(StructuresInTheWorld, VeinsAreOnTheFasciaAndNervesAwayFromThePlane) {
    const World world(posterior_scene(), 5);
    ASSERT_NE(world.find<StructuresPart>(), nullptr);
    const StructuresView& view = world.snapshot().structures;
    ASSERT_EQ(view.veins.size(), 3U + static_cast<std::size_t>(world.scene().structures->rungs));
    for (const VeinView& vein : view.veins) {
        EXPECT_GT(vein.radius, 0);
        for (const Vector3& point : vein.line) {
            const CavityPoint nearest = world.wall()->closest(point, 0.01);
            ASSERT_GE(nearest.triangle, 0);
            EXPECT_LT(std::abs(nearest.distance), 1e-9);
        }
    }
    EXPECT_EQ(view.sheet_char.size(),
              static_cast<std::size_t>(world.find<SheetPart>()->surface().root_count()));
    bool listed = false;
    for (const PartCost& cost : world.costs())
        listed = listed || (cost.part == "structures" && cost.bytes > 10000);
    EXPECT_TRUE(listed);
    // Scenes of bands and others have none of it.
    const World other(test::bands_scene(), 5);
    EXPECT_EQ(other.find<StructuresPart>(), nullptr);
    EXPECT_TRUE(other.snapshot().structures.veins.empty());
    EXPECT_TRUE(other.snapshot().structures.sheet_char.empty());
}

TEST(StructuresInTheWorld, MarkedLineIsAtASafeDistanceFromTheNerves) {
    for (const char* variant : {"", "_narrow"}) {
        const World world(posterior_scene(variant), 5);
        const FieldView& view = world.snapshot().field.at(0);
        ASSERT_EQ(view.nerves.size(), 2U);
        const double blade = world.scene().instrument(Hand::right)->tip_radius;
        double least = 1;
        for (const NerveView& nerve : view.nerves) {
            for (const Vector3& point : nerve.line)
                for (const Vector3& on_line : world.snapshot().sheet.line)
                    least = std::min(least, (point - on_line).norm());
        }
        EXPECT_GT(least - blade - view.nerve_radius, world.scene().structures->safe_distance) << variant;
        EXPECT_LT(least, 0.012) << variant;  // but beyond the line's ends a nerve is close
    }
}

/// Presses the hook with its button into the fascia over the middle vein.
void injure(BandsStage& stage) {
    const std::vector<Vector3>& line = stage.structures().veins[0].line;
    const Vector3 place = line[line.size() * 2 / 5];
    const Vector3 out = stage.world.wall()->closest(place + Vector3(0, 0, 1e-4), 0.01).normal;
    stage.go(Hand::right, place + 0.03 * out);
    stage.go(Hand::right, place + 0.003 * out);
    stage.press(Hand::right, button_primary, true);
    stage.go(Hand::right, place - 0.001 * out);
}

TEST(StructuresInTheWorld, BladePressedIntoTheFasciaOpensAVeinReproducibly) {
    std::uint64_t hashes[2] = {0, 0};
    for (std::uint64_t& hash : hashes) {
        BandsStage stage(posterior_scene(), 5);
        EXPECT_EQ(stage.field().lost, 0.0);
        injure(stage);
        EXPECT_TRUE(stage.field().outlets[0].opened);
        EXPECT_TRUE(stage.field().outlets[0].injured);
        EXPECT_GT(stage.field().lost, 0.0);
        EXPECT_GT(stage.felt(Hand::right).norm(), 0.2);
        while (stage.record.state_hash == 0) stage.step();
        hash = stage.record.state_hash;
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(StructuresInTheWorld, EnergyInThePlaneIsOnTargetAndInTheFatIsNot) {
    double far[2] = {0, 0};
    for (const int fat : {0, 1}) {
        BandsStage stage(posterior_scene(), 5);
        const SheetView& sheet = stage.world.snapshot().sheet;
        // In the middle of the first septum, in the plane or well inside the fat.
        const double line = 0.5 * sheet.septum_length, height = fat == 1 ? sheet.fat_from + 0.006 : 0.001;
        Vector3 place = Vector3::Zero();
        double least = 1;
        for (std::size_t v = 0; v < static_cast<std::size_t>(sheet.vertex_count); ++v) {
            const double away = (sheet.rest[v] - Vector3(line, height, 0)).norm();
            if (!(away < least)) continue;
            least = away;
            place = sheet.positions[v];
        }
        ASSERT_LT(least, 0.004);
        // Next to it at once, cranially along the hollow, so that nothing is touched there or before.
        const double angle = stage.scene.septa->first_angle;
        stage.tip[1] = place + 0.0022 * Vector3(0, std::cos(angle), std::sin(angle));
        stage.run(0.05);
        stage.press(Hand::right, button_energy, true);
        stage.run(6);
        EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::nothing) << fat;
        EXPECT_GT(
            *std::max_element(stage.structures().sheet_dose.begin(), stage.structures().sheet_dose.end()),
            0.0F);
        far[fat] = stage.field().lateral_dose;
    }
    EXPECT_GT(far[1], 0.1);
    EXPECT_GT(far[1], 10 * far[0]);
}

TEST(StructuresInTheWorld, AnotherWorldContinuesFromASaveDuringBleeding) {
    std::shared_ptr<const World::Saved> saved;
    std::uint64_t hashes[2] = {0, 0};
    double lost[2] = {0, 0};
    TickOutput last;
    {
        BandsStage stage(posterior_scene(), 5);
        injure(stage);
        stage.press(Hand::right, button_energy, true);
        stage.run(0.2);
        last = stage.outputs.back();
        saved = stage.world.save();
        ASSERT_NE(saved, nullptr);
        for (int i = 0; i < 40; ++i) stage.world.step(&last, 1);
        StateHash hash;
        stage.world.find<StructuresPart>()->hash(hash);
        hashes[0] = hash.value();
        lost[0] = stage.field().lost;
    }
    World other(posterior_scene(), 5);
    other.restore(*saved);
    for (int i = 0; i < 40; ++i) other.step(&last, 1);
    StateHash hash;
    other.find<StructuresPart>()->hash(hash);
    hashes[1] = hash.value();
    lost[1] = other.snapshot().field.at(0).lost;
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(lost[0], lost[1]);
    EXPECT_GT(lost[0], 0.0);
}

TEST(StructuresInTheWorld, StepAllocatesNothingDuringEnergyAndBleeding) {
    BandsStage stage(posterior_scene(), 5);
    injure(stage);
    stage.press(Hand::right, button_energy, true);
    stage.run(0.1);
    EXPECT_NE(stage.outputs.back().sample.hand[1].flags & hand_energy, 0);
    const std::uint64_t before = test::allocation_count();
    stage.run(0.5);
    EXPECT_EQ(test::allocation_count() - before, 0u);
    EXPECT_TRUE(stage.field().tools[1].active);
}

}  // namespace
}  // namespace fulcrum
