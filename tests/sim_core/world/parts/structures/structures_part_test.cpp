// SPDX-License-Identifier: Apache-2.0
// Veins that open, bleed by Hagen and Poiseuille, are clipped, sealed and suctioned; nerves that blades
// divide and steam heats; the sheet in front of them under energy; reproducible; no allocation; extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/world/parts/structures/structures_stage.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"
#include "tests/support/wait_count.h"

namespace fulcrum {
namespace {

using test::structures_scene;
using test::StructuresStage;

constexpr double pi = 3.14159265358979323846;

/// m3/s through a share of a vein's lumen.
double poiseuille(const StructuresSpec& spec, double radius, double share) {
    return pi * std::pow(radius, 4) * spec.vessel_pressure * share * share /
           (8 * 3.5e-3 * spec.feeding_length);
}

TEST(PresacralVeins, BladeBelowTheCoverOpensAVeinByItsDepth) {
    const StructuresSpec spec = *structures_scene().structures;
    for (const double share : {0.3, 0.6, 1.0, 1.7}) {
        StructuresStage stage;
        const Vector3 place = stage.over_vein(0, 0.4);
        stage.tool[1].tip = stage.pressed(1, place, 0.9 * spec.vein_depth);
        stage.press(1, button_primary, true);
        stage.run(0.1);
        EXPECT_EQ(stage.opened(), 0);
        stage.tool[1].tip = stage.pressed(1, place, spec.vein_depth + share * 2 * spec.vessel_radius);
        stage.step();
        ASSERT_EQ(stage.opened(), 1) << share;
        const OutletView& outlet = stage.field().outlets[0];
        EXPECT_EQ(outlet.vein, 0);
        EXPECT_EQ(outlet.band, -1);
        EXPECT_TRUE(outlet.injured);
        EXPECT_LT((outlet.position - place).norm(), 0.001);
        const double expected = poiseuille(spec, spec.vessel_radius, std::min(1.0, share));
        EXPECT_NEAR(outlet.flow, expected, 0.05 * expected) << share;
    }
}

TEST(PresacralVeins, BloodLossIsTheIntegralOfAClottingFlowAndIsConserved) {
    StructuresStage stage;
    const StructuresSpec& spec = *stage.scene.structures;
    stage.tool[1].tip = stage.pressed(1, stage.over_vein(0, 0.4), spec.vein_depth + 2.5 * spec.vessel_radius);
    stage.press(1, button_primary, true);
    stage.step();
    stage.press(1, button_primary, false);
    stage.go(1, StructuresStage::away(), 1.0);
    stage.run(20);
    ASSERT_EQ(stage.opened(), 1);
    const double seconds = 1e-3 * stage.tick;
    const double expected = poiseuille(spec, spec.vessel_radius, 1) * 0.5 * spec.clotting_time *
                            (1 - math::exp(-2 * seconds / spec.clotting_time));
    EXPECT_NEAR(stage.field().lost, expected, 1e-9 * expected);
    EXPECT_GT(stage.field().lost, 5e-6);
    const PoolState& pool = stage.part.field().pool();
    EXPECT_NEAR(pool.poured, stage.field().lost, 1e-12 * pool.poured);
    EXPECT_NEAR(pooled_volume(stage.part.layout().bed.pool, pool) + pool.removed, pool.poured,
                1e-12 * pool.poured);

    // It runs down to the deepest part of the hollow, directly posterior to the curve's centre.
    const FieldView& view = stage.field();
    const auto deepest = static_cast<std::size_t>(std::min_element(view.ground.begin(), view.ground.end()) -
                                                  view.ground.begin());
    EXPECT_GT(view.blood[deepest], 0.001F);

    // Suction removes it; the balance holds.
    stage.take(1, InstrumentKind::suction);
    stage.tool[1].tip = Vector3(0, -0.07, stage.wall.height(0, -0.07) + 0.006);
    stage.press(1, button_energy, true);
    const double before = stage.field().removed;
    stage.run(3);
    EXPECT_TRUE(stage.field().tools[1].active);
    EXPECT_GT(stage.field().removed - before, 3e-6);
    EXPECT_NEAR(pooled_volume(stage.part.layout().bed.pool, pool) + pool.removed, pool.poured,
                1e-12 * pool.poured);
}

TEST(PresacralVeins, BluntTipTearsAVeinOnlyAboveItsTearForce) {
    StructuresStage stage;
    const StructuresSpec& spec = *stage.scene.structures;
    const double stiffness = test::fascia(stage.scene).stiffness;
    const Vector3 place = stage.over_vein(2, 0.4);
    // No button: the hook's back is blunt, as are the other instruments.
    for (const int hand : {0, 1}) {
        stage.tool[hand].tip = stage.pressed(hand, place, 0.95 * spec.vein_tear_force / stiffness);
        stage.run(0.2);
        EXPECT_EQ(stage.opened(), 0);
        const Vector3 beside = stage.felt.closest(stage.wall.point(0.056, 0.007, 0), 0.01).position;
        stage.tool[hand].tip = stage.pressed(hand, beside, 2 * spec.vein_tear_force / stiffness);
        stage.run(0.2);
        EXPECT_EQ(stage.opened(), 0);
        stage.tool[hand].tip = StructuresStage::away();
    }
    stage.tool[0].tip = stage.pressed(0, place, 1.5 * spec.vein_tear_force / stiffness);
    stage.step();
    ASSERT_EQ(stage.opened(), 1);
    EXPECT_EQ(stage.field().outlets[0].vein, 2);
    const double expected = poiseuille(spec, spec.vessel_radius, 0.5);
    EXPECT_NEAR(stage.field().outlets[0].flow, expected, 0.05 * expected);
}

TEST(PresacralVeins, EnergyReducesTheForceThroughTheCover) {
    Scene scene = structures_scene();
    test::fascia(scene).cutting = CuttingSpec{1, 0.5, 0.3, 0.5};
    StructuresStage stage(scene);
    const StructuresSpec& spec = *stage.scene.structures;
    stage.tool[1].tip = stage.pressed(1, stage.over_vein(0, 0.4), 0.8 * spec.vein_depth);
    stage.press(1, button_primary, true);
    stage.step();
    EXPECT_EQ(stage.opened(), 0);
    stage.press(1, button_energy, true);
    stage.step();
    EXPECT_EQ(stage.opened(), 1);
}

TEST(PresacralVeins, NearOpeningsAreMergedAndNoneIsLost) {
    StructuresStage stage;
    const StructuresSpec& spec = *stage.scene.structures;
    stage.press(1, button_primary, true);
    stage.tool[1].tip = stage.pressed(1, stage.over_vein(0, 0.4), spec.vein_depth + spec.vessel_radius);
    stage.step();
    const double once = stage.field().outlets[0].flow;
    stage.tool[1].tip = stage.pressed(1, stage.over_vein(0, 0.4), spec.vein_depth + 2 * spec.vessel_radius);
    stage.step();
    EXPECT_EQ(stage.opened(), 1);
    EXPECT_GT(stage.field().outlets[0].flow, 3 * once);  // twice the area, four times the flow
    // All veins from end to end.
    for (std::size_t v = 0; v < stage.structures().veins.size(); ++v) {
        for (const Vector3& place : stage.part.layout().veins[v].line) {
            stage.tool[1].tip = stage.pressed(1, place, spec.vein_depth + 2 * spec.vessel_radius);
            stage.step();
        }
    }
    EXPECT_EQ(stage.opened(), static_cast<int>(field_outlet_capacity));
    for (const OutletView& outlet : stage.field().outlets) EXPECT_GT(outlet.flow, 0.0);
}

/// Opens the middle vein completely and moves the hand away.
void open_middle(StructuresStage& stage, double share = 0.4) {
    const StructuresSpec& spec = *stage.scene.structures;
    stage.tool[1].tip =
        stage.pressed(1, stage.over_vein(0, share), spec.vein_depth + 1.2 * spec.vessel_radius);
    stage.press(1, button_primary, true);
    stage.step();
    stage.press(1, button_primary, false);
    stage.go(1, StructuresStage::away(), 1.0);
}

TEST(PresacralVeins, ClipStopsTheBleeding) {
    StructuresStage stage;
    open_middle(stage);
    ASSERT_GT(stage.field().outlets[0].flow, 0.0);
    stage.take(1, InstrumentKind::clip_applier);
    stage.tool[1].tip = stage.field().outlets[0].position + Vector3(0, 0, 0.002);
    stage.step();
    EXPECT_EQ(stage.field().tools[1].clips_fired, 0);
    stage.tool[1].jaw_angle = 0.05;
    stage.tool[1].grip = 5;
    stage.run(0.1);
    EXPECT_EQ(stage.field().tools[1].clips_fired, 1);
    EXPECT_EQ(stage.field().tools[1].last_clip_outlet, 0);
    EXPECT_NEAR(static_cast<double>(stage.field().tools[1].last_clip_distance), 0.002, 1e-4);
    EXPECT_TRUE(stage.field().outlets[0].clipped);
    EXPECT_EQ(stage.field().outlets[0].flow, 0.0);
    const double lost = stage.field().lost;
    stage.run(1);
    EXPECT_EQ(stage.field().lost, lost);
}

TEST(PresacralVeins, HeatSealsAVeinLessUnderBlood) {
    double seconds[2] = {0, 0}, depth[2] = {0, 0};
    for (const int wet : {0, 1}) {
        StructuresStage stage;
        open_middle(stage, 0.2);  // near the bottom of the hollow
        if (wet == 1) stage.run(8);
        depth[wet] = static_cast<double>(stage.field().outlets[0].blood_depth);
        stage.tool[1].tip = stage.field().outlets[0].position + Vector3(0, 0, 0.0025);
        stage.press(1, button_energy, true);
        const std::uint32_t begun = stage.tick;
        while (stage.field().outlets[0].flow > 0 && stage.tick - begun < 60000) stage.step();
        EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::vessel);
        EXPECT_EQ(stage.field().outlets[0].flow, 0.0);
        seconds[wet] = 1e-3 * (stage.tick - begun);
    }
    EXPECT_GT(depth[1], 2 * depth[0]);
    EXPECT_GT(seconds[0], 0.5);
    EXPECT_GT(seconds[1], seconds[0] + 0.05);
}

TEST(HypogastricNerves, OnlyABladeDividesANerveAtAnySpeed) {
    StructuresStage stage;
    const Vector3 nerve = stage.field().nerves[1].line[12];
    const Vector3 before = nerve + Vector3(-0.02, 0, 0.0004), after = nerve + Vector3(0.02, 0, 0.0004);
    const auto divided = [&] { return stage.field().nerves[1].divided; };
    // A hook without its button, a grasper with every button.
    stage.tool[1].tip = before;
    stage.step();
    stage.tool[0].buttons = button_primary | button_energy;
    stage.go(1, after);
    stage.go(0, nerve);
    EXPECT_FALSE(divided());
    // A suction tip with every button.
    stage.take(1, InstrumentKind::suction);
    stage.press(1, button_primary | button_energy, true);
    stage.go(1, nerve);
    EXPECT_FALSE(divided());
    stage.press(1, button_primary | button_energy, false);
    // Scissors next to it, then through it within one step.
    stage.take(1, InstrumentKind::scissors);
    stage.tool[1].tip = before + Vector3(0, 0, 0.004);
    stage.press(1, button_primary, true);
    stage.step();
    stage.tool[1].tip = after + Vector3(0, 0, 0.004);
    stage.step();
    EXPECT_FALSE(divided());
    stage.press(1, button_primary, false);
    stage.tool[1].tip = before;
    stage.step();
    stage.press(1, button_primary, true);
    stage.step();
    stage.tool[1].tip = after;
    stage.step();
    EXPECT_TRUE(divided());
    EXPECT_FALSE(stage.field().nerves[0].divided);
    EXPECT_EQ(stage.field().worst_nerve_dose, 0.0);
}

TEST(HypogastricNerves, SteamHeatsNervesByDistanceAndHeatIsBalanced) {
    double dose[3];
    int i = 0;
    for (const double gap : {0.0005, 0.003, 0.012}) {
        StructuresStage stage;
        const Vector3 nerve = stage.field().nerves[0].line[10];
        stage.tool[1].tip = nerve + Vector3(0, 0, gap + stage.radius(1) + stage.field().nerve_radius);
        stage.press(1, button_energy, true);
        stage.run(3);
        EXPECT_NEAR(static_cast<double>(stage.field().tools[1].nerve_distance), gap, 3e-4);
        dose[i++] = stage.field().worst_nerve_dose;
        const HeatState& heat = stage.part.field().heat();
        const double out = stored_heat(stage.part.field().model().heat, heat) + heat.perfused + heat.boiled;
        EXPECT_NEAR(heat.given, out, 1e-9 * std::max(1e-9, heat.given)) << gap;
    }
    EXPECT_GT(dose[0], structures_scene().structures->nerve_dose_limit);
    EXPECT_GT(dose[0], 100 * std::max(dose[1], 1e-3));
    EXPECT_EQ(dose[2], 0.0);
}

TEST(HypogastricNerves, DoseOfANerveIsTheIntegralOfItsTemperature) {
    StructuresStage stage;
    const Vector3 nerve = stage.field().nerves[0].line[10];
    stage.tool[1].tip = nerve + Vector3(0, 0, 0.0015 + stage.radius(1) + stage.field().nerve_radius);
    stage.press(1, button_energy, true);
    const std::size_t patch = stage.part.field().model().nerves[0].first + 10;
    double sum = 0, last = stage.part.field().temperature(patch);
    for (int k = 0; k < 400; ++k) {
        stage.step();
        const double now = stage.part.field().temperature(patch), mean = 0.5 * (last + now);
        // Sapareto and Dewey: R^(43 - T), 0.5 from 43, 0.25 from 39.
        sum += mean < 39 ? 0.0 : std::pow(mean < 43 ? 0.25 : 0.5, 43 - mean) * stage.scene.step_period() / 60;
        last = now;
    }
    ASSERT_GT(sum, 1e-3);
    EXPECT_NEAR(static_cast<double>(stage.field().nerves[0].dose[10]), sum, 1e-6 * sum);
}

Vector3 sheet_middle(const StructuresStage& stage) {
    const std::size_t count = stage.sheet->surface().mesh().vertices.size();
    Vector3 sum = Vector3::Zero();
    for (std::size_t v = 0; v < count; ++v) sum += stage.sheet->state().positions[v];
    return sum / static_cast<double>(count);
}

TEST(SheetUnderPower, SteamOverAPlaneSumsToThePowerAtTheBlade) {
    Scene scene = structures_scene();
    scene.sheet->spacing = 0.002;
    StructuresStage stage(scene, true);
    const double height = 1e-4 + stage.radius(1);
    stage.tool[1].tip = sheet_middle(stage) + Vector3(0, 0, height);
    stage.press(1, button_energy, true);
    stage.step();
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::nothing);
    double sum = 0;
    for (std::int32_t r = 0; r < stage.sheet->surface().root_count(); ++r)
        sum += stage.part.field().power(stage.part.root_patch(r));
    // Integral over the plane of exp(-s / l), s from the tip, out to where it ends.
    const auto beyond = [](double s) {
        return math::exp(-s / field_rules::spread_length) * (1 + s / field_rules::spread_length);
    };
    const double expected = field_rules::spread_power * (beyond(height) - beyond(field_rules::spread_reach));
    EXPECT_NEAR(sum, expected, 0.03 * expected);
}

/// The scene with tissue that resists cutting, and a hook.
Scene tough_scene() {
    Scene scene = structures_scene();
    TissueSpec& tissue = scene.tissues[static_cast<std::size_t>(scene.tissue_index("areolar"))];
    tissue.cutting = CuttingSpec{0.06, 0.05, 0.04, 0.4};
    return scene;
}

/// Presses the hook into the sheet and moves it along; returns the removed area, m2.
double drawn(StructuresStage& stage, std::uint16_t buttons) {
    const Vector3 middle = sheet_middle(stage);
    stage.tool[1].tip = middle + Vector3(-0.02, 0, 0.01);
    stage.step();
    stage.go(1, middle + Vector3(-0.02, 0, -0.004), 0.02);
    stage.press(1, buttons, true);
    stage.go(1, middle + Vector3(0.01, 0, -0.004), 0.02);
    return stage.snapshot.sheet.removed_area;
}

TEST(SheetUnderPower, ActivatedHookNeedsLessForceAndLeavesChar) {
    StructuresStage cold(tough_scene(), true), hot(tough_scene(), true);
    EXPECT_EQ(drawn(cold, button_primary), 0.0);
    EXPECT_GT(drawn(hot, button_energy), 0.8 * 0.02 * hot.scene.sheet->blade_width);
    EXPECT_EQ(hot.field().tools[1].target, EnergyTarget::sheet);
    EXPECT_EQ(*std::max_element(cold.structures().sheet_char.begin(), cold.structures().sheet_char.end()),
              0.0F);
    EXPECT_GT(*std::max_element(hot.structures().sheet_char.begin(), hot.structures().sheet_char.end()),
              0.02F);
    EXPECT_GT(*std::max_element(hot.structures().sheet_dose.begin(), hot.structures().sheet_dose.end()),
              240.0F);
    // The drawn triangles know their root: char is next to the cut.
    const SheetView& sheet = hot.snapshot.sheet;
    double far = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(sheet.triangle_count); ++k) {
        const auto root = static_cast<std::size_t>(sheet.roots[k]);
        ASSERT_LT(root, hot.structures().sheet_char.size());
        if (hot.structures().sheet_char[root] < 0.01F) continue;
        const Vector3& rest = sheet.rest[static_cast<std::size_t>(sheet.triangles[k][0])];
        far = std::max(far, std::abs(rest.y()));
    }
    EXPECT_GT(far, 0.0);
    EXPECT_LT(far, 0.012);
    // Distant tissue of the sheet is unchanged.
    EXPECT_EQ(hot.structures().sheet_dose.front(), 0.0F);
    EXPECT_EQ(hot.structures().sheet_dose.back(), 0.0F);
    EXPECT_GT(hot.field().smoke, 5e-4);
    const HeatState& heat = hot.part.field().heat();
    EXPECT_NEAR(heat.given, stored_heat(hot.part.field().model().heat, heat) + heat.perfused + heat.boiled,
                1e-9 * heat.given);
}

TEST(SheetUnderPower, DesiccatedTissueTakesNoCurrent) {
    StructuresStage stage(tough_scene(), true);
    const Vector3 middle = sheet_middle(stage);
    stage.tool[1].tip = middle + Vector3(0, 0, 0.01);
    stage.step();
    stage.go(1, middle + Vector3(0, 0, -0.0005), 0.02);
    stage.press(1, button_energy, true);
    const HeatState& heat = stage.part.field().heat();
    double before = 0, first = 0, last = 0;
    for (int second = 0; second < 6; ++second) {
        before = heat.given;
        stage.run(1);
        (second == 0 ? first : last) = heat.given - before;
    }
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::sheet);
    EXPECT_GT(*std::max_element(stage.structures().sheet_char.begin(), stage.structures().sheet_char.end()),
              0.9F);
    EXPECT_GT(first, 5.0) << "J in the first second, most of it into steam";
    EXPECT_LT(last, 0.35 * first) << "steam next to it and remaining water";
    const HeatModel& model = stage.part.field().model().heat;
    for (const double rise : heat.rise) EXPECT_LT(model.body_temperature + rise, model.boiling_point + 1);
}

TEST(SheetUnderPower, HeldInstrumentDecidesWhetherItIsABlade) {
    StructuresStage stage(structures_scene(), true);
    ToolKinematics tool = stage.tool[1];
    const auto blade = [&](std::uint16_t buttons) {
        tool.buttons = buttons;
        const HeldTool held = stage.part.held(1, tool);
        return held.instrument->cuts() && held.tool.inside && (held.tool.buttons & button_primary) != 0;
    };
    EXPECT_TRUE(blade(button_primary));
    EXPECT_TRUE(blade(button_energy));
    EXPECT_TRUE(stage.part.held(1, tool).energised);
    stage.take(1, InstrumentKind::suction);
    EXPECT_FALSE(blade(button_primary | button_energy));
    EXPECT_FALSE(stage.part.held(1, tool).energised);
    stage.take(1, InstrumentKind::clip_applier);
    EXPECT_FALSE(blade(button_primary | button_energy));
    stage.take(1, InstrumentKind::harmonic);
    EXPECT_FALSE(blade(button_primary));
    EXPECT_TRUE(blade(button_energy));
    // While passing through the trocar it is inactive.
    stage.press(1, button_exchange, true);
    stage.step();
    EXPECT_GT(stage.field().tools[1].exchange_left, 1.0F);
    EXPECT_FALSE(blade(button_primary | button_energy));
    LocalModel model;
    stage.part.publish_model(1, TickOutput(), model);
    EXPECT_FALSE(model.energises);
    EXPECT_EQ(stage.part.held(0, stage.tool[0]).instrument->kind, InstrumentKind::grasper);
}

/// Something of everything.
std::uint64_t rehearse(StructuresStage& stage) {
    drawn(stage, button_energy);
    open_middle(stage);
    stage.go(1, stage.field().nerves[0].line[8] + Vector3(0, 0, 0.004), 0.2);
    stage.run(0.5);
    StateHash hash;
    stage.part.hash(hash);
    stage.sheet->hash(hash);
    return hash.value();
}

TEST(StructuresPart, SameInputGivesTheSameBits) {
    StructuresStage a(tough_scene(), true), b(tough_scene(), true), other(tough_scene(), true, 6);
    const std::uint64_t hash = rehearse(a);
    EXPECT_EQ(hash, rehearse(b));
    EXPECT_NE(hash, rehearse(other));
}

TEST(StructuresPart, StepNeitherAllocatesNorWaits) {
    StructuresStage stage(tough_scene(), true);
    drawn(stage, button_energy);
    const std::uint64_t before = test::allocation_count(), waits = test::wait_count();
    open_middle(stage);
    stage.press(1, button_energy, true);
    stage.run(0.5);
    EXPECT_EQ(test::allocation_count() - before, 0u);
    if (test::waits_are_counted) {
        EXPECT_EQ(test::wait_count() - waits, 0u);
    }
}

TEST(StructuresExtremes, StaysFiniteForAnyKeysAndInput) {
    Random random(29);
    const int trials = std::max(4, test::cases_asked() / 250);
    for (int trial = 0; trial < trials; ++trial) {
        Scene scene = structures_scene();
        scene.ticks_per_step = 1 + static_cast<int>(random.below(50));
        StructuresSpec& spec = *scene.structures;
        spec.vessel_radius = test::between(random, 1e-5, 0.003);
        spec.rung_radius = std::min(spec.vessel_radius, test::between(random, 1e-5, 0.003));
        spec.vessel_pressure = test::between(random, 1e-3, 50000);
        spec.feeding_length = test::between(random, 0.001, 10);
        spec.clotting_time = test::between(random, 1, 1e6);
        spec.seal_time = test::between(random, 0.01, 100);
        spec.rungs = static_cast<int>(random.below(17));
        spec.vein_depth = random.below(3) == 0 ? 0 : test::between(random, 1e-5, 0.005);
        spec.vein_tear_force = test::between(random, 0.01, 1000);
        spec.cell = test::between(random, 0.003, 0.02);
        spec.exchange_time = 0;
        spec.conductivity = test::between(random, 1e-3, 500);
        test::fascia(scene).stiffness = test::between(random, 1, 1e5);
        StructuresStage stage(scene, false, random.bits());
        for (int i = 0; i < 80; ++i) {
            for (ToolKinematics& tool : stage.tool) {
                const auto& veins = stage.part.layout().veins;
                const std::vector<Vector3>& line =
                    veins[random.below(static_cast<std::uint32_t>(veins.size()))].line;
                tool.tip = line[random.below(static_cast<std::uint32_t>(line.size()))] +
                           0.01 * test::inside_unit_box(random);
                if (random.below(6) == 0)
                    tool.tip = stage.field().nerves[random.below(2)].line[random.below(20)];
                if (random.below(8) == 0) tool.tip += test::inside_unit_box(random);
                if (random.below(12) == 0) tool.tip.y() = test::not_a_length(random);
                tool.jaw_angle = random.uniform(0, 1);
                tool.grip = random.below(3) == 0 ? 0 : test::between(random, 0.1, 1000);
                tool.buttons = static_cast<std::uint16_t>(random.below(16));
            }
            stage.step();
            const FieldView& view = stage.field();
            for (const float blood : view.blood) ASSERT_TRUE(std::isfinite(blood) && blood >= 0) << trial;
            for (const OutletView& outlet : view.outlets)
                ASSERT_TRUE(outlet.position.allFinite() && std::isfinite(outlet.flow) &&
                            std::isfinite(outlet.lost))
                    << trial;
            ASSERT_TRUE(std::isfinite(view.lost) && std::isfinite(view.smoke) &&
                        std::isfinite(view.lateral_dose))
                << trial;
            const PoolState& pool = stage.part.field().pool();
            ASSERT_NEAR(pooled_volume(stage.part.layout().bed.pool, pool) + pool.removed, view.lost,
                        1e-9 * std::max(1e-9, view.lost))
                << trial;
        }
    }
}

}  // namespace
}  // namespace fulcrum
