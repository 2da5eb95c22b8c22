// SPDX-License-Identifier: Apache-2.0
// The patch compared with the whole surface.
#include "sim_core/contact/patch_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/sim_core/contact/contact_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

std::size_t index(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

TEST(PatchBuilder, VerticesAndAdjacencyMatchTheSurface) {
    test::ContactRig rig(test::Tube::haustral);
    const std::vector<RingFrame> bent = test::bent_frames(rig.skin.cage(), 0.12);
    for (std::size_t r = 0; r < bent.size(); ++r) rig.rings[r].frame = bent[r];
    std::vector<Vector3> all(index(rig.skin.vertices()));
    skin_all(rig.skin, bent.data(), all.data());
    const Vector3 above = bent[24].position + 0.02 * bent[24].rotation.col(1);
    rig.publish(rig.tool_at(above));
    const SurfacePatch& patch = rig.local->patch;
    ASSERT_EQ(rig.local->mode, LocalMode::surface);
    ASSERT_GT(patch.vertex_count, 100);
    EXPECT_FALSE(patch.overflow);
    PatchSurface surface(patch, 0.0, *rig.tick_scratch);
    std::set<std::int32_t> inside;
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        const std::int32_t id = patch.vertex_id[index(v)];
        inside.insert(id);
        EXPECT_NEAR((surface.position(v) - all[index(id)]).norm(), 0, 1e-12);
        if (v > 0) {
            EXPECT_LT(patch.vertex_id[index(v - 1)], id);
        }
    }
    const SurfaceView view = surface.view();
    const auto& triangles = rig.skin.rest().triangles;
    for (std::int32_t t = 0; t < patch.triangle_count; ++t) {
        const Triangle& whole = triangles[index(patch.triangle_id[index(t)])];
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(patch.vertex_id[index(patch.triangles[index(t)][k])], whole[k]);
            const std::int32_t other = view.neighbour(t, static_cast<int>(k));
            const std::int32_t expected =
                rig.skin.adjacency().triangle_neighbours[3 * index(patch.triangle_id[index(t)]) + k];
            EXPECT_EQ(other < 0 ? -1 : patch.triangle_id[index(other)],
                      patch.find_triangle(expected) < 0 ? -1 : expected);
        }
        EXPECT_EQ(patch.find_triangle(patch.triangle_id[index(t)]), t);
    }
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        const std::int32_t id = patch.vertex_id[index(v)];
        std::vector<std::int32_t> expected;
        bool whole = true;
        for (const std::int32_t t : rig.skin.adjacency().triangles_of(id)) {
            const bool present = std::all_of(triangles[index(t)].begin(), triangles[index(t)].end(),
                                             [&](std::int32_t corner) { return inside.count(corner) == 1; });
            whole = whole && present;
            if (present) expected.push_back(t);
        }
        std::vector<std::int32_t> found;
        for (const std::int32_t t : view.triangles_of(v)) found.push_back(patch.triangle_id[index(t)]);
        EXPECT_EQ(found, expected);
        EXPECT_EQ(patch.border[index(v)] == 0, whole);
        expected.clear();
        for (const std::int32_t other : rig.skin.adjacency().neighbours_of(id)) {
            if (inside.count(other) == 1) expected.push_back(other);
        }
        found.clear();
        for (const std::int32_t other : view.neighbours_of(v)) found.push_back(patch.vertex_id[index(other)]);
        EXPECT_EQ(found, expected);
    }
}

TEST(PatchBuilder, ContainsAllVerticesNearTheContactAndSeedIsNearest) {
    test::ContactRig rig;
    std::vector<Vector3> all(index(rig.skin.vertices()));
    skin_all(rig.skin, test::rest_frames(rig.skin.cage()).data(), all.data());
    for (const Vector3& tip : {Vector3(0.2, 0.0, 0.02), Vector3(0.1, 0.012, 0.014), Vector3(0.3, -0.02, 0.0),
                               Vector3(0.004, 0, 0.018)}) {
        rig.result = ToolContactResult{};
        const ToolKinematics tool = rig.tool_at(tip);
        rig.publish(tool);
        const SurfacePatch& patch = rig.local->patch;
        ASSERT_EQ(rig.local->mode, LocalMode::surface);
        double nearest = 1;
        std::size_t centre = 0;
        for (std::size_t v = 0; v < all.size(); ++v) {
            const Vector3 shaft = tool.tip - tool.trocar;
            const double s = std::clamp((all[v] - tool.trocar).dot(shaft) / shaft.squaredNorm(), 0.0, 1.0);
            const double distance = (all[v] - tool.shaft_point(s)).norm();
            if (distance < nearest) {
                nearest = distance;
                centre = v;
            }
        }
        const auto id = static_cast<std::int32_t>(centre);
        ASSERT_GE(patch.find_vertex(id), 0) << tip.transpose();
        if (patch.border[index(patch.find_vertex(id))] == 0) {
            EXPECT_NEAR(patch.seed_distance, nearest, 1e-9);
        }
        if (patch.overflow) continue;
        for (std::size_t v = 0; v < all.size(); ++v) {
            if ((all[v] - all[centre]).norm() < rig.builder.options().radius - 1e-9) {
                EXPECT_GE(patch.find_vertex(static_cast<std::int32_t>(v)), 0);
            }
        }
    }
}

TEST(PatchBuilder, SmallCapacityKeepsTheNearestAndReportsOverflow) {
    PatchOptions options;
    options.radius = 0.05;
    test::ContactRig rig(test::Tube::plain, options);
    rig.publish(rig.tool_at({0.2, 0, 0.018}));
    const SurfacePatch& patch = rig.local->patch;
    EXPECT_TRUE(patch.overflow);
    EXPECT_EQ(patch.vertex_count, patch_vertex_capacity);
    EXPECT_NEAR(rig.touch(rig.tool_at({0.2, 0, 0.0175})).distance, -0.001,
                2e-4);  // 2.5 mm proxy, 1.5 mm above
}

TEST(PatchBuilder, ToolOutOfReachGetsNoPatch) {
    test::ContactRig rig;
    rig.publish(rig.tool_at({0.2, 0, 0.1}));
    EXPECT_EQ(rig.local->mode, LocalMode::none);
    EXPECT_EQ(rig.local->patch.triangle_count, 0);
    EXPECT_EQ(rig.touch(rig.tool_at({0.2, 0, 0.1})).force, Vector3::Zero());
    ToolKinematics outside = rig.tool_at({0.2, 0, 0.02});
    outside.inside = false;
    rig.publish(outside);
    EXPECT_EQ(rig.local->mode, LocalMode::none);
}

TEST(PatchBuilder, BuildingDoesNotAllocate) {
    test::ContactRig rig;
    std::vector<ToolKinematics> tools;
    for (int k = 0; k < 30; ++k) tools.push_back(rig.tool_at({0.1 + 0.007 * k, 0.01 * std::sin(k), 0.017}));
    EXPECT_EQ(test::allocations_in([&] {
                  for (const ToolKinematics& tool : tools) {
                      rig.publish(tool);
                      rig.touch(tool);
                  }
              }),
              0U);
    EXPECT_TRUE(rig.result.touching_surface);
}

TEST(TissuePatches, CoverTheSurfaceInSectors) {
    test::ContactRig rig;
    const auto& patches = rig.builder.tissue_patches();
    const int count = patch_count(rig.skin, 4, 4);
    std::set<std::int16_t> used(patches.begin(), patches.end());
    EXPECT_GE(*used.begin(), 0);
    EXPECT_LT(*used.rbegin(), count);
    EXPECT_GT(static_cast<int>(used.size()), count - 8);
}

}  // namespace
}  // namespace fulcrum
