// SPDX-License-Identifier: Apache-2.0
// The fidelity levels in a running world: a tool presses the bowel at each of them, and each level's
// characteristic effect is present. No allocation after warm-up.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

Scene small_scene() {
    Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
    scene.bowel->surface_vertices = 3000;
    return scene;
}

/// Observations during a second of pressing.
struct Press {
    std::set<int> grades;
    int touched = 0, dented_at_most = 0;
    double largest_force = 0, largest_by_jaws = 0, largest_felt_of_jaws = 0;
    double stiffest_jaws = 0;  ///< over the wall's own
    std::uint64_t allocated = 0, hash = 0;
    std::uint32_t worst_outcome = 0;
};

// The tip goes 12 mm into the middle of the bowel and slides along it.
Press press(const Scene& scene) {
    World world(scene, 1);
    HapticLoop loop(scene, world);
    std::vector<TickOutput> outputs(5);
    const InstrumentSpec& spec = scene.instruments[0];
    const int hand = static_cast<int>(spec.hand);
    loop.set_device(spec.hand, test::desk_device());
    const Trocar pivot = make_trocar(spec.trocar);
    const std::vector<Vector3>& nodes = world.find<BowelPart>()->state().nodes;
    const Vector3 centre = nodes[nodes.size() / 2],
                  along = (nodes[nodes.size() / 2 + 1] - centre).normalized();
    const Vector3 in = (centre - pivot.position).normalized();
    Press result;
    std::uint32_t tick = 0;
    std::uint64_t before = 0;
    for (int step = 0; step < 160; ++step) {
        if (step == 60) before = test::allocation_count();
        for (TickOutput& output : outputs) {
            RigSample input;
            input.tick = ++tick;
            for (const InstrumentSpec& other : scene.instruments)
                input.hand[static_cast<int>(other.hand)] = start_sample(other.trocar, other.start_insertion);
            const double t = tick * scene.tick_period();
            const double depth = std::min(0.04, 0.1 * t) - 0.044;
            const Vector3 tip = centre + depth * in + 0.01 * t * along;
            const Vector3 handle = handle_for_tip(pivot, tip) / device_length_unit;
            for (int k = 0; k < 3; ++k)
                input.hand[hand].handle[k] = static_cast<std::int32_t>(std::lround(handle[k]));
            if (scene.camera)
                input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
            output = loop.tick(input);
            const std::int32_t* counts = output.sample.hand[hand].force;
            const double force = sample_force_unit * Vector3(counts[0], counts[1], counts[2]).norm();
            if (output.contact[hand].vertex < 0 || !(force > 0)) continue;
            ++result.touched;
            result.grades.insert(output.sample.hand[hand].filter_grade);
            result.largest_force = std::max(result.largest_force, force);
        }
        const StepRecord record = world.step(outputs.data(), outputs.size());
        result.worst_outcome = std::max(result.worst_outcome, record.outcome);
        result.hash = result.hash * 31 + record.state_hash;
        result.dented_at_most =
            std::max(result.dented_at_most, static_cast<int>(world.snapshot().bowel.dent_count));
        result.largest_by_jaws =
            std::max(result.largest_by_jaws, world.find<BowelPart>()->jaw_force(spec.hand).norm());
        loop.adopt(world.local_models());
        const JawPushModel& felt = world.local_models().hand[hand].jaws;
        result.largest_felt_of_jaws = std::max(result.largest_felt_of_jaws, felt.force.norm());
        const double stiffness =
            scene.tissues[static_cast<std::size_t>(scene.tissue_index(scene.bowel->tissue))].stiffness;
        result.stiffest_jaws = std::max(result.stiffest_jaws, felt.stiffness.trace() / stiffness);
    }
    result.allocated = test::allocation_count() - before;
    return result;
}

void expect_sound(const Press& result, const std::string& level) {
    EXPECT_GT(result.touched, 100) << level;
    EXPECT_GT(result.largest_force, 0.02) << level;
    EXPECT_LT(result.largest_force, 30) << level;
    EXPECT_EQ(result.allocated, 0U) << level;
    EXPECT_LT(result.worst_outcome, 3U) << level;
}

TEST(Levels, FilterDistributesTheForceByItsLevel) {
    Scene scene = small_scene();
    int dented[3] = {0, 0, 0};
    std::set<std::uint64_t> hashes;
    for (const auto& [filter, level, title] : filter_levels) {
        scene.fidelity.filter = filter;
        const Press result = press(scene);
        expect_sound(result, level);
        const std::string name = level;
        if (name == "0" || name == "1" || name == "2") {
            const int grade = name[0] - '0';
            EXPECT_EQ(result.grades, std::set<int>{grade}) << level;
            dented[grade] = result.dented_at_most;
        }
        if (name == "off") {
            EXPECT_EQ(result.grades, std::set<int>{0});
        }
        hashes.insert(result.hash);
    }
    // A spike, a dent of one ring, a dent of two.
    EXPECT_LT(dented[0], dented[1]);
    EXPECT_LT(dented[1], dented[2]);
    EXPECT_GE(hashes.size(), 3U) << "off is grade 0, adaptive may be any";
}

TEST(Levels, QueryAndDynamicPointFindTheSameContact) {
    Scene scene = small_scene();
    scene.fidelity.tool_contact = ToolContactLevel::dynamic_point;
    const Press walked = press(scene);
    scene.fidelity.tool_contact = ToolContactLevel::query;
    const Press searched = press(scene);
    expect_sound(walked, "dynamic_point");
    expect_sound(searched, "query");
    // The walk finds what the search finds.
    EXPECT_NEAR(walked.touched, searched.touched, 0.05 * searched.touched);
    EXPECT_NEAR(walked.largest_force, searched.largest_force, 0.1 * searched.largest_force);
}

TEST(Levels, JawsAsBoxesPressTheBowelInAdditionToTheShaft) {
    Scene scene = small_scene();
    scene.fidelity.tool_contact = ToolContactLevel::dynamic_point;
    const Press shaft = press(scene);
    scene.fidelity.tool_contact = ToolContactLevel::jaws;
    const Press jaws = press(scene);
    expect_sound(jaws, "jaws");
    EXPECT_EQ(shaft.largest_by_jaws, 0);
    EXPECT_EQ(shaft.largest_felt_of_jaws, 0);
    // The force on the bowel equals the force to the hand, and is not stiffer than the wall.
    EXPECT_EQ(jaws.largest_felt_of_jaws, jaws.largest_by_jaws);
    EXPECT_GT(jaws.stiffest_jaws, 0.5);
    EXPECT_LE(jaws.stiffest_jaws, 1 + 1e-12);
    EXPECT_GT(jaws.largest_force, shaft.largest_force);
    EXPECT_GT(jaws.largest_by_jaws, 0.02);
    EXPECT_LT(jaws.largest_by_jaws, 30);
    EXPECT_NE(jaws.hash, shaft.hash);
}

TEST(Levels, FinerSkinningChangesTheSurfaceButNotTheContact) {
    Scene scene = small_scene();
    std::set<std::uint64_t> hashes;
    double force = 0;
    for (const auto& [scope, level, title] : skin_scopes) {
        scene.fidelity.skinning = scope;
        const Press result = press(scene);
        expect_sound(result, level);
        hashes.insert(result.hash);
        if (force > 0) {
            EXPECT_NEAR(result.largest_force, force, 0.25 * force) << level;
        }
        if (std::string(level) == "local") force = result.largest_force;
    }
    EXPECT_EQ(hashes.size(), 3U) << "each scope puts the vertices elsewhere";
}

}  // namespace
}  // namespace fulcrum
