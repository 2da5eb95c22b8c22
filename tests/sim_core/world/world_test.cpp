// SPDX-License-Identifier: Apache-2.0
// The world: it contains exactly what the scene lists; the bowel comes to rest and its weight is supported;
// steps repeat bit for bit and do not allocate.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <mutex>
#include <thread>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"
#include "tests/support/wait_count.h"

namespace fulcrum {
namespace {

Scene scene(const std::string& name) {
    return load_scene(test::source_path("assets/scenes/" + name + ".json"));
}

/// Hands at rest at their start poses.
RigSample standing(const Scene& scene, std::uint32_t tick) {
    RigSample input;
    input.tick = tick;
    for (const InstrumentSpec& spec : scene.instruments) {
        input.hand[static_cast<int>(spec.hand)] = start_sample(spec.trocar, spec.start_insertion);
        input.hand[static_cast<int>(spec.hand)].jaw = 1000000;
    }
    if (scene.camera) input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
    return input;
}

struct Hands {
    Scene scene;
    World world;
    HapticLoop loop;
    std::vector<TickOutput> outputs;
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;
    StepRecord last;

    explicit Hands(Scene chosen)
        : scene(std::move(chosen)), world(scene, 1), loop(scene, world), outputs(5) {}
    explicit Hands(const std::string& name) : Hands(fulcrum::scene(name)) {}
    template <typename Change>
    void step(Change&& change) {
        for (int i = 0; i < 5; ++i) {
            RigSample input = standing(scene, ++tick);
            change(input);
            outputs[static_cast<std::size_t>(i)] = loop.tick(input);
        }
        last = world.step(outputs.data(), outputs.size());
        hash = hash * 31 + last.state_hash;
        loop.adopt(world.local_models());
    }
    void step() {
        step([](RigSample&) {});
    }
};

TEST(World, TargetSceneHasNoTissueInMemory) {
    Hands run("a2_targets");
    EXPECT_EQ(run.world.find<BowelPart>(), nullptr);
    EXPECT_EQ(run.world.wall(), nullptr);
    EXPECT_TRUE(run.world.snapshot().bowel.rings.empty());
    EXPECT_TRUE(run.world.snapshot().bowel.nodes.empty());
    EXPECT_TRUE(run.world.snapshot().membranes.empty());
    for (const PartCost& part : run.world.costs()) {
        EXPECT_NE(part.part, "rod");
        EXPECT_NE(part.part, "cage_and_surface");
        EXPECT_NE(part.part, "collision");
        EXPECT_NE(part.part, "membranes");
    }
    EXPECT_EQ(run.world.snapshot().targets.size(), 20U);
}

TEST(World, BowelComesToRestAndIsSupported) {
    Hands run("b1_bowel");
    const BowelPart& bowel = *run.world.find<BowelPart>();
    double fastest = 0;
    for (int i = 0; i < 200; ++i) run.step();
    for (const Vector3& velocity : bowel.state().velocities) fastest = std::max(fastest, velocity.norm());
    EXPECT_LT(fastest, 2e-3);
    EXPECT_LT(run.world.snapshot().bowel.residual_penetration, 1e-3);
    EXPECT_GT(run.world.snapshot().bowel.floor_load, 0.3 * bowel.weight());
    EXPECT_EQ(run.last.outcome, 0U);
}

TEST(World, SceneSelectsExp2AndALayeredWall) {
    Scene stiffening = scene("b1_bowel");
    stiffening.fidelity.material = MaterialLaw::exp2;
    stiffening.bowel->layers = bowel_wall_layers();
    Hands run(stiffening);
    double fastest = 0;
    for (int i = 0; i < 100; ++i) run.step();
    for (const Vector3& velocity : run.world.find<BowelPart>()->state().velocities)
        fastest = std::max(fastest, velocity.norm());
    EXPECT_LT(fastest, 5e-3);
    EXPECT_LT(run.world.snapshot().bowel.residual_penetration, 1e-3);
    EXPECT_EQ(run.last.outcome, 0U);
}

TEST(World, StepsRepeatBitForBit) {
    std::uint64_t hashes[2];
    for (std::uint64_t& hash : hashes) {
        Hands run("b1_bowel");
        for (int i = 0; i < 60; ++i) {
            run.step([&](RigSample& input) {
                input.hand[0].handle[0] += 3000 * static_cast<std::int32_t>(input.tick);
                input.hand[1].handle[2] -= 2000 * static_cast<std::int32_t>(input.tick);
            });
        }
        hash = run.hash;
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_NE(hashes[0], 0U);
}

TEST(World, StepsAndTicksAllocateNothingAfterTheFirst) {
    for (const char* name : {"a2_targets", "b1_bowel", "b1_mesentery"}) {
        Hands run(name);
        for (int i = 0; i < 40; ++i) run.step();
        const std::uint64_t before = test::allocation_count();
        for (int i = 0; i < 100; ++i) {
            run.step([&](RigSample& input) { input.hand[0].handle[2] -= 4000 * (i < 60 ? i : 60); });
        }
        EXPECT_EQ(test::allocation_count() - before, 0U) << name;
    }
}

TEST(World, StepsAndTicksNeitherLockNorWaitNorDoInputOutput) {
    if constexpr (test::waits_are_counted) {
        // The counter must detect what it is meant to detect.
        const std::uint64_t nothing = test::wait_count();
        static std::mutex mutex;
        mutex.lock();
        mutex.unlock();
        EXPECT_EQ(test::wait_count() - nothing, 1U);
        std::this_thread::sleep_for(std::chrono::nanoseconds(1));
        EXPECT_EQ(test::wait_count() - nothing, 2U);
        std::ifstream readme(test::source_path("README.md"));
        EXPECT_GT(readme.get(), 0);
        EXPECT_GT(test::wait_count() - nothing, 2U);
    }
    for (const char* name : {"a2_targets", "b1_bowel", "b1_mesentery"}) {
        Hands run(name);
        for (int i = 0; i < 40; ++i) run.step();
        const std::uint64_t before = test::wait_count();
        for (int i = 0; i < 100; ++i) {
            run.step([&](RigSample& input) {
                input.hand[0].handle[2] -= 4000 * (i < 60 ? i : 60);
                input.hand[0].jaw = i < 70 ? 1000000 : 0;  // and grasps what it reached
            });
        }
        EXPECT_EQ(test::wait_count() - before, 0U) << name;
    }
}

TEST(World, PausedStepDoesNotMoveTheBowel) {
    Hands run("b1_bowel");
    run.step();
    const std::vector<Vector3> before = run.world.find<BowelPart>()->state().nodes;
    for (int i = 0; i < 20; ++i) run.step([](RigSample& input) { input.flags |= rig_paused; });
    EXPECT_EQ(before, run.world.find<BowelPart>()->state().nodes);
}

TEST(World, NewWorldShowsTheInstrumentsAtTheirStartPose) {
    Hands run("b1_bowel");
    const Vector3 shown = run.world.snapshot().tools[0].tip;
    run.step();
    EXPECT_LT((run.world.snapshot().tools[0].tip - shown).norm(), 1e-6);
}

}  // namespace
}  // namespace fulcrum
