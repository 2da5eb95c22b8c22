// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/owned_bytes.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "sim_core/world/part/snapshot.h"

namespace fulcrum {
namespace {

TEST(OwnedBytes, AreTheRoomOfAllVectorsAtAnyDepth) {
    WorldSnapshot snapshot;
    EXPECT_EQ(owned_bytes(snapshot), 0U);
    snapshot.bowel.nodes.resize(7);
    snapshot.bowel.cut.triangles.resize(5);  // room counts, whether used or not
    snapshot.membranes.resize(2);
    snapshot.membranes[1].positions.resize(11);
    snapshot.step = 3;  // owns nothing
    EXPECT_EQ(owned_bytes(snapshot),
              7 * sizeof(Vector3) + 5 * sizeof(Triangle) + 2 * sizeof(MembraneView) + 11 * sizeof(Vector3));
}

}  // namespace
}  // namespace fulcrum
