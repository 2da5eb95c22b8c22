// SPDX-License-Identifier: Apache-2.0
// Instruments of C4 that are exchanged at a sheet, or whose device does not answer for a short time.
#include <gtest/gtest.h>

#include "tests/sim_core/world/parts/structures/structures_stage.h"

namespace fulcrum {
namespace {

TEST(StructuresAbsence, AnExchangedInstrumentIsNotThroughTheSheetThatTheLastOnePressed) {
    test::StructuresStage stage(test::structures_scene(), true);
    const Vector3 middle = stage.scene.sheet->centre;
    const auto hand = [&]() -> const SheetHand& { return stage.sheet->state().hands[1]; };
    stage.go(1, middle + Vector3(0, 0, 0.015), 0.2);
    stage.go(1, middle + Vector3(0, 0, -0.012));
    stage.run(0.1);
    ASSERT_EQ(hand().touch, BladeTouch::touching);
    ASSERT_EQ(hand().side, 1);
    stage.press(1, button_exchange, true);
    stage.step();
    stage.press(1, button_exchange, false);
    stage.run(0.1);
    EXPECT_EQ(hand().touch, BladeTouch::away) << "it is out of the body";
    stage.run(stage.scene.structures->exchange_time + 0.3);
    EXPECT_EQ(stage.field().tools[1].kind, InstrumentKind::suction);
    EXPECT_EQ(hand().touch, BladeTouch::touching);
    EXPECT_EQ(hand().side, 1);
    EXPECT_GT(hand().gap, 0) << "the sheet is below the tip";
}

TEST(StructuresAbsence, ABladeDividesTheNerveThatItsPathCrossesWhileItsDeviceDidNotAnswer) {
    test::StructuresStage stage;
    const Vector3 nerve = stage.field().nerves[1].line[12];
    stage.take(1, InstrumentKind::scissors);
    stage.tool[1].tip = nerve + Vector3(-0.02, 0, 0.0004);
    stage.press(1, button_primary, true);
    stage.step();
    stage.tool[1].present = false;
    stage.step();
    EXPECT_FALSE(stage.field().nerves[1].divided);
    stage.tool[1].present = true;
    stage.tool[1].tip = nerve + Vector3(0.02, 0, 0.0004);
    stage.step();
    EXPECT_TRUE(stage.field().nerves[1].divided);
}

}  // namespace
}  // namespace fulcrum
