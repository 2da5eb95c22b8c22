// SPDX-License-Identifier: Apache-2.0
// Hand over hand: the second jaws take hold 0 to 15 mm from the first, whichever hand is first and whatever
// the tissue; nothing is lost, and at rest neither hand feels more than 3 N.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/sim_core/world/hands_on_tissue.h"

namespace fulcrum {
namespace {

class HandOver : public testing::TestWithParam<const char*> {};

TEST_P(HandOver, AtAnyDistanceLosesNothingAndLoadsNoHand) {
    const test::HeldScene held = test::held_scene(GetParam());
    test::SheetRig rig(held.scene);
    const auto jaws_on = [&](int h, const Vector3& place) { return test::tip_for_jaws(rig, h, place); };
    const auto rests = [&](int h, const std::string& when) {
        rig.steps(60);
        double most = 0;
        for (int i = 0; i < 10; ++i) {
            rig.step();
            most = std::max(most, rig.world.snapshot().grasps[h].reaction.norm());
            most = std::max(most, test::recorded_force(rig, h));
        }
        EXPECT_LE(most, 3.0) << when << ", hand " << h;
        EXPECT_TRUE(rig.world.snapshot().grasps[h].held) << when << ", hand " << h;
    };
    for (const int first : {0, 1}) {
        const int second = 1 - first;
        for (const double apart : {0.0, 0.001, 0.002, 0.004, 0.006, 0.008, 0.012, 0.015}) {
            const std::string when =
                std::to_string(1e3 * apart) + " mm apart, hand " + std::to_string(first) + " first";
            const auto reach_for = [&](int h, double from_middle) {
                test::TissuePlace where = held.place(rig.world, from_middle);
                rig.go(h, jaws_on(h, where.point + 0.02 * where.out), 0.2);
                where = held.place(rig.world, from_middle);
                rig.go(h, jaws_on(h, where.point + 0.002 * where.out), 0.1);
                rig.wish[h].closed = true;
                rig.steps(30);
                ASSERT_TRUE(rig.world.snapshot().grasps[h].held) << when << ", hand " << h;
            };
            const auto let_go = [&](int h) {
                rig.wish[h].closed = false;
                rig.steps(20);
                EXPECT_FALSE(rig.world.snapshot().grasps[h].held) << when;
                const test::TissuePlace where = held.place(rig.world, 0);
                rig.go(h, rig.wish[h].tip + 0.02 * where.out, 0.2);
                rig.go(h, where.point + 0.05 * where.out + Vector3(h == 0 ? 0.04 : -0.04, 0, 0), 0.3);
            };
            reach_for(first, -0.5 * apart);
            rests(first, when + ", before");
            reach_for(second, 0.5 * apart);
            rests(first, when + ", both");
            rests(second, when + ", both");
            let_go(first);
            rests(second, when + ", handed over");
            let_go(second);
            rig.steps(100);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tissues, HandOver, testing::Values("bowel", "bowel_with_membrane", "membrane", "sheet", "band", "rectum"),
    [](const testing::TestParamInfo<const char*>& tissue) { return std::string(tissue.param); });

}  // namespace
}  // namespace fulcrum
