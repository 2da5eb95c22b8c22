// SPDX-License-Identifier: Apache-2.0
// A tip on the sheet, and a blade in it, whose device does not answer for a short time or whose instrument is
// exchanged: neither brings them through the tissue.
#include <gtest/gtest.h>

#include "sim_core/world/parts/sheet/sheet_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

/// The right hand's instrument over the middle of the sheet, set directly, its shaft from above.
struct TipBench {
    Scene scene = test::sheet_scene();
    SheetPart sheet{scene, scene.step_period()};
    SheetAction actions[hand_count];
    ToolKinematics& tool = actions[1].tool;
    std::uint32_t tick = 0;

    TipBench() {
        actions[1].instrument = scene.instrument(Hand::right);
        tool.present = tool.inside = true;
        tool.rotation = Vector3(1, -1, -1).asDiagonal();
        tool.tip = place(0.015);
    }
    Vector3 place(double above) const { return scene.sheet->centre + Vector3(0, 0, above); }
    const SheetHand& hand() const { return sheet.state().hands[1]; }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            tick += static_cast<std::uint32_t>(scene.ticks_per_step);
            sheet.step(actions, tick, scene.step_period());
        }
    }
    /// Straight to a height over the sheet at 50 mm/s.
    void go(double above) {
        const Vector3 from = tool.tip, to = place(above);
        const int count = std::max(1, static_cast<int>(std::lround((to - from).norm() / 2.5e-4)));
        for (int i = 1; i <= count; ++i) {
            tool.tip = from + (static_cast<double>(i) / count) * (to - from);
            run(1);
        }
    }
    void expect_pressed_from_above(const char* when) const {
        EXPECT_EQ(hand().touch, BladeTouch::touching) << when;
        EXPECT_EQ(hand().side, 1) << when;
        EXPECT_GT(hand().gap, 0) << "the sheet is below the tip, " << when;
        EXPECT_LT(hand().reaction.z(), -0.02) << when;
    }
};

TEST(SheetTips, KeepTheirSideWhileTheirDeviceDoesNotAnswer) {
    for (const int silent : {1, 8}) {
        TipBench bench;
        bench.go(-0.012);
        bench.run(20);
        bench.expect_pressed_from_above("before");
        bench.tool.present = false;
        bench.run(silent);
        EXPECT_EQ(bench.hand().touch, BladeTouch::touching) << "the instrument stays where it was";
        bench.tool.present = true;
        bench.run(20);
        bench.expect_pressed_from_above("afterwards");
    }
}

TEST(SheetTips, OfADeviceThatNeverAnsweredTouchNothing) {
    TipBench bench;
    bench.tool.present = false;
    bench.tool.tip = bench.place(0);
    bench.run(10);
    EXPECT_EQ(bench.hand().touch, BladeTouch::away);
    EXPECT_EQ(bench.hand().reaction.norm(), 0);
}

TEST(SheetTips, OfAnExchangedInstrumentAreNotThroughWhatTheLastOnePressed) {
    for (const int out : {1, 100}) {
        TipBench bench;
        bench.go(-0.012);
        bench.run(20);
        bench.tool.inside = false;
        bench.run(out);
        EXPECT_EQ(bench.hand().touch, BladeTouch::away);
        EXPECT_EQ(bench.hand().reaction.norm(), 0);
        bench.tool.inside = true;
        bench.run(60);
        bench.expect_pressed_from_above("by the new instrument");
    }
}

TEST(SheetTips, OfAnInstrumentThatIsAdvancedWhileItIsExchangedStayInFront) {
    for (const double from : {0.010, 0.040}) {  // the sheet is known at 20 mm
        TipBench bench;
        bench.tool.tip = bench.place(from);
        bench.run(5);
        bench.tool.inside = false;
        bench.run(5);
        bench.tool.tip = bench.place(-0.012);
        bench.run(5);
        bench.tool.inside = true;
        bench.run(60);
        bench.expect_pressed_from_above(from < 0.02 ? "from near" : "from far");
    }
}

// Nothing crosses the shaft of the new instrument: it came in beneath.
TEST(SheetTips, OfAnInstrumentThatComesInOnTheOtherSideAreThere) {
    TipBench bench;
    bench.tool.tip = bench.place(0.010);
    bench.run(5);
    bench.tool.inside = false;
    bench.run(5);
    bench.tool.axis = Vector3::UnitZ();
    bench.tool.rotation.setIdentity();
    bench.tool.tip = bench.place(-0.008);
    bench.tool.inside = true;
    bench.run(20);
    EXPECT_EQ(bench.hand().side, -1);
    EXPECT_EQ(bench.hand().touch, BladeTouch::away);
}

TEST(SheetTips, ABladeStaysInItsCutWhileItsDeviceDoesNotAnswer) {
    test::SheetRig rig;
    const auto at = [&](double x, double above) -> Vector3 {
        return rig.scene.sheet->centre + x * rig.scene.sheet->along + Vector3(0, 0, above);
    };
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    rig.go(1, at(-0.03, 0.02), 0.2);
    rig.wish[1].button = true;
    rig.go(1, at(-0.015, -0.006), 0.05);
    rig.go(1, at(0, -0.006), 0.04);
    double x = 0;
    for (const int silent : {1, 6}) {
        ASSERT_EQ(rig.hand(1).touch, BladeTouch::cutting);
        const int ended = rig.count(EventKind::cut_end), advanced = rig.count(EventKind::cut_advance);
        rig.wish[1].silent = true;
        rig.steps(silent);
        EXPECT_EQ(rig.hand(1).touch, BladeTouch::cutting);
        EXPECT_EQ(rig.count(EventKind::cut_advance), advanced) << "it stays where it was";
        rig.wish[1].silent = false;
        rig.step();
        EXPECT_EQ(rig.hand(1).touch, BladeTouch::cutting);
        EXPECT_EQ(rig.count(EventKind::cut_end), ended);
        x += 0.008;
        rig.go(1, at(x, -0.006), 0.04);
        EXPECT_GT(rig.count(EventKind::cut_advance), advanced) << "and divides what comes next";
    }
    rig.wish[1].button = false;
    rig.steps(2);
    EXPECT_NE(rig.hand(1).touch, BladeTouch::cutting);
}

}  // namespace
}  // namespace fulcrum
