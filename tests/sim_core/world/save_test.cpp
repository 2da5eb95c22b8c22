// SPDX-License-Identifier: Apache-2.0
// A world saved during an attempt continues bit for bit, for every scene.
#include <gtest/gtest.h>

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

class WorldSave : public testing::TestWithParam<const char*> {};

TEST_P(WorldSave, ContinuesBitForBitInTheSameAndInANewWorld) {
    test::SheetRig rig(load_scene(test::source_path(std::string("assets/scenes/") + GetParam() + ".json")));
    const WorldSnapshot& first = rig.world.snapshot();
    const Vector3 place = !first.bowel.nodes.empty() ? first.bowel.nodes[first.bowel.nodes.size() / 3]
                          : rig.scene.sheet          ? rig.scene.sheet->centre
                          : rig.scene.bands
                              ? Vector3(rig.scene.bands->centre + Vector3(0, 0, rig.scene.bands->height))
                          : rig.scene.objects ? first.objects.objects[0].position
                                              : Vector3(Vector3::Zero());
    // Both tips into the tissue, the left jaws closed on it, the right one moved along with its button
    // pressed.
    rig.go(0, rig.tip_for(place + Vector3(0.012, 0, 0)), 0.3);
    rig.go(1, place + Vector3(-0.012, 0, 0.001), 0.3);
    rig.wish[0].closed = rig.wish[1].button = true;
    rig.steps(20);
    rig.go(0, rig.wish[0].tip + Vector3(0, 0, 0.004), 0.05);
    rig.go(1, rig.wish[1].tip + Vector3(0.002, 0.004, -0.006), 0.05);
    const std::shared_ptr<const World::Saved> saved = rig.world.save();
    ASSERT_NE(saved, nullptr);
    const std::uint64_t at_save = hash_of(rig.world);
    std::vector<std::vector<TickOutput>> outputs;
    std::vector<std::uint64_t> hashes, recorded;
    for (int i = 0; i < 80; ++i) {
        rig.wish[0].tip += Vector3(0, 1e-4, 1e-4);
        rig.wish[1].tip += Vector3(1.5e-4, 0, i < 40 ? -1e-4 : 1e-4);
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

INSTANTIATE_TEST_SUITE_P(Scenes, WorldSave,
                         testing::Values("b1_bowel", "b1_mesentery", "bowel_enterotomy", "b2_plane",
                                         "b3_bands", "c4_posterior", "a3_rings"),
                         [](const testing::TestParamInfo<const char*>& scene) {
                             return std::string(scene.param);
                         });

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
