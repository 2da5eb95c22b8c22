// SPDX-License-Identifier: Apache-2.0
// Bands in the world: built if the scene lists them, grasped, divided, bleeding, controlled, suctioned; near
// tissue is heated and far tissue is not; reproducible; no allocation; extremes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/world/parts/bands/bands_part.h"
#include "tests/sim_core/world/parts/bands/bands_stage.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"
#include "tests/support/wait_count.h"

namespace fulcrum {
namespace {

using test::bands_scene;
using test::BandsStage;

std::size_t vessel_band(const BandsStage& stage, std::size_t vessel = 0) {
    return static_cast<std::size_t>(stage.world.find<BandsPart>()->layout().vessel_bands[vessel]);
}

/// Divides a band with the right hand while the left holds it `lift` m high; returns the time in s, -1 if it
/// was not divided.
double divide(BandsStage& stage, std::size_t band, double lift, bool* flagged = nullptr) {
    stage.take(Hand::left, band, 0.75);
    if (lift > 0) stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, lift));
    stage.take(Hand::right, band, 0.4);
    stage.press(Hand::right, button_energy, true);
    const std::uint32_t begun = stage.tick;
    while (!stage.bands()[band].divided() && stage.tick - begun < 20000) stage.step();
    if (flagged != nullptr) *flagged = (stage.outputs.back().sample.hand[1].flags & hand_energy) != 0;
    stage.press(Hand::right, button_energy, false);
    stage.step();
    const bool parted = stage.bands()[band].divided();
    return parted ? (stage.tick - begun) * 1e-3 : -1;
}

TEST(BandsPart, ExistsOnlyIfTheSceneListsIt) {
    const Scene plain = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    const World without(plain, 1), with(bands_scene(), 1);
    EXPECT_EQ(without.find<BandsPart>(), nullptr);
    EXPECT_TRUE(without.snapshot().bands.bands.empty());
    EXPECT_TRUE(without.snapshot().field.empty());
    for (const PartCost& cost : without.costs()) EXPECT_NE(cost.part, "bands");
    ASSERT_NE(with.find<BandsPart>(), nullptr);
    EXPECT_EQ(with.snapshot().field.size(), 1u);
    EXPECT_TRUE(with.snapshot().structures.veins.empty());
    bool listed = false;
    for (const PartCost& cost : with.costs()) listed = listed || (cost.part == "bands" && cost.bytes > 10000);
    EXPECT_TRUE(listed);
}

TEST(BandsPart, PositionsDependOnTheSeed) {
    const BandsSpec spec = *bands_scene().bands;
    const BandsLayout a = place_bands(spec, 3), b = place_bands(spec, 3), c = place_bands(spec, 4);
    ASSERT_EQ(a.bands.size(), 10u);
    ASSERT_EQ(a.vessel_bands.size(), 3u);
    int moved = 0, vessels = 0;
    for (std::size_t i = 0; i < a.bands.size(); ++i) {
        EXPECT_EQ(a.bands[i].root, b.bands[i].root);
        moved += a.bands[i].root != c.bands[i].root ? 1 : 0;
        vessels += a.bands[i].vessel >= 0 ? 1 : 0;
        EXPECT_NEAR((a.bands[i].root - a.bands[i].end).norm(), spec.length, 1e-12);
        for (std::size_t j = 0; j < i; ++j) {
            const double apart =
                (a.bands[i].root + a.bands[i].end - a.bands[j].root - a.bands[j].end).norm() / 2;
            EXPECT_GT(apart, 0.008);
        }
    }
    EXPECT_EQ(moved, 10);
    EXPECT_EQ(vessels, 3);
    for (const Vector3& point : a.nerve)
        EXPECT_NEAR(point.z(), spec.centre.z() + spec.height - spec.nerve_gap, 1e-12);
}

void expect_refusal(const std::string& from, const std::string& to, const std::string& word) {
    std::string text = read_text_file(test::source_path("assets/scenes/b3_bands.json"), 1 << 20);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
        parse_scene(text, "scene.json");
        FAIL() << to;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("scene.json:"), std::string::npos);
    }
}

TEST(BandsPart, InconsistentScenesAreRefusedWithPlaceAndHint) {
    expect_refusal("\"vessels\": 3", "\"vessels\": 8, \"count\": 4", "");
    expect_refusal("\"vessels\": 3", "\"vessel_count\": 3", "vessel_count");
    expect_refusal("\"count\": 10,\n    \"vessels\": 3", "\"count\": 2, \"vessels\": 3", "/bands/vessels");
    expect_refusal("\"height\": 0.022", "\"height\": 0.022, \"nerve_gap\": 0.03", "/bands/nerve_gap");
    expect_refusal("\"height\": 0.022", "\"height\": 0.022, \"tissue\": \"liver\"", "liver");
    expect_refusal("[0.05, 0.045, 0.004]", "[0.02, 0.045, 0.008]", "/bands/half_extent");
    expect_refusal("\"bands\": {",
                   "\"targets\": {\"per_hand\": 1, \"centre\": [0,0,0], \"half_extent\": [0.1,0.1,0.1], "
                   "\"tissue\": \"bed\"}, \"bands\": {",
                   "/bands");
    expect_refusal("[\"harmonic\", \"clip", "[\"drill\", \"clip", "exchange");
    std::string text = read_text_file(test::source_path("assets/scenes/a2_targets.json"), 1 << 20);
    text.replace(text.find("\"kind\": \"probe\""), 15, "\"exchange\": [\"harmonic\", \"hook\"]");
    EXPECT_THROW(parse_scene(text, "scene.json"), InputError);
}

TEST(BandsPart, IsOfferedToClosingJawsAndTakenWhereTheWorldDecidesSo) {
    const Scene scene = bands_scene();
    BandsPart part(scene, 5);
    const InstrumentSpec& grasper = *scene.instrument(Hand::left);
    TickOutput output;
    ToolKinematics& tool = output.contact[0].tool;
    tool.present = tool.inside = true;
    tool.axis = -Vector3::UnitZ();
    tool.rotation = Vector3(1, -1, -1).asDiagonal();
    const auto above = [&](double height) {  // of the middle of the jaws
        tool.tip = part.strand(2).position[strand_segments / 2] + Vector3(0, 0, height) +
                   0.5 * grasper.jaw_length * tool.axis;
    };
    const auto step = [&](const Part* taker) {
        StepInput input;
        input.outputs = &output;
        input.count = 1;
        input.dt = scene.step_period();
        input.held[0].instrument = &grasper;
        input.held[0].tool = tool;
        part.exchange(0, input, input.held[0]);
        const double offer = part.offer(0, input.held[0]);
        input.taker[0] = taker;
        part.apply(input);
        part.solve(input);
        return offer;
    };
    const auto open = [&] { tool.jaw_angle = grasper.jaw_opening, tool.grip = 0; };
    const auto close = [&] { tool.jaw_angle = 0.02, tool.grip = 4; };
    above(0.002);
    open();
    EXPECT_EQ(step(nullptr), Part::no_offer) << "open jaws take nothing";
    close();
    EXPECT_NEAR(step(nullptr), 0.002, 1e-4);
    EXPECT_FALSE(part.holds(0)) << "tissue of another part is nearer";
    open();
    step(nullptr);
    above(Jaws::reach + 0.001);
    close();
    EXPECT_EQ(step(nullptr), Part::no_offer) << "out of reach";
    open();
    step(nullptr);
    above(0.002);
    close();
    EXPECT_NEAR(step(&part), 0.002, 1e-4);
    EXPECT_TRUE(part.holds(0));
    EXPECT_EQ(part.grasp(0).patch, 2);
}

TEST(BandsPart, GraspedBandPullsOnTheHandUntilReleased) {
    BandsStage stage;
    stage.take(Hand::left, 2, 0.5);
    ASSERT_TRUE(stage.world.snapshot().grasps[0].held);
    EXPECT_EQ(stage.world.snapshot().grasps[0].patch, 2);
    EXPECT_NE(stage.outputs.back().sample.hand[0].flags & hand_grasping, 0);
    // The handle is on the other side of the trocar.
    const auto lever = [&] {
        const InstrumentSpec& spec = *stage.scene.instrument(Hand::left);
        const Vector3 arm = stage.tip[0] - stage.trocar[0].position;
        return Vector3(-(spec.trocar.shaft_length - arm.norm()) * arm.normalized());
    };
    double last = stage.felt(Hand::left).norm();
    for (int i = 0; i < 3; ++i) {
        stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, 0.003));
        stage.run(0.1);
        const double now = stage.felt(Hand::left).norm();
        EXPECT_GT(now, last + 0.02);
        last = now;
    }
    EXPECT_GT(last, 0.4);
    EXPECT_LT(last, 3.0);
    // The hand feels the force on the strand: two tensions.
    const Vector3 reaction = stage.world.snapshot().grasps[0].reaction;
    ToolLoad load;
    load.add(stage.world.snapshot().grasps[0].point - stage.trocar[0].position, -reaction);
    const Vector3 expected = load_at_hand(lever(), load).force;
    EXPECT_NEAR((stage.felt(Hand::left) - expected).norm(), 0, 0.03 * expected.norm());
    stage.open(Hand::left);
    stage.run(0.2);
    EXPECT_FALSE(stage.world.snapshot().grasps[0].held);
    EXPECT_LT(stage.felt(Hand::left).norm(), 1e-6);
}

TEST(BandsPart, ShearsDivideTheGraspedBandAndHeatIsBalanced) {
    BandsStage stage;
    std::size_t band = 0;
    while (stage.bands()[band].vessel >= 0) ++band;
    bool flagged = false;
    const double seconds = divide(stage, band, 0.005, &flagged);
    EXPECT_GT(seconds, 1.0);
    EXPECT_LT(seconds, 8.0);
    EXPECT_TRUE(flagged);
    const HeatState& heat = stage.world.find<BandsPart>()->field().heat();
    const double out =
        stored_heat(stage.world.find<BandsPart>()->field().model().heat, heat) + heat.perfused + heat.boiled;
    EXPECT_NEAR(heat.given, out, 1e-9 * heat.given);
    EXPECT_GT(heat.given, 20.0);
    EXPECT_GT(stage.field().smoke, 0.01);
    EXPECT_EQ(stage.field().lost, 0.0);
    EXPECT_FALSE(stage.bands()[band].torn);
}

TEST(BandsPart, WithoutAPedalOrWithoutJawsNothingIsDivided) {
    BandsStage stage;
    stage.take(Hand::right, 1, 0.5);
    stage.run(3);
    EXPECT_FALSE(stage.bands()[1].divided());
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    stage.press(Hand::right, button_energy, true);
    stage.run(3);
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::nothing);
    EXPECT_TRUE(stage.field().tools[1].active);
    for (const BandView& band : stage.bands()) EXPECT_FALSE(band.divided());
}

TEST(BandsPart, EnergyOnWhatIsPartedOnBothSidesOfTheJawsReachesNothing) {
    BandsStage stage;
    std::size_t band = 0;
    while (stage.bands()[band].vessel >= 0) ++band;
    stage.take(Hand::right, band, 0.5);
    stage.press(Hand::right, button_energy, true);
    const std::uint32_t begun = stage.tick;
    const auto parted = [&] { return stage.bands()[band].parted; };
    while (parted() == 0 && stage.tick - begun < 20000) stage.step();
    stage.step();
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::band) << "one side is whole";
    while ((parted() & (parted() >> 1U)) == 0 && stage.tick - begun < 40000) stage.step();
    ASSERT_NE(parted() & (parted() >> 1U), 0U);
    stage.step();
    EXPECT_TRUE(stage.field().tools[1].active);
    EXPECT_EQ(stage.field().tools[1].band, static_cast<std::int32_t>(band));
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::nothing);
}

TEST(BandsPart, VesselBleedsAfterDivisionMoreUnderTensionAndAClipStopsIt) {
    double flow[2], seconds[2];
    for (const int tense : {0, 1}) {
        BandsStage stage;
        const std::size_t band = vessel_band(stage);
        seconds[tense] = divide(stage, band, tense == 1 ? 0.011 : 0.002);
        ASSERT_GT(seconds[tense], 0);
        const OutletView& branch = stage.field().outlets[1];
        EXPECT_GT(branch.flow, 0.0);
        EXPECT_FALSE(branch.injured);
        flow[tense] = branch.flow;
        if (tense == 1) continue;
        stage.open(Hand::left);
        stage.open(Hand::right);
        stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
        stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
        ASSERT_EQ(stage.field().tools[1].kind, InstrumentKind::clip_applier);
        stage.go(Hand::right, stage.tip_for_jaws(Hand::right, branch.position + Vector3(0, 0, 0.003)));
        stage.close(Hand::right);
        EXPECT_EQ(stage.field().outlets[1].flow, 0.0);
        EXPECT_TRUE(stage.field().outlets[1].clipped);
        EXPECT_EQ(stage.field().tools[1].clips_left, stage.scene.bands->clips - 1);
        const double lost = stage.field().lost;
        EXPECT_GT(lost, 0.1e-6);
        stage.run(1);
        EXPECT_EQ(stage.field().outlets[1].lost,
                  stage.world.find<BandsPart>()->field().outlets()[1].bleed.lost);
        EXPECT_NEAR(stage.world.find<BandsPart>()->field().pool().poured, stage.field().lost, 1e-15);
        EXPECT_NEAR(pooled_volume(stage.world.find<BandsPart>()->layout().bed.pool,
                                  stage.world.find<BandsPart>()->field().pool()),
                    stage.field().lost, 1e-12);
    }
    EXPECT_LT(seconds[1], seconds[0]);
    EXPECT_GT(flow[1], 1.5 * flow[0]);
}

TEST(BandsPart, ClipBeforeDivisionPreventsBleedingAndHeatSealsTheRoot) {
    BandsStage stage;
    const std::size_t band = vessel_band(stage);
    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    const Vector3 root = stage.world.find<BandsPart>()->layout().bands[band].vessel_root;
    stage.go(Hand::right, stage.tip_for_jaws(Hand::right, root + Vector3(0, 0, 0.003)));
    stage.close(Hand::right);
    EXPECT_EQ(stage.field().tools[1].last_clip_outlet, 1);
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    stage.exchange_to(Hand::right, InstrumentKind::harmonic);
    ASSERT_GT(divide(stage, band, 0.004), 0);
    EXPECT_EQ(stage.field().outlets[1].flow, 0.0);

    // The next one is sealed by heat at its root.
    const std::size_t other = vessel_band(stage, 1);
    stage.open(Hand::left);
    stage.open(Hand::right);
    stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, 0.03));
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    ASSERT_GT(divide(stage, other, 0.004), 0);
    EXPECT_GT(stage.field().outlets[3].flow, 0.0);
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    const Vector3 place = stage.field().outlets[3].position + Vector3(0, 0, 0.002);
    stage.go(Hand::right, place);
    stage.press(Hand::right, button_energy, true);
    stage.run(6);
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::vessel);
    EXPECT_EQ(stage.field().outlets[3].flow, 0.0);
}

TEST(BandsPart, TornVesselsAreInjuriesAndBleedFreely) {
    BandsStage stage;
    const std::size_t band = vessel_band(stage);
    stage.take(Hand::left, band, 0.5);
    stage.grip[0] = 16;
    for (int i = 0; i < 60 && !stage.bands()[band].divided(); ++i)
        stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, 0.001), 0.05);
    ASSERT_TRUE(stage.bands()[band].divided());
    EXPECT_TRUE(stage.bands()[band].torn);
    EXPECT_TRUE(stage.field().outlets[0].injured);
    EXPECT_GT(stage.field().outlets[0].flow, 2 * stage.field().outlets[1].flow * 0.4);
}

TEST(BandsPart, SuctionRemovesBloodAndSmoke) {
    BandsStage stage;
    const std::size_t band = vessel_band(stage);
    ASSERT_GT(divide(stage, band, 0.010), 0);
    stage.run(8);
    stage.open(Hand::left);
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    stage.exchange_to(Hand::right, InstrumentKind::suction);
    const double smoke = stage.field().smoke;
    const Vector3 place = stage.field().outlets[1].position;
    const double depth = stage.field().outlets[1].blood_depth;
    EXPECT_GT(depth, 1e-4);
    stage.go(Hand::right, place + Vector3(0, 0, 0.004));
    stage.press(Hand::right, button_energy, true);
    stage.run(2);
    EXPECT_EQ(stage.outputs.back().sample.hand[1].flags & hand_energy, 0);  // suction is not energy
    EXPECT_GT(stage.field().removed, 0.3e-6);
    EXPECT_LT(stage.field().outlets[1].blood_depth, depth);
    EXPECT_LT(stage.field().smoke, 0.9 * smoke);
}

TEST(BandsPart, NerveIsHeatedByNearEnergyOnly) {
    double dose[3];
    int i = 0;
    for (const double gap : {0.001, 0.003, 0.012}) {
        BandsStage stage;
        const Vector3 nerve = stage.field().nerves[0].line[12];
        const double reach =
            gap + stage.scene.instrument(Hand::right)->tip_radius + stage.field().nerve_radius;
        stage.go(Hand::right, nerve + Vector3(0, 0, reach));
        stage.press(Hand::right, button_energy, true);
        stage.run(3);
        EXPECT_NEAR(stage.field().tools[1].nerve_distance, gap, 0.0006) << gap;
        dose[i++] = stage.field().worst_nerve_dose;
    }
    EXPECT_GT(dose[0], 100 * std::max(dose[1], 1e-3));
    EXPECT_EQ(dose[2], 0.0);
}

TEST(BandsPart, HookDividesTheBandAtItsTip) {
    BandsStage stage;
    std::size_t band = 0;
    while (stage.bands()[band].vessel >= 0) ++band;
    stage.exchange_to(Hand::right, InstrumentKind::hook);
    ASSERT_EQ(stage.field().tools[1].kind, InstrumentKind::hook);
    const Vector3 place = stage.bands()[band].position[strand_segments / 2];
    stage.go(Hand::right, place + Vector3(0, 0, 0.02));
    stage.go(Hand::right, place + Vector3(0, 0, 0.001));
    stage.run(1);
    EXPECT_FALSE(stage.bands()[band].divided());  // no pedal
    stage.press(Hand::right, button_energy, true);
    const std::uint32_t begun = stage.tick;
    while (!stage.bands()[band].divided() && stage.tick - begun < 20000) stage.step();
    EXPECT_TRUE(stage.bands()[band].divided());
    EXPECT_FALSE(stage.bands()[band].torn);
    EXPECT_LT(stage.tick - begun, 8000U);
    EXPECT_EQ(stage.field().tools[1].band, static_cast<std::int32_t>(band));
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::band);
    EXPECT_GT(stage.bands()[band].char_share[strand_segments / 2], 0.0F);
    for (std::size_t b = 0; b < stage.bands().size(); ++b)
        EXPECT_EQ(stage.bands()[b].divided(), b == band) << b;
    EXPECT_FALSE(stage.field().nerves[0].divided);
}

TEST(BandsPart, ActivatedHookBurnsTheNerveAndDividesIt) {
    BandsStage stage;
    stage.exchange_to(Hand::right, InstrumentKind::hook);
    const Vector3 nerve = stage.field().nerves[0].line[12];
    const double reach = stage.scene.instrument(Hand::right)->tip_radius + stage.field().nerve_radius;
    stage.go(Hand::right, nerve + Vector3(0, 0, 0.03));
    stage.go(Hand::right, nerve + Vector3(0, 0, reach + 0.0003));
    stage.run(0.5);
    EXPECT_EQ(stage.field().worst_nerve_dose, 0.0);
    stage.press(Hand::right, button_energy, true);
    stage.run(0.3);
    EXPECT_EQ(stage.field().tools[1].target, EnergyTarget::nerve);
    EXPECT_GT(stage.field().worst_nerve_dose, stage.scene.bands->nerve_dose_limit);
    EXPECT_FALSE(stage.field().nerves[0].divided);
    stage.go(Hand::right, nerve + Vector3(0, 0, 0.0005));
    EXPECT_TRUE(stage.field().nerves[0].divided);
}

TEST(BandsPart, SameInputGivesTheSameBits) {
    std::uint64_t hashes[2] = {0, 0};
    for (std::uint64_t& hash : hashes) {
        BandsStage stage;
        divide(stage, vessel_band(stage), 0.006);
        stage.run(0.5);
        while (stage.record.state_hash == 0) stage.step();
        hash = stage.record.state_hash;
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_NE(hashes[0], 0u);
}

TEST(BandsPart, StepNeitherAllocatesNorWaits) {
    BandsStage stage;
    stage.take(Hand::left, 3, 0.7);
    stage.take(Hand::right, 3, 0.4);
    stage.press(Hand::right, button_energy, true);
    stage.run(0.2);
    const std::uint64_t before = test::allocation_count(), waits = test::wait_count();
    stage.run(6);
    EXPECT_EQ(test::allocation_count() - before, 0u);
    if (test::waits_are_counted) {
        EXPECT_EQ(test::wait_count() - waits, 0u);
    }
}

TEST(BandsExtremes, StaysFiniteForAnyInput) {
    Random random(17);
    const int trials = std::max(3, test::cases_asked() / 250);
    for (int trial = 0; trial < trials; ++trial) {
        Scene scene = bands_scene();
        scene.ticks_per_step = 1 + static_cast<int>(random.below(50));
        scene.bands->young_modulus = test::between(random, 1, 1e9);
        scene.bands->tear_force = test::between(random, 0.05, 1000);
        scene.bands->exchange_time = 0;
        BandsStage stage(scene, random.bits());
        for (int i = 0; i < 60; ++i) {
            for (int hand = 0; hand < hand_count; ++hand) {
                const Vector3 target = stage.bands()[random.below(10)].position[random.below(strand_nodes)];
                stage.tip[hand] = target + 0.01 * test::inside_unit_box(random);
                if (random.below(6) == 0) stage.tip[hand] += test::inside_unit_box(random);
                if (random.below(12) == 0) stage.tip[hand].y() = test::not_a_length(random);
                stage.jaw[hand] = random.uniform(0, 1);
                stage.grip[hand] = random.below(3) == 0 ? 0 : test::between(random, 0.1, 1000);
                stage.buttons[hand] = static_cast<std::uint16_t>(random.below(16));
            }
            stage.step();
            const FieldView& view = stage.field();
            for (const BandView& band : stage.bands()) {
                for (const Vector3& p : band.position) ASSERT_TRUE(p.allFinite()) << trial;
                for (const float heat : band.heat) ASSERT_TRUE(std::isfinite(heat)) << trial;
            }
            for (const float blood : view.blood) ASSERT_TRUE(std::isfinite(blood) && blood >= 0) << trial;
            ASSERT_TRUE(std::isfinite(view.lost) && std::isfinite(view.smoke) &&
                        std::isfinite(view.lateral_dose))
                << trial;
            for (const TickOutput& output : stage.outputs) {
                for (const Vector3& force : output.device_force)
                    ASSERT_LE(force.norm(), scene.force_limit + 1e-9) << trial;
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum
