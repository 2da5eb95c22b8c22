// SPDX-License-Identifier: Apache-2.0
// Clips on bands, every one of which stays on one band, and where the vessel of a band ends that is divided
// again.
#include <gtest/gtest.h>

#include <cmath>

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

/// Vessels that heat does not close, so that what is divided bleeds.
Scene open_vessels() {
    Scene scene = bands_scene();
    scene.bands->seal_time = 50;
    return scene;
}

std::size_t band_with_a_vessel(const BandsStage& stage) {
    return static_cast<std::size_t>(stage.world.find<BandsPart>()->layout().vessel_bands[0]);
}

/// The shears of the right hand divide a band once at a share of its length from the root and leave. Returns
/// its divided segment that is nearest to the root.
int divide_once(BandsStage& stage, std::size_t band, double share) {
    // The two segments at the node that the jaws take: others may be hot from an earlier division.
    const std::uint32_t taken = 3U << static_cast<unsigned>(std::lround(share * strand_segments) - 1);
    EXPECT_EQ(stage.bands()[band].parted & taken, 0U);
    stage.take(Hand::right, band, share);
    EXPECT_TRUE(stage.world.snapshot().grasps[1].held);
    EXPECT_EQ(stage.world.snapshot().grasps[1].patch, static_cast<std::int32_t>(band));
    stage.press(Hand::right, button_energy, true);
    const std::uint32_t begun = stage.tick;
    while ((stage.bands()[band].parted & taken) == 0 && stage.tick - begun < 20000) stage.step();
    stage.press(Hand::right, button_energy, false);
    stage.open(Hand::right);
    stage.go(Hand::right, stage.tip[1] + Vector3(0, 0, 0.03));
    stage.run(0.5);
    EXPECT_NE(stage.bands()[band].parted & taken, 0U);
    int nearest = 0;
    while (nearest < strand_segments && (stage.bands()[band].parted >> nearest & 1U) == 0) ++nearest;
    return nearest;
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

TEST(BandClips, OnTheStumpStopTheBleedingOfItsEnd) {
    BandsStage stage(open_vessels());
    const std::size_t band = band_with_a_vessel(stage);
    ASSERT_GT(divide_once(stage, band, 0.75), 7);
    ASSERT_GT(stage.field().outlets[0].flow, 0.0);
    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    const std::vector<Vector3> nodes(stage.bands()[band].position.begin(),
                                     stage.bands()[band].position.end());
    fire_at(stage, nodes[11]);  // of the piece at the other end
    EXPECT_EQ(stage.bands()[band].clips, 1U << 11U);
    EXPECT_EQ(stage.field().tools[1].last_clip_outlet, -1);
    EXPECT_GT(stage.field().outlets[0].flow, 0.0);
    fire_at(stage, nodes[2]);
    EXPECT_EQ(stage.bands()[band].clips, (1U << 11U) | (1U << 2U));
    EXPECT_EQ(stage.field().tools[1].last_clip_outlet, 0);
    EXPECT_TRUE(stage.field().outlets[0].clipped);
    EXPECT_EQ(stage.field().outlets[0].flow, 0.0);
    EXPECT_EQ(stage.field().tools[1].clips_left, stage.scene.bands->clips - 2);
}

TEST(BandClips, AreNotFiredByAnApplierThatCameWithItsJawsClosed) {
    BandsStage stage;
    stage.open(Hand::right);
    stage.press(Hand::right, button_exchange, true);
    stage.step();
    stage.press(Hand::right, button_exchange, false);
    stage.run(0.5);
    stage.close(Hand::right);  // on its way through the trocar
    stage.run(stage.scene.bands->exchange_time);
    ASSERT_EQ(stage.field().tools[1].kind, InstrumentKind::clip_applier);
    ASSERT_EQ(stage.field().tools[1].exchange_left, 0.0F);
    EXPECT_EQ(stage.field().tools[1].clips_left, stage.scene.bands->clips);
    stage.open(Hand::right);
    stage.close(Hand::right);
    EXPECT_EQ(stage.field().tools[1].clips_left, stage.scene.bands->clips - 1);
}

TEST(BandsDividedAgain, BleedWhereTheyWereDividedNearestToTheRoot) {
    BandsStage stage(open_vessels());
    const std::size_t band = band_with_a_vessel(stage);
    const int first = divide_once(stage, band, 0.67);
    EXPECT_GT(stage.field().outlets[0].flow, 0.0);
    const int second = divide_once(stage, band, 0.25);
    ASSERT_LT(second, first);
    stage.run(2);  // the piece between the cuts falls
    const OutletView& trunk = stage.field().outlets[0];
    EXPECT_EQ(trunk.position, stage.bands()[band].position[static_cast<std::size_t>(second)]);
    EXPECT_GT(trunk.position.z(), stage.scene.bands->centre.z()) << "on the stump, not on the piece";
    EXPECT_GT(trunk.flow, 0.0);

    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    fire_at(stage, Vector3(trunk.position));
    EXPECT_EQ(stage.field().tools[1].last_clip_outlet, 0);
    EXPECT_EQ(trunk.flow, 0.0) << "a clip reaches it";
    EXPECT_EQ(stage.bands()[band].clips, 1U << static_cast<unsigned>(second)) << "drawn at the end";
}

TEST(BandsDividedAgain, BleedThoughAClipCameOffWithTheEnd) {
    BandsStage stage(open_vessels());
    const std::size_t band = band_with_a_vessel(stage);
    stage.exchange_to(Hand::right, InstrumentKind::clip_applier);
    fire_at(stage, Vector3(stage.bands()[band].position[6]));
    ASSERT_EQ(stage.bands()[band].clips, 1U << 6U);
    stage.exchange_to(Hand::right, InstrumentKind::harmonic);
    ASSERT_GT(divide_once(stage, band, 0.67), 6);
    EXPECT_TRUE(stage.field().outlets[0].clipped);
    EXPECT_FALSE(stage.field().outlets[0].injured);
    EXPECT_EQ(stage.field().outlets[0].flow, 0.0);
    ASSERT_LT(divide_once(stage, band, 0.25), 6);
    EXPECT_FALSE(stage.field().outlets[0].clipped);
    EXPECT_TRUE(stage.field().outlets[0].injured) << "divided before it was closed there";
    EXPECT_GT(stage.field().outlets[0].flow, 0.0);
}

TEST(BandsDividedAgain, BleedNoMoreAfterACutThroughWhatCameOff) {
    BandsStage stage(open_vessels());
    const std::size_t band = band_with_a_vessel(stage);
    const int first = divide_once(stage, band, 0.25);
    const OutletView before = stage.field().outlets[0];
    const std::uint32_t parted = stage.bands()[band].parted;
    divide_once(stage, band, 0.75);
    ASSERT_NE(stage.bands()[band].parted, parted);
    const OutletView& after = stage.field().outlets[0];
    EXPECT_EQ(after.position, stage.bands()[band].position[static_cast<std::size_t>(first)]);
    EXPECT_LE(after.flow, before.flow) << "no vessel is opened by a cut through what came off";
    EXPECT_GT(after.flow, 0.0);
}

}  // namespace
}  // namespace fulcrum
