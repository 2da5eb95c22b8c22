// SPDX-License-Identifier: Apache-2.0
// Two hands on one band: each divides the segments that its own power goes to.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim_core/world/parts/bands/bands_stage.h"

namespace fulcrum {
namespace {

using test::bands_scene;
using test::BandsStage;

/// Seconds until a band is divided that the shears of both hands hold 4 segments apart, with the pedals that
/// are down; 20 if it is not.
double seconds_with_pedals(bool left, bool right) {
    Scene scene = bands_scene();
    for (InstrumentSpec& spec : scene.instruments) {
        if (spec.hand == Hand::left) spec.kind = InstrumentKind::harmonic;
    }
    BandsStage stage(scene);
    constexpr std::size_t band = 2;
    stage.take(Hand::left, band, 0.75);
    stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, 0.004));
    stage.take(Hand::right, band, 0.4);
    EXPECT_TRUE(stage.world.snapshot().grasps[0].held);
    EXPECT_TRUE(stage.world.snapshot().grasps[1].held);
    stage.press(Hand::left, button_energy, left);
    stage.press(Hand::right, button_energy, right);
    const std::uint32_t begun = stage.tick;
    while (!stage.bands()[band].divided() && stage.tick - begun < 20000) stage.step();
    EXPECT_FALSE(stage.bands()[band].torn);
    return (stage.tick - begun) * 1e-3;
}

TEST(BandsTwoHands, DivideABandNoFasterThanTheFasterOfThem) {
    const double left = seconds_with_pedals(true, false), right = seconds_with_pedals(false, true);
    const double faster = std::min(left, right);
    ASSERT_GT(faster, 1.0);
    ASSERT_LT(faster, 15.0);
    EXPECT_NEAR(seconds_with_pedals(true, true), faster, 0.05 * faster)
        << "left alone " << left << " s, right alone " << right << " s";
}

TEST(TwoHands, WhatOneHoldsStaysWhereItIsWhileItsDeviceDoesNotAnswer) {
    test::BandsStage stage;
    stage.take(Hand::left, 2, 0.5);
    stage.run(0.4);
    ASSERT_TRUE(stage.world.snapshot().grasps[0].held);
    for (int i = 0; i < 10; ++i) {
        stage.tip[0] += Vector3(0, 0, 1e-4);
        stage.step();
    }
    const GraspModel& grasp = stage.world.local_models().hand[0].grasp;
    const Vector3 point = grasp.point;
    ASSERT_GT(grasp.velocity.z(), 0.01);
    stage.silent[0] = true;
    stage.step();
    EXPECT_TRUE(stage.world.snapshot().grasps[0].held);
    EXPECT_EQ(grasp.velocity.norm(), 0);
    EXPECT_EQ(grasp.point, point);
}

}  // namespace
}  // namespace fulcrum
