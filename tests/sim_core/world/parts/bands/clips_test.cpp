// SPDX-License-Identifier: Apache-2.0
// Clips on bands that are whole: every one stays, and each sits on one band.
#include <gtest/gtest.h>

#include "tests/sim_core/world/parts/bands/bands_stage.h"

namespace fulcrum {
namespace {

using test::bands_scene;
using test::BandsStage;

/// The right hand, which has the clip applier, fires with the middle of its jaws at a place.
void fire_at(BandsStage& stage, const Vector3& place) {
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip_for_jaws(Hand::right, place + Vector3(0, 0, 0.02)));
    stage.go(Hand::right, stage.tip_for_jaws(Hand::right, place));
    stage.close(Hand::right);
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip_for_jaws(Hand::right, place + Vector3(0, 0, 0.02)));
}

TEST(BandClips, OnTheRootSideKeepsTheVesselDryWhateverIsClippedBehindIt) {
    BandsStage stage;
    const auto band = static_cast<std::size_t>(stage.world.find<BandsPart>()->layout().vessel_bands[0]);
    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    const Vector3 near_root = stage.bands()[band].position[2], behind = stage.bands()[band].position[8];
    fire_at(stage, near_root);
    ASSERT_EQ(stage.bands()[band].clips, 1U << 2U);
    fire_at(stage, behind);
    ASSERT_EQ(stage.bands()[band].clips, (1U << 2U) | (1U << 8U)) << "both stay, and are drawn";
    stage.exchange_to(Hand::right, InstrumentKind::harmonic);

    stage.take(Hand::left, band, 0.75);
    stage.go(Hand::left, stage.tip[0] + Vector3(0, 0, 0.004));
    stage.take(Hand::right, band, 0.4);  // between the clips
    stage.press(Hand::right, button_energy, true);
    const std::uint32_t begun = stage.tick;
    while (!stage.bands()[band].divided() && stage.tick - begun < 20000) stage.step();
    ASSERT_TRUE(stage.bands()[band].divided());
    EXPECT_TRUE(stage.field().outlets[0].clipped) << "by the first";
    EXPECT_FALSE(stage.field().outlets[0].injured);
    EXPECT_EQ(stage.field().outlets[0].flow, 0.0);
}

TEST(BandClips, SitOnTheNearestBandOnly) {
    Scene scene = bands_scene();
    scene.bands->jitter = scene.bands->tilt = 0;
    scene.bands->half_extent.y() = 0.0125;  // bands of a column are 5 mm apart
    BandsStage stage(scene);
    const Vector3 middle = stage.bands()[4].position[strand_segments / 2];
    ASSERT_NEAR((middle - stage.bands()[2].position[strand_segments / 2]).norm(), 0.005, 1e-4);
    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    fire_at(stage, middle + Vector3(0, -0.002, 0));  // 2 mm from this one, 3 mm from the one before it
    EXPECT_EQ(stage.bands()[4].clips, 1U << static_cast<unsigned>(strand_segments / 2));
    EXPECT_EQ(stage.bands()[2].clips, 0U);
    EXPECT_EQ(stage.field().tools[1].clips_left, scene.bands->clips - 1);
}

}  // namespace
}  // namespace fulcrum
