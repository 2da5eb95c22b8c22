// SPDX-License-Identifier: Apache-2.0
// What operators do apart from the stroke: energy, suction, clips. A field that answers at once stands in for
// the world.
#include "assessment/operators/field_turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "assessment/operators/blade_pedal.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr std::array<InstrumentKind, 4> kinds = {InstrumentKind::hook, InstrumentKind::suction,
                                                 InstrumentKind::clip_applier, InstrumentKind::harmonic};

/// A right hand before one place that bleeds or not.
class FieldStage {
  public:
    explicit FieldStage(OperatorLevel preset, double flow, double smoke) {
        draw_individual(preset, 7, skill);
        scene = load_scene(test::source_path("assets/scenes/c4_posterior.json"));
        limb = std::make_unique<Limb>(skill, *scene.instrument(Hand::right), 1e-3, Random(3, 5));
        body.limb[1] = limb.get();
        seen.outlets.resize(1);
        seen.outlets[0].position = limb->destination() + Vector3(0.01, -0.02, -0.03);
        seen.outlets[0].flow = flow;
        seen.smoke = smoke;
        seen.tools[1].clips_left = 12;
        seen.tip[1] = limb->tip();
    }
    /// Runs until the blade is back; returns the kinds of instrument that the hand held, in order.
    std::vector<InstrumentKind> turn(double longest_s) {
        FieldTurn field(skill);
        std::vector<InstrumentKind> held{InstrumentKind::hook};
        EXPECT_TRUE(field.wanted(seen, *limb));
        field.begin(seen);
        bool back = false, was_pressed = false, was_open = false;
        while (!back && limb->time() < longest_s) {
            limb->tick();
            const DeviceSample sample = limb->sample();
            const bool pressed = (sample.buttons & button_exchange) != 0;
            seen.tip[1] = limb->tip();
            const double away = (seen.tip[1] - seen.outlets[0].position).norm();
            if (pressed && !was_pressed) held.push_back(kinds[held.size() % kinds.size()]);
            was_pressed = pressed;
            const bool sucks =
                held.back() == InstrumentKind::suction && (sample.buttons & button_energy) != 0;
            if (sucks) seen.smoke *= 0.99;
            sucked_s += sucks ? 1e-3 : 0;
            sucked_there = sucked_there || (sucks && away < 0.008);
            if (held.back() == InstrumentKind::clip_applier) {
                was_open = was_open || limb->jaw() > 0.4;
                if (was_open && limb->jaw() < 0.2 && limb->grip() > 0.2) {
                    clipped_within = away;
                    if (away < 0.006) seen.outlets[0].flow = 0;
                }
            }
            seen.tools[1].kind = held.back();
            back = field.update(seen, body, 1);
        }
        EXPECT_TRUE(back);
        EXPECT_FALSE(field.wanted(seen, *limb)) << "one turn is enough, for a while";
        return held;
    }
    Scene scene;
    Skill skill;
    std::unique_ptr<Limb> limb;
    Body body;
    Perception seen;
    double sucked_s = 0, clipped_within = 1;
    bool sucked_there = false;
};

TEST(FieldTurn, SmokeIsRemovedAtThePositionOfTheHand) {
    FieldStage stage(OperatorLevel::expert, 0, 0.5);
    const Vector3 before = stage.limb->destination();
    const std::vector<InstrumentKind> held = stage.turn(30);
    ASSERT_GE(held.size(), 5U);
    EXPECT_EQ(held[1], InstrumentKind::suction);
    EXPECT_EQ(held.back(), InstrumentKind::hook);
    EXPECT_GT(stage.sucked_s, 0.5);
    EXPECT_LT(stage.seen.smoke, 0.1);
    EXPECT_LT((stage.limb->destination() - before).norm(), 1e-9);
}

TEST(FieldTurn, BleedingIsSuctionedAndClippedAtItsSource) {
    for (const auto& [preset, name, title] : operator_levels) {
        FieldStage stage(preset, 2e-7, 0);
        const std::vector<InstrumentKind> held = stage.turn(60);
        EXPECT_EQ(held.back(), InstrumentKind::hook) << name;
        EXPECT_TRUE(stage.sucked_there) << name;
        EXPECT_LT(stage.clipped_within, 0.006) << name;
        EXPECT_EQ(stage.seen.outlets[0].flow, 0.0) << name;
    }
}

TEST(FieldTurn, WithoutClipsTheWorkContinues) {
    FieldStage stage(OperatorLevel::expert, 2e-7, 0);
    stage.seen.tools[1].clips_left = 0;
    EXPECT_EQ(stage.turn(30).back(), InstrumentKind::hook);
    EXPECT_EQ(stage.clipped_within, 1.0);
}

TEST(FieldTurn, AClearFieldNeedsNoAction) {
    const FieldStage stage(OperatorLevel::novice, 0, 0.1);
    EXPECT_FALSE(FieldTurn(stage.skill).wanted(stage.seen, *stage.limb));
}

/// Seconds with energy on while a blade approaches (1 s), divides (3 s) and withdraws (1 s).
std::array<double, 3> powered(FieldStage& stage, double foresight, bool beside_nerve) {
    stage.skill.foresight = foresight;
    BladePedal pedal(stage.skill, true);
    pedal.plan(*stage.limb);
    if (beside_nerve) stage.seen.nerve.push_back(stage.seen.tip[1] + Vector3(0.005, 0, 0));
    std::array<double, 3> seconds{};
    for (int i = 0; i < 500; ++i) {
        for (int tick = 0; tick < 10; ++tick) stage.limb->tick();
        stage.seen.display.cutting = i >= 100 && i < 400;
        if (i == 400) pedal.lifted(*stage.limb);
        if (i < 100)
            pedal.press(*stage.limb, stage.seen, 1, false);
        else if (i < 400)
            pedal.stroke(*stage.limb, stage.seen, 1, 0.02);
        else
            pedal.lift(*stage.limb);
        const std::size_t part = i < 100 ? 0 : i < 400 ? 1 : 2;
        seconds[part] += (stage.limb->sample().buttons & button_energy) != 0 ? 0.01 : 0;
    }
    return seconds;
}

TEST(BladePedal, OperatorWithForesightActivatesOnlyInTissueAndBriefly) {
    FieldStage stage(OperatorLevel::expert, 0, 0);
    const auto seconds = powered(stage, 1, false);
    EXPECT_EQ(seconds[0], 0);
    EXPECT_GT(seconds[1], 1.5);
    EXPECT_LT(seconds[1], 2.8);
    EXPECT_EQ(seconds[2], 0);
    EXPECT_EQ(powered(stage, 1, true)[1], 0) << "cold beside a nerve";
}

TEST(BladePedal, OperatorWithoutForesightHeatsAirAndNerve) {
    FieldStage stage(OperatorLevel::novice, 0, 0);
    const auto seconds = powered(stage, 0, true);
    EXPECT_NEAR(seconds[0], 1, 0.011);
    EXPECT_NEAR(seconds[1], 3, 0.011);
    EXPECT_GT(seconds[2], 0.1);
    EXPECT_LT(seconds[2], 0.9);
}

}  // namespace
}  // namespace fulcrum
