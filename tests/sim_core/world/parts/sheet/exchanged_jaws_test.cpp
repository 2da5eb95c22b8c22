// SPDX-License-Identifier: Apache-2.0
// Jaws of an exchanged instrument on the sheet.
#include <gtest/gtest.h>

#include "sim_core/world/parts/sheet/sheet_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

TEST(SheetJaws, OfAnExchangedInstrumentTakeNothingBeforeTheyWereOpen) {
    const Scene scene = test::sheet_scene();
    SheetPart sheet(scene, scene.step_period());
    const InstrumentSpec grasper = *scene.instrument(Hand::left);
    InstrumentSpec hook = grasper;
    hook.kind = InstrumentKind::hook;
    SheetAction actions[hand_count];
    ToolKinematics& tool = actions[0].tool;
    tool.present = tool.inside = true;
    tool.rotation = Vector3(1, -1, -1).asDiagonal();
    // The middle of the jaws is at the flap's edge.
    tool.tip = scene.sheet->centre + 0.45 * scene.sheet->width * scene.sheet->across +
               0.5 * grasper.jaw_length * tool.axis;
    std::uint32_t tick = 0;
    const auto holds_with = [&](const InstrumentSpec& spec, bool closed) {
        actions[0].instrument = &spec;
        tool.jaw_angle = closed ? 0.02 : spec.jaw_opening;
        tool.grip = closed ? 4 : 0;
        tick += static_cast<std::uint32_t>(scene.ticks_per_step);
        sheet.step(actions, tick, scene.step_period());
        return sheet.holds(0);
    };
    EXPECT_FALSE(holds_with(hook, true));
    EXPECT_FALSE(holds_with(grasper, true)) << "closed since before the exchange";
    EXPECT_FALSE(holds_with(grasper, false));
    EXPECT_TRUE(holds_with(grasper, true));
}

}  // namespace
}  // namespace fulcrum
