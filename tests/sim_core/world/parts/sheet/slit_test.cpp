// SPDX-License-Identifier: Apache-2.0
// A blade in a gaping slit: there is nothing to cut between its lips.
#include <gtest/gtest.h>

#include <string>

#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

class SheetSlitOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SheetSlitOf, testing::Values("b2_areolar", "b2_plane"),
                         [](const testing::TestParamInfo<const char*>& scene) {
                             return std::string(scene.param);
                         });

TEST_P(SheetSlitOf, BladeInAGapingSlitRemovesNothingFromTheLips) {
    Scene scene = load_scene(test::source_path("assets/scenes/" + std::string(GetParam()) + ".json"));
    scene.sheet->fibres.reset();  // only a blade can remove tissue from the lips
    test::SheetRig rig(scene);
    const SheetSpec& sheet = *rig.scene.sheet;
    const auto on = [&](double x, double off, double up) -> Vector3 {
        return sheet.centre + x * sheet.along + off * sheet.across + Vector3(0, 0, up);
    };
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    rig.go(1, on(-0.03, 0, 0.02), 0.2);
    rig.wish[1].button = true;
    rig.go(1, on(-0.015, 0, -0.006), 0.05);
    rig.go(1, on(0.02, 0, -0.006), 0.04);
    ASSERT_EQ(rig.hand(1).touch, BladeTouch::cutting);
    rig.go(1, on(0.016, 0, -0.006), 0.01);
    // The flap is drawn out: the sheet moves across a stationary blade and is cut by it.
    rig.go(0, rig.wish[0].tip + Vector3(0, 0.004, 0), 0.02);
    rig.steps(100);
    rig.go(0, rig.wish[0].tip + Vector3(0, 0.004, 0.004), 0.02);
    rig.steps(300);
    // It is released. The blade stands at the end of its slit and may take a crumb there as the sheet turns.
    const double drawn = rig.sheet().surface().area_removed();
    rig.go(0, rig.wish[0].tip + Vector3(0, -0.006, 0), 0.02);
    bool adrift = rig.hand(1).adrift;
    rig.steps(100);
    const double removed = rig.sheet().surface().area_removed();
    EXPECT_LE(removed - drawn, 0.5e-6);
    const int fallen = rig.count(EventKind::piece_fallen);
    // It is drawn out, released and drawn out again: the slit, now open, moves around the blade.
    for (const double displacement : {0.008, -0.008, 0.008, 0.004}) {
        rig.go(0, rig.wish[0].tip + Vector3(0, displacement, 0), 0.02);
        adrift = adrift || rig.hand(1).adrift;
        rig.steps(100);
        EXPECT_EQ(rig.hand(1).touch, BladeTouch::cutting);
    }
    EXPECT_TRUE(adrift) << "the test did not reach the intended situation";
    EXPECT_EQ(rig.sheet().surface().area_removed(), removed);
    EXPECT_EQ(rig.count(EventKind::piece_fallen), fallen);
}

}  // namespace
}  // namespace fulcrum
