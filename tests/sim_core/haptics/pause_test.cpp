// SPDX-License-Identifier: Apache-2.0
// What a pause leaves as it is in the haptic loop.
#include <gtest/gtest.h>

#include <memory>

#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

/// A left tip deep in the bowel, and its loop alone, without further steps of the world.
struct PressedTip {
    test::SheetRig rig{load_scene(test::source_path("assets/scenes/b1_bowel.json"))};
    std::unique_ptr<LocalModels> models;

    PressedTip() {
        const Vector3 trocar = rig.trocar[0].position;
        Vector3 nearest = rig.world.snapshot().bowel.rings.front().position;
        for (const RingFrame& ring : rig.world.snapshot().bowel.rings) {
            if ((ring.position - trocar).norm() < (nearest - trocar).norm()) nearest = ring.position;
        }
        const Vector3 out = (trocar - nearest).normalized();
        const Vector3 crest = nearest + rig.scene.bowel->outer_radius * out;
        rig.go(0, crest + 0.03 * out, 0.2);
        rig.go(0, crest - 0.010 * out, 0.05);
        rig.steps(60);
        models = std::make_unique<LocalModels>(rig.world.local_models());
    }
    /// The next ticks have a model of that mode, of now.
    void adopt(LocalMode mode) {
        models->hand[0].mode = mode;
        models->hand[0].tick = rig.tick;
        rig.loop.adopt(*models);
    }
    /// N, of the model, in the next tick.
    double tick(std::uint32_t flags = 0) {
        RigSample input;
        input.tick = ++rig.tick;
        input.flags = flags;
        for (int h = 0; h < hand_count; ++h) input.hand[h] = rig.last[h];
        input.camera = start_sample(rig.scene.camera->trocar, rig.scene.camera->start_insertion);
        const TickSample sample = rig.loop.tick(input).sample;
        const std::int32_t(&force)[3] = sample.hand[0].force;
        return sample_force_unit * Vector3(force[0], force[1], force[2]).norm();
    }
};

TEST(HapticPause, DepthThatAHoldLeftInIsNotLetOutInAPauseOrALoss) {
    for (const std::uint32_t flag : {std::uint32_t{rig_paused}, std::uint32_t{rig_device_lost}}) {
        PressedTip stage;
        ASSERT_EQ(stage.models->hand[0].mode, LocalMode::surface);
        const double pressed = stage.tick();
        ASSERT_GT(pressed, 0.1) << "it presses";
        stage.adopt(LocalMode::grasp);  // jaws hold there, and open
        stage.tick();
        stage.adopt(LocalMode::surface);
        ASSERT_LT(stage.tick(), 0.2 * pressed) << "what was drawn in is let out slowly";
        for (int i = 0; i < 1000; ++i) ASSERT_LT(stage.tick(flag), 0.2 * pressed) << i;
        ASSERT_LT(stage.tick(), 0.2 * pressed) << "the first tick afterwards";
        // From then on it is let out again.
        double later = 0;
        for (int i = 0; i < 1500; ++i) later = stage.tick();
        EXPECT_GT(later, 0.5 * pressed);
    }
}

}  // namespace
}  // namespace fulcrum
