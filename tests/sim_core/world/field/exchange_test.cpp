// SPDX-License-Identifier: Apache-2.0
// Instruments are exchanged only once their jaws have let go, whichever kind holds.
#include <gtest/gtest.h>

#include "tests/sim_core/world/parts/bands/bands_stage.h"
#include "tests/sim_core/world/parts/structures/structures_stage.h"

namespace fulcrum {
namespace {

TEST(FieldExchange, WaitsUntilABandIsLetGoWhicheverKindHoldsIt) {
    Scene scene = test::bands_scene();
    for (InstrumentSpec& spec : scene.instruments)
        if (spec.hand == Hand::left)
            spec.exchange = {InstrumentKind::grasper, InstrumentKind::bowel_grasper,
                             InstrumentKind::harmonic};
    for (const InstrumentKind kind :
         {InstrumentKind::grasper, InstrumentKind::bowel_grasper, InstrumentKind::harmonic}) {
        test::BandsStage stage(scene);
        stage.exchange_to(Hand::left, kind);
        ASSERT_EQ(stage.field().tools[0].kind, kind);
        stage.take(Hand::left, 2, 0.5);
        ASSERT_TRUE(stage.world.snapshot().grasps[0].held) << type_of(kind).name;
        stage.press(Hand::left, button_exchange, true);
        stage.step();
        stage.press(Hand::left, button_exchange, false);
        stage.step();
        EXPECT_EQ(stage.field().tools[0].kind, kind);
        EXPECT_TRUE(stage.world.snapshot().grasps[0].held) << type_of(kind).name;
        stage.open(Hand::left);
        stage.press(Hand::left, button_exchange, true);
        stage.step();
        EXPECT_NE(stage.field().tools[0].kind, kind);
    }
}

TEST(FieldExchange, WaitsUntilJawsThatMayHoldTissueAreOpen) {
    Scene scene = test::structures_scene();
    for (InstrumentSpec& spec : scene.instruments)
        if (spec.hand == Hand::right) {
            spec.kind = InstrumentKind::grasper;
            spec.exchange = {InstrumentKind::grasper, InstrumentKind::bowel_grasper};
        }
    test::StructuresStage stage(scene);
    const auto ask = [&](double jaw_angle) {
        stage.tool[1].jaw_angle = jaw_angle;
        stage.press(1, button_exchange, true);
        stage.step();
        stage.press(1, button_exchange, false);
        stage.step();
        return stage.field().tools[1].kind;
    };
    EXPECT_EQ(ask(0.05), InstrumentKind::grasper);
    EXPECT_EQ(ask(0.8), InstrumentKind::bowel_grasper);
    stage.run(scene.structures->exchange_time + 0.05);
    EXPECT_EQ(ask(0.05), InstrumentKind::bowel_grasper);
    EXPECT_EQ(ask(0.8), InstrumentKind::grasper);
}

}  // namespace
}  // namespace fulcrum
