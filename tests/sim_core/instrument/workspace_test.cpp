// SPDX-License-Identifier: Apache-2.0
// What of a scene a device can reach.
#include "sim_core/instrument/workspace.h"

#include <gtest/gtest.h>

#include <limits>

namespace fulcrum {
namespace {

const WorkspaceBox desk{Vector3(-0.08, -0.06, -0.035), Vector3(0.08, 0.06, 0.035)};

TEST(Workspace, TheScaleThatFitsIsThatOfTheTightestAxisAndTheSceneThenIsReachedWhole) {
    const WorkspaceBox scene{Vector3(-0.10, -0.01, -0.02), Vector3(0.14, 0.03, 0.05)};
    const double scale = scale_to_fit(desk, scene);
    EXPECT_DOUBLE_EQ(scale, 0.24 / 0.16);
    const Vector3 begin = place_to_begin(desk, scene, scale);
    EXPECT_NEAR(reached_share(desk, scene, scale, begin), 1, 1e-12);
    EXPECT_TRUE(needed(scene, scale, begin).centre().isApprox(desk.centre() + Vector3::Zero(), 1e-12) ||
                needed(scene, scale, begin).centre().norm() < 1e-12);
    EXPECT_LT(reached_share(desk, scene, 0.99 * scale, place_to_begin(desk, scene, 0.99 * scale)), 1);
    EXPECT_LT(reached_share(desk, scene, scale, begin + Vector3(0.01, 0, 0)), 1)
        << "begun elsewhere a part of it is out of reach";
}

TEST(Workspace, TheShareIsThatOfTheVolumeAndAFlatSceneCountsAsThin) {
    WorkspaceBox scene{Vector3(0, -0.01, -0.01), Vector3(0.16, 0.01, 0.01)};
    EXPECT_NEAR(reached_share(desk, scene, 1, Vector3::Zero()), 0.5, 1e-12) << "half of it is to the right";
    EXPECT_EQ(reached_share(desk, scene, 1, Vector3(0.5, 0, 0)), 0);
    scene.least.y() = scene.most.y() = 0;
    EXPECT_NEAR(reached_share(desk, scene, 1, Vector3::Zero()), 0.5, 1e-12);
    EXPECT_EQ(reached_share(desk, scene, 1, Vector3(0, 0.07, 0)), 0);
}

TEST(Workspace, OneThatIsNotPossibleIsNotUsed) {
    EXPECT_TRUE(is_usable(desk));
    EXPECT_FALSE(is_usable(WorkspaceBox{}));
    EXPECT_FALSE(is_usable(WorkspaceBox{desk.most, desk.least}));
    WorkspaceBox far = desk;
    far.most.x() = 5;
    EXPECT_FALSE(is_usable(far));
    far.most.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_usable(far));
}

}  // namespace
}  // namespace fulcrum
