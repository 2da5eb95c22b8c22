// SPDX-License-Identifier: Apache-2.0
// A layered wall through the tick's contact: it stiffens, a nodule raises the force, and it is punctured at
// its limit.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim_core/contact/contact_rig.h"

namespace fulcrum {
namespace {

struct Pressed {
    double force, stiffness;
    bool punctured;
};

// The tip pressed straight down on the crest at x = 0.2.
Pressed press(test::ContactRig& rig, double depth) {
    rig.state = ToolContactState{};
    rig.result = ToolContactResult{};
    const ToolKinematics tool = rig.tool_at(Vector3(0.2, 0, 0.016 + 0.0025 - depth));
    rig.publish(tool);
    const ToolContactResult& result = rig.touch(tool);
    return {result.force.norm(), result.stiffness(2, 2), result.punctured};
}

TEST(LayeredContact, StiffensWithDepthLikeTheWall) {
    const LayeredWall wall{LayeredWallSpec{}};
    test::ContactRig rig;
    rig.builder.set_wall(&wall);
    double last = 0;
    for (const double depth : {0.0002, 0.0005, 0.001, 0.0015, 0.002}) {
        const Pressed here = press(rig, depth);
        const double exact = -rig.result.distance;
        const Indentation answer = wall.indent(exact, rig.result.area, 1e9);
        EXPECT_NEAR(here.force, answer.force, 1e-9 + 1e-6 * answer.force) << depth;
        EXPECT_GT(here.force / exact, last) << "the secant rises";
        EXPECT_NEAR(here.stiffness, std::max(answer.stiffness, answer.force / exact), 1e-3 * here.stiffness);
        last = here.force / exact;
    }
}

TEST(LayeredContact, StiffNoduleUnderSoftMucosaRaisesTheForce) {
    LayeredWallSpec spec;
    spec.nodule.height = 0.8 * spec.layers.front().thickness;
    spec.nodule.radius = 0.004;
    const LayeredWall wall(spec);
    test::ContactRig plain, lumpy;
    plain.builder.set_wall(&wall);
    std::vector<double> heights;
    for (const Vector3& vertex : lumpy.skin.rest().vertices) {
        // Under the crest at x = 0.2, where the tip goes: +z of the rest pose.
        const double around = 0.016 * std::atan2(vertex.y(), vertex.z());
        heights.push_back(wall.nodule_height(std::hypot(around, vertex.x() - 0.2)));
    }
    lumpy.builder.set_wall(&wall, heights);
    for (const double depth : {0.0005, 0.001, 0.0015}) {
        const double without = press(plain, depth).force, with = press(lumpy, depth).force;
        // The just noticeable difference of force is about 10 %.
        EXPECT_GT(with, 1.2 * without) << "at " << depth << " m: " << without << " N and " << with << " N";
        RecordProperty(("depth_um_" + std::to_string(std::lround(depth * 1e6))).c_str(),
                       std::to_string(without) + " N plain, " + std::to_string(with) + " N over the nodule");
    }
}

TEST(LayeredContact, PuncturesAtTheForceOfTheAttempt) {
    const LayeredWall wall{LayeredWallSpec{}};
    test::ContactRig rig;
    rig.builder.set_wall(&wall);
    rig.builder.set_puncture_force(0.5);
    EXPECT_FALSE(press(rig, 0.0001).punctured);
    const Pressed deep = press(rig, 0.004);
    EXPECT_TRUE(deep.punctured);
    EXPECT_LE(deep.force, 0.5 + 1e-9);
    EXPECT_TRUE(std::isfinite(deep.stiffness));
}

}  // namespace
}  // namespace fulcrum
