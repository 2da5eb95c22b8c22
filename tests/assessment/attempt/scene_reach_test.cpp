// SPDX-License-Identifier: Apache-2.0
// Where the handles of a task have to go.
#include "assessment/attempt/scene_reach.h"

#include <gtest/gtest.h>

#include "sim_core/instrument/mouse_mapping.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

TEST(SceneReach, TheHandleAtACornerOfItPutsTheTipThereThroughTheTrocar) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const AttemptEngine engine(scene, task, 5);
    const SceneReach reach = scene_reach(engine);
    ASSERT_TRUE(reach[0] && reach[1]);
    for (int h = 0; h < hand_count; ++h) {
        const WorkspaceBox& box = *reach[static_cast<std::size_t>(h)];
        EXPECT_TRUE(is_usable(box));
        EXPECT_TRUE((box.least.array() <= 0).all() && (box.most.array() >= 0).all())
            << "where the instrument begins is part of it";
        const InstrumentSpec& spec = *scene.instrument(static_cast<Hand>(h));
        const Trocar trocar = make_trocar(spec.trocar);
        const Vector3 start = start_reading(trocar.shaft_length, spec.start_insertion, 0).handle;
        WorkspaceBox of_targets;
        int targets = 0;
        for (const TargetSphere& target : engine.initial_snapshot().targets) {
            if (target.hand != static_cast<Hand>(h)) continue;
            // To the right of the person is -x of the trocar's frame, towards the person -z.
            const Vector3 way = handle_for_tip(trocar, target.centre) - start;
            of_targets.add(Vector3(-way.x(), way.y(), -way.z()));
            ++targets;
        }
        EXPECT_EQ(targets, 10);
        EXPECT_TRUE(box.least.isApprox(of_targets.least) && box.most.isApprox(of_targets.most));
    }
}

TEST(SceneReach, EveryTaskWithInstrumentsNeedsSomeRoomAndNoMoreThanArmsReach) {
    for (const char* name : {"A1", "A3", "B2", "B3", "C4"}) {
        const TaskDefinition task =
            load_task(test::source_path("assets/tasks/" + std::string(name) + ".json"));
        const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
        const SceneReach reach = scene_reach(AttemptEngine(scene, task, 1));
        for (int h = 0; h < hand_count; ++h) {
            const bool holds = scene.instrument(static_cast<Hand>(h)) != nullptr;
            const auto& box = reach[static_cast<std::size_t>(h)];
            EXPECT_EQ(box.has_value(), holds) << name << h;
            if (!box) continue;
            EXPECT_GT(box->size().minCoeff(), 0.005) << name << h;
            EXPECT_LT(box->size().maxCoeff(), 0.6) << name << h;
        }
    }
}

}  // namespace
}  // namespace fulcrum
