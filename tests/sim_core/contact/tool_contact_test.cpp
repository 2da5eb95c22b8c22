// SPDX-License-Identifier: Apache-2.0
// The tick's contact compared with closed forms and FCL, and the rules of the haptic thread.
#include "sim_core/contact/tool_contact.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/haptics/stability.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/contact/contact_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

std::size_t index(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

TEST(ToolContact, TipOnATubeMatchesTheClosedForm) {
    test::ContactRig rig;
    Random random(8);
    for (int trial = 0; trial < 200; ++trial) {
        // From the trocar the tip stays on the near side: |y| is small compared with the distance.
        const Vector3 tip(0.2 + random.uniform(-0.05, 0.05), random.uniform(-0.01, 0.01),
                          random.uniform(0.006, 0.022));
        const double centre_distance = std::sqrt(tip.y() * tip.y() + tip.z() * tip.z());
        rig.state = ToolContactState{};
        rig.result = ToolContactResult{};
        const ToolKinematics tool = rig.tool_at(tip);
        rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        if (result.shaft < 1) continue;  // the shaft touches the tube behind the tip
        EXPECT_NEAR(result.distance, centre_distance - 0.016 - 0.0025, 6e-5) << tip.transpose();
        EXPECT_NEAR(result.normal.dot(Vector3(0, tip.y(), tip.z()) / centre_distance), 1.0, 2e-3);
        EXPECT_EQ(result.touching_surface, result.distance < 0);
        if (!result.touching_surface) {
            EXPECT_EQ(result.force, Vector3::Zero());
            EXPECT_EQ(result.filtered.count, 0);
            continue;
        }
        const double stiffness = (result.normal.transpose() * result.stiffness * result.normal).value();
        EXPECT_NEAR((result.force + stiffness * -result.distance * result.normal).norm(), 0, 1e-9);
        EXPECT_GE(stiffness, rig.local->patch.contact.least_stiffness);
        EXPECT_LE(stiffness, rig.local->patch.contact.most_stiffness + 1e-9);
        double sum = 0;
        for (std::int32_t i = 0; i < result.filtered.count; ++i) {
            sum += result.filtered.weight[index(i)];
            const Vector3& rest = rig.skin.rest().vertices[index(result.filtered.vertex[index(i)])];
            EXPECT_LT((rest - result.point).norm(), 0.012);
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
        EXPECT_EQ(result.filtered.vertex[0], result.vertex);
        EXPECT_GE(result.tissue_patch, 0);
    }
}

TEST(ToolContact, ShaftAcrossATubeFindsItsCrest) {
    test::ContactRig rig;
    // The tool is across the tube: the trocar on one side, the tip beyond the crest.
    InstrumentSpec spec;
    spec.trocar.position = Vector3(0.2, -0.12, 0.030);
    spec.trocar.direction = Vector3(0, 1, -0.1);
    rig.model.instrument = make_instrument(spec, 1e-3);
    for (const double lift : {0.004, 0.001, -0.002, -0.004}) {
        rig.state = ToolContactState{};
        rig.result = ToolContactResult{};
        // A line through the trocar at the wanted distance from the centre line.
        const double wanted = 0.016 + 0.0025 + lift;
        const Vector3 trocar = spec.trocar.position;
        const double to_centre = std::sqrt(trocar.y() * trocar.y() + trocar.z() * trocar.z());
        const double down = std::atan2(-trocar.z(), -trocar.y()) + std::asin(wanted / to_centre);
        const Vector3 tip = trocar + 0.17 * Vector3(0, std::cos(down), std::sin(down));
        const ToolKinematics tool = rig.tool_at(tip);
        rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        for (int tick = 0; tick < 3; ++tick) rig.touch(tool);
        EXPECT_LT(result.shaft, 0.95);
        EXPECT_NEAR(result.distance, lift, 8e-5);
        EXPECT_NEAR(result.normal.dot(tool.axis), 0.0, 0.02);
        EXPECT_EQ(result.touching_surface, lift < 0);
    }
}

TEST(ToolContact, AgreesWithFclOutsideTheSurface) {
    test::ContactRig rig(test::Tube::haustral);
    const std::vector<RingFrame> bent = test::bent_frames(rig.skin.cage(), 0.15);
    for (std::size_t r = 0; r < bent.size(); ++r) rig.rings[r].frame = bent[r];
    std::vector<Vector3> all(index(rig.skin.vertices()));
    skin_all(rig.skin, bent.data(), all.data());
    const auto tree = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : rig.skin.rest().triangles)
        triangles.emplace_back(index(t[0]), index(t[1]), index(t[2]));
    tree->beginModel();
    tree->addSubModel(all, triangles);
    tree->endModel();
    fcl::CollisionObject<double> bowel(tree);
    Random random(12);
    double worst = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const RingFrame& ring = bent[10 + random.below(28)];
        const Vector3 tip = ring.position + random.uniform(-0.004, 0.004) * ring.rotation.col(0) +
                            random.uniform(0.0215, 0.028) * ring.rotation.col(1);
        const ToolKinematics tool = rig.tool_at(tip);
        rig.state = ToolContactState{};
        rig.result = ToolContactResult{};
        rig.publish(tool);
        const double distance = rig.touch(tool).distance;
        const double length = (tool.tip - tool.trocar).norm();
        fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
        pose.linear() = tool.rotation;
        pose.translation() = 0.5 * (tool.tip + tool.trocar);
        fcl::CollisionObject<double> capsule(std::make_shared<fcl::Capsule<double>>(0.0025, length), pose);
        fcl::DistanceRequest<double> request;
        fcl::DistanceResult<double> found;
        fcl::distance(&bowel, &capsule, request, found);
        worst = std::max(worst, std::abs(distance - found.min_distance));
    }
    // The smooth normal's foot is not exactly the nearest point, and FCL's own iteration stops at 1e-6.
    EXPECT_LT(worst, 2.5e-4);
}

TEST(ToolContact, SlidingAlongIsSmoothAcrossFacetsAndModels) {
    test::ContactRig rig(test::Tube::haustral);
    rig.model.instrument.tip_box = Vector3(0.02, 0.005, 0.005);
    Vector3 last_force = Vector3::Zero(), last_point = Vector3::Zero();
    double largest_step = 0, largest_force = 0;
    int searches = 0, lost = 0;
    for (int k = 0; k < 2000; ++k) {
        // 50 mm/s along the tube and across it, 3 mm deep.
        const double t = k * 1e-3;
        const double angle = 0.35 * std::sin(3 * t);
        const double depth = 0.003;
        const Vector3 tip(0.15 + 0.05 * t, (0.0185 - depth) * std::sin(angle),
                          (0.0185 - depth) * std::cos(angle));
        const ToolKinematics tool = rig.tool_at(tip);
        rig.tick = static_cast<std::uint32_t>(k);
        if (k % 5 == 0) rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        ASSERT_TRUE(result.touching_surface) << k;
        searches += result.searched ? 1 : 0;
        lost += result.lost ? 1 : 0;
        largest_force = std::max(largest_force, result.force.norm());
        if (k > 0) {
            largest_step = std::max(largest_step, (result.force - last_force).norm());
            EXPECT_LT((result.point - last_point).norm(), 1e-3) << k;
        }
        last_force = result.force;
        last_point = result.point;
    }
    EXPECT_GT(largest_force, 0.5);
    EXPECT_LT(largest_step, 0.05 * largest_force);
    EXPECT_EQ(lost, 0);
    EXPECT_LT(searches, 20);
}

TEST(ToolContact, OlderModelIsExtrapolatedByTheRingVelocity) {
    test::ContactRig rig;
    const Vector3 velocity(0.01, 0.0, 0.03);
    for (RingMotion& ring : rig.rings) ring.velocity = velocity;
    const ToolKinematics tool = rig.tool_at({0.2, 0, 0.0175});
    rig.publish(tool);
    const double fresh = rig.touch(tool).distance;
    rig.tick += 8;
    EXPECT_NEAR(rig.touch(tool).distance, fresh - 8e-3 * 0.03, 1e-5);
    EXPECT_EQ(rig.result.age, 8U);
    // Extrapolated for at most 20 ms: a stalled world must not make the tissue drift.
    rig.tick += 500;
    EXPECT_NEAR(rig.touch(tool).distance, fresh - 20e-3 * 0.03, 1e-5);
}

TEST(ToolContact, DampingOpposesTheApproachAndNeverAttracts) {
    test::ContactRig rig;
    const ToolKinematics still = rig.tool_at({0.2, 0, 0.0155});
    rig.publish(still);
    const double static_force = -rig.touch(still).force.z() * -1;
    rig.state.stiffness = 0;
    rig.state.touching = false;
    const double in = rig.touch(rig.tool_at({0.2, 0, 0.0155}, {0, 0, -0.1})).force.norm();
    const double out = rig.touch(rig.tool_at({0.2, 0, 0.0155}, {0, 0, 0.1})).force.norm();
    EXPECT_NEAR(in - out, 2 * 0.4 * 0.1, 0.02);
    EXPECT_LT(static_force, 0);  // the tissue is pushed down
    const ToolContactResult& away = rig.touch(rig.tool_at({0.2, 0, 0.0155}, {0, 0, 50.0}));
    EXPECT_EQ(away.force.norm(), 0.0);
    // Sliding drags, within the friction of the normal force.
    const ToolContactResult& sliding = rig.touch(rig.tool_at({0.2, 0, 0.0155}, {5.0, 0, 0}));
    EXPECT_GT(sliding.force.x(), 0);
    EXPECT_LE(sliding.force.x(), 0.1 * std::abs(sliding.force.z()) + 1e-9);
}

TEST(ToolContact, HandReceivesNoMoreEnergyThanItPutIn) {
    test::ContactRig rig;
    rig.model.instrument.tick_period = 1e-3;
    PassivityObserver observer;
    Vector3 last_tip(0.2, 0, 0.03);
    for (int k = 0; k < 4000; ++k) {
        const double phase = 2 * 3.14159265 * k / 1000.0;
        const Vector3 tip(0.2 + 0.01 * std::sin(0.5 * phase), 0.003 * std::sin(1.5 * phase),
                          0.0185 - 0.004 * (0.5 - 0.5 * std::cos(phase)) + 0.0005);
        const Vector3 velocity = k == 0 ? Vector3(Vector3::Zero()) : Vector3((tip - last_tip) / 1e-3);
        const ToolKinematics tool = rig.tool_at(tip, velocity);
        rig.tick = static_cast<std::uint32_t>(k);
        if (k % 5 == 0) rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        observer.step(-result.force, velocity, 1e-3);
        last_tip = tip;
    }
    EXPECT_LT(observer.highest, 1e-6);  // J
    EXPECT_LT(observer.given, 0);
}

TEST(ToolContact, ContactIsFoundAgainAfterAJump) {
    test::ContactRig rig;
    const ToolKinematics here = rig.tool_at({0.12, 0, 0.0165}), there = rig.tool_at({0.28, 0, 0.0165});
    rig.publish(here);
    EXPECT_TRUE(rig.touch(here).touching_surface);
    // 160 mm away with the old model: outside the patch, no force, no fault.
    rig.touch(there);
    EXPECT_FALSE(rig.result.touching_surface);
    EXPECT_TRUE(rig.result.force.allFinite());
    rig.publish(there);
    EXPECT_TRUE(rig.touch(there).touching_surface);
    EXPECT_NEAR(rig.result.distance, -0.002, 1e-4);
    rig.publish(here);
    EXPECT_TRUE(rig.touch(here).touching_surface);
}

TEST(ToolContact, TopologyChangeInvalidatesTheTriangle) {
    test::ContactRig rig;
    const ToolKinematics tool = rig.tool_at({0.2, 0, 0.0165});
    rig.publish(tool);
    rig.touch(tool);
    rig.local->topology_version += 1;
    rig.state.barycentric = Vector3(5, -7, 3);  // would be nonsense on another triangle
    EXPECT_NEAR(rig.touch(tool).distance, -0.002, 1e-4);
    EXPECT_EQ(rig.state.topology_version, rig.local->topology_version);
}

TEST(ToolContact, FullSearchAgreesWithTheDynamicPoint) {
    test::ContactRig walking(test::Tube::haustral), searching(test::Tube::haustral);
    searching.model.search_always = true;
    for (int k = 0; k < 300; ++k) {
        const Vector3 tip(0.15 + 0.0002 * k, 0.004 * std::sin(0.05 * k), 0.0175);
        const ToolKinematics tool = walking.tool_at(tip);
        walking.publish(tool);
        searching.publish(tool);
        const double walked = walking.touch(tool).distance, searched = searching.touch(tool).distance;
        EXPECT_NEAR(walked, searched, 5e-5) << k;
        EXPECT_TRUE(searching.result.searched);
    }
}

TEST(ToolContact, PredictedForceMatchesTheOldModelToFirstOrder) {
    test::ContactRig rig;
    rig.publish(rig.tool_at({0.2, 0, 0.0165}));
    rig.touch(rig.tool_at({0.2, 0, 0.0165}));
    const ToolContactResult before = rig.result;
    const Vector3 motion(0, 0, -0.0002);
    const Vector3 exact = rig.touch(rig.tool_at(Vector3(0.2, 0, 0.0165) + motion)).force;
    EXPECT_NEAR((predict_force(before, motion) - exact).norm(), 0, 0.03 * exact.norm());
    EXPECT_EQ(predict_force(before, Vector3(0, 0, 0.01)), Vector3::Zero());
}

TEST(ToolContact, OutputIsAlwaysFinite) {
    test::ContactRig rig;
    const ToolKinematics good = rig.tool_at({0.2, 0, 0.0165});
    rig.publish(good);
    rig.touch(good);
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinite, -infinite, 1e300}) {
        ToolKinematics tool = good;
        tool.tip.x() = bad;
        EXPECT_TRUE(rig.touch(tool).force.allFinite());
        tool = good;
        tool.tip_velocity.y() = bad;
        EXPECT_TRUE(rig.touch(tool).force.allFinite());
        LocalModel broken = *rig.local;
        broken.patch.rings[6].frame.position.z() = bad;
        ToolContactState state;
        step_tool_contact(rig.model, broken, good, rig.tick, state, *rig.tick_scratch, rig.result);
        EXPECT_TRUE(rig.result.force.allFinite());
        EXPECT_TRUE(rig.result.stiffness.allFinite());
    }
    // A collapsed patch: all vertices at one point.
    LocalModel collapsed = *rig.local;
    for (SkinRow& row : collapsed.patch.rows) {
        for (Vector3& offset : row.offset) offset.setZero();
    }
    for (RingMotion& ring : collapsed.patch.rings) ring.frame.position = good.tip;
    ToolContactState state;
    step_tool_contact(rig.model, collapsed, good, rig.tick, state, *rig.tick_scratch, rig.result);
    EXPECT_TRUE(rig.result.force.allFinite());
    EXPECT_TRUE(rig.touch(good).touching_surface);
}

TEST(ToolContact, RandomJumpsKeepTheForceFinite) {
    test::ContactRig rig(test::Tube::haustral);
    Random random(21);
    for (int k = 0; k < 3000; ++k) {
        rig.tick = static_cast<std::uint32_t>(k);
        const Vector3 tip(random.uniform(-1, 1.4), random.uniform(-1, 1), random.uniform(-1, 0.19));
        const bool near = random.below(2) == 0;
        const ToolKinematics tool = rig.tool_at(
            near ? Vector3(random.uniform(0, 0.4), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.03))
                 : tip,
            Vector3(random.normal(0, 10), random.normal(0, 10), random.normal(0, 10)));
        if (random.below(5) == 0) rig.publish(tool);
        const ToolContactResult& result = rig.touch(tool);
        ASSERT_TRUE(result.force.allFinite()) << k;
        ASSERT_LT(result.force.norm(), 800 * 0.4 + 60) << k;
        ASSERT_TRUE(result.stiffness.allFinite());
    }
}

TEST(ToolContact, TickDoesNotAllocate) {
    test::ContactRig rig(test::Tube::haustral);
    std::vector<ToolKinematics> tools;
    for (int k = 0; k < 200; ++k) tools.push_back(rig.tool_at({0.15 + 0.0003 * k, 0, 0.0165}));
    rig.publish(tools[0]);
    EXPECT_EQ(test::allocations_in([&] {
                  for (const ToolKinematics& tool : tools) rig.touch(tool);
              }),
              0U);
}

TEST(ContactCoupling, RelaxedForceConvergesWhereUnrelaxedForceDiverges) {
    // Tissue of compliance 1/c yields to a tool held still: force k (d - F / c). Fixed point d k c / (k + c).
    const double k = 600, c = 200, depth = 0.004;
    double plain = 0;
    Vector3 relaxed = Vector3::Zero();
    for (int step = 0; step < 12; ++step) {
        plain = std::max(0.0, k * (depth - plain / c));
        relaxed = relax_contact_force(relaxed, Vector3(k * (depth - relaxed.x() / c), 0, 0), k, c);
    }
    const double balance = depth * k * c / (k + c);
    EXPECT_NEAR(relaxed.x(), balance, 1e-9);
    EXPECT_GT(std::abs(plain - balance), 0.3 * balance);
}

}  // namespace
}  // namespace fulcrum
