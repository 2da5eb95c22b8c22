// SPDX-License-Identifier: Apache-2.0
// Copying a snapshot takes what is used of its room, and no more.
#include "sim_core/world/part/snapshot.h"

#include <gtest/gtest.h>

#include "sim_core/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

TEST(UsedVector, AssignmentCopiesOnlyWhatIsUsed) {
    UsedVector<int> from, to;
    from.assign(100, 1);
    from.used = 10;
    to.assign(100, 2);
    to = from;
    EXPECT_EQ(to.used, 10U);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(to[i], i < 10 ? 1 : 2) << i;
    UsedVector<int> empty;
    empty = from;
    ASSERT_EQ(empty.size(), 100U) << "the same room";
    EXPECT_EQ(empty[9], 1);
}

// What a slot of the threads' exchange holds after a copy, in a scene whose room for cuts is large.
TEST(Snapshot, CopyHasEverythingThatIsUsedAndDoesNotAllocate) {
    const Scene scene = load_scene(test::source_path("assets/scenes/c4_posterior.json"));
    World world(scene, 1);
    const WorldSnapshot& from = world.snapshot();
    const SheetView& sheet = from.sheet;
    ASSERT_GT(sheet.vertex_count, 0);
    ASSERT_GT(sheet.triangle_count, 0);
    WorldSnapshot slot = from;
    for (Vector3& place : slot.sheet.positions) place.setConstant(7);
    for (Triangle& triangle : slot.sheet.triangles) triangle = {7, 7, 7};
    EXPECT_EQ(test::allocations_in([&] { slot = from; }), 0U);
    std::size_t wrong = 0, beyond = 0;
    for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
        const bool used = v < static_cast<std::size_t>(sheet.vertex_count);
        if (used) wrong += slot.sheet.positions[v] == sheet.positions[v] ? 0 : 1;
        if (!used) beyond += slot.sheet.positions[v] == Vector3::Constant(7) ? 0 : 1;
    }
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const bool used = t < static_cast<std::size_t>(sheet.triangle_count);
        if (used) wrong += slot.sheet.triangles[t] == sheet.triangles[t] ? 0 : 1;
        if (!used) beyond += slot.sheet.triangles[t] == Triangle{7, 7, 7} ? 0 : 1;
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ(beyond, 0U) << "room that is not used was copied";
}

}  // namespace
}  // namespace fulcrum
