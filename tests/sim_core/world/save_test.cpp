// SPDX-License-Identifier: Apache-2.0
// A world saved during an attempt continues bit for bit, for every scene that is delivered.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim_core/numerics/state_archive.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

// The whole list of a world's state, by what enters the hash, and its events.
std::uint64_t hash_of(const World& world) {
    StateHash hash;
    hash.add(world.hash());
    for (const Event& event : world.snapshot().events) hash.add(static_cast<double>(event.value));
    return hash.value();
}

/// Of assets/scenes: those of every task and variant, and the others.
std::vector<std::string> delivered_scenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/scenes")))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Both tips into the tissue, the left jaws closed on it, the right one moved along with its button pressed.
void press_into_tissue(test::SheetRig& rig) {
    const WorldSnapshot& first = rig.world.snapshot();
    const bool spheres = !first.targets.empty();
    const Vector3 place = !first.bowel.nodes.empty() ? first.bowel.nodes[first.bowel.nodes.size() / 3]
                          : rig.scene.sheet          ? rig.scene.sheet->centre
                          : rig.scene.bands
                              ? Vector3(rig.scene.bands->centre + Vector3(0, 0, rig.scene.bands->height))
                          : rig.scene.objects ? first.objects.objects[0].position
                          : spheres           ? first.targets[0].centre
                                              : Vector3(Vector3::Zero());
    const double aside = spheres ? first.targets[0].radius : 0.012;
    rig.go(0, rig.tip_for(place + Vector3(aside, 0, 0)), 0.3);
    rig.go(1, place + Vector3(-aside, 0, 0.001), 0.3);
    rig.wish[0].closed = rig.wish[1].button = true;
    rig.steps(20);
    rig.go(0, rig.wish[0].tip + Vector3(0, 0, 0.004), 0.05);
    rig.go(1, rig.wish[1].tip + Vector3(0.002, 0.004, -0.006), 0.05);
}

/// The lens to the rim of a cup.
void look_into_cup(test::SheetRig& rig) {
    const CameraTarget cup = rig.world.snapshot().camera_targets.targets[0];
    rig.lens = cup.eye;
    rig.steps(10);
    rig.lens = cup.mouth;
    rig.steps(10);
}

class WorldSave : public testing::TestWithParam<std::string> {};

TEST_P(WorldSave, ContinuesBitForBitInTheSameAndInANewWorld) {
    test::SheetRig rig(load_scene(test::source_path("assets/scenes/" + GetParam() + ".json")));
    if (rig.has(0) && rig.has(1)) {
        press_into_tissue(rig);
    } else {
        ASSERT_FALSE(rig.world.snapshot().camera_targets.targets.empty()) << "what is there to do?";
        look_into_cup(rig);
    }
    const std::shared_ptr<const World::Saved> saved = rig.world.save();
    ASSERT_NE(saved, nullptr);
    const std::uint64_t at_save = hash_of(rig.world);
    std::vector<std::vector<TickOutput>> outputs;
    std::vector<std::uint64_t> hashes, recorded;
    for (int i = 0; i < 40; ++i) {
        rig.wish[0].tip += Vector3(0, 1e-4, 1e-4);
        rig.wish[1].tip += Vector3(1.5e-4, 0, i < 20 ? -1e-4 : 1e-4);
        if (rig.lens) *rig.lens += Vector3(1e-4, 0, i < 20 ? 2e-4 : -2e-4);
        rig.step();
        outputs.push_back(rig.outputs);
        hashes.push_back(hash_of(rig.world));
        recorded.push_back(rig.record.state_hash);
    }
    EXPECT_NE(hashes.back(), at_save);
    World fresh(rig.scene, 1);
    for (World* world : {&rig.world, &fresh}) {
        world->restore(*saved);
        EXPECT_EQ(hash_of(*world), at_save);
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            const StepRecord record = world->step(outputs[i].data(), outputs[i].size());
            ASSERT_EQ(hash_of(*world), hashes[i])
                << (world == &fresh ? "new world, step " : "same world, step ") << i;
            ASSERT_EQ(record.state_hash, recorded[i]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, WorldSave, testing::ValuesIn(delivered_scenes()),
                         [](const testing::TestParamInfo<std::string>& scene) { return scene.param; });

// What is drawn first after a seek is the world as its key frame has it.
TEST(WorldBytes, ContainWhereInstrumentsAreDrawn) {
    test::SheetRig rig(load_scene(test::source_path("assets/scenes/a2_targets.json")));
    const TargetSphere& target = rig.world.snapshot().targets.front();
    const double apart = target.radius + rig.scene.instruments[1].tip_radius;
    const Vector3 out = (rig.trocar[1].position - target.centre).normalized();
    rig.go(1, target.centre + (apart + 0.02) * out, 0.3);
    rig.go(1, target.centre + (apart - 0.001) * out, 0.05);
    const Vector3 lift = rig.world.snapshot().lift[1];
    ASSERT_GT(lift.norm(), 5e-4) << "it is drawn at the sphere's surface";
    std::vector<std::uint8_t> bytes;
    StateArchive writer(bytes);
    rig.world.transfer(writer);
    writer.finish();
    World fresh(rig.scene, 1);
    StateArchive reader(bytes.data(), bytes.size());
    fresh.transfer(reader);
    reader.finish();
    EXPECT_EQ(fresh.snapshot().tools[1].tip, rig.world.snapshot().tools[1].tip);
    EXPECT_EQ(fresh.snapshot().lift[1], lift);
}

}  // namespace
}  // namespace fulcrum
