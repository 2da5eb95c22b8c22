// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for tool contact, generated: tools without thickness, tools moved by a
// metre in a tick, non-finite poses, rings at one point, stiffness of 1 N/m to 1 GN/m, old models. Every
// tick's result is finite, the surface never attracts, its force stays within what spring, damper and
// friction can give, and the same ticks give the same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>

#include "tests/sim_core/contact/contact_rig.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

struct Outcome {
    int touched = 0, lost = 0, grasped = 0, silenced = 0;
};

bool finite(const ToolContactResult& r) {
    return r.force.allFinite() && r.torque.allFinite() && r.surface_force.allFinite() &&
           r.grasp_force.allFinite() && r.target_force.allFinite() && r.wall_force.allFinite() &&
           r.point.allFinite() && r.normal.allFinite() && r.stiffness.allFinite() &&
           std::isfinite(r.damping + r.distance + r.shaft + r.area + r.slip_ratio + r.target_distance);
}

void extreme_instrument(Random& random, InstrumentModel& instrument) {
    if (random.below(3) != 0) return;
    instrument.shaft_radius = random.below(4) == 0 ? 0 : test::between(random, 1e-6, 0.05);
    instrument.tip_radius = random.below(4) == 0 ? 0 : test::between(random, 1e-6, 0.05);
    for (int k = 0; k < 3; ++k)
        instrument.tip_box[k] = random.below(4) == 0 ? 0 : test::between(random, 1e-6, 0.1);
    instrument.tick_period = test::between(random, 5e-5, 0.05);
}

TissueContact extreme_tissue(Random& random) {
    TissueContact tissue;
    if (random.below(3) == 0) return tissue;
    tissue.stiffness_per_area = test::between(random, 1, 1e15);
    tissue.least_stiffness = test::between(random, 1, 1e3);
    tissue.most_stiffness = tissue.least_stiffness * test::between(random, 1, 1e6);
    tissue.damping = random.below(4) == 0 ? 0 : test::between(random, 1e-6, 1e4);
    tissue.friction = random.below(4) == 0 ? 0 : test::between(random, 1e-3, 10);
    return tissue;
}

void throw_rings(Random& random, test::ContactRig& rig) {
    const auto kind = random.below(8);
    for (RingMotion& ring : rig.rings) {
        if (kind == 0) ring.frame.position = Vector3(0.2, 0, 0);  // all at one point
        if (kind == 1) ring.frame.position += 0.02 * test::inside_unit_box(random);
        if (kind == 2) ring.velocity = test::between(random, 1e-3, 1e2) * test::direction(random);
        if (kind == 3) ring.angular_velocity = test::between(random, 1e-3, 1e4) * test::direction(random);
        if (kind == 4) ring.frame.rotation *= 1e-9;  // a tube without a radius
    }
}

ToolKinematics extreme_tool(Random& random, const test::ContactRig& rig, const ToolKinematics& before) {
    const auto kind = random.below(10);
    ToolKinematics tool = before;
    if (kind == 0) {
        tool = rig.tool_at(Vector3(0.2, 0, 0) + test::inside_unit_box(random));  // a metre in a tick
        tool.tip_velocity = (tool.tip - before.tip) / rig.model.instrument.tick_period;
    } else if (kind == 1) {
        tool.tip[static_cast<int>(random.below(3))] = test::not_a_length(random);
    } else if (kind == 2) {
        tool.tip_velocity[static_cast<int>(random.below(3))] = test::not_a_length(random);
    } else if (kind == 3) {
        tool.tip = tool.trocar;  // no shaft
    } else {
        tool = rig.tool_at(Vector3(0.2, 0, 0.016) + 0.02 * test::inside_unit_box(random));
        tool.tip_velocity = test::between(random, 1e-3, 10) * test::direction(random);
    }
    if (random.below(6) == 0) tool.rotation = Matrix3::Zero();
    tool.grip = random.below(3) == 0 ? 0 : test::between(random, 1e-3, 1e3);
    return tool;
}

void add_others(Random& random, const ToolKinematics& tool, LocalModel& local) {
    local.target_count = static_cast<std::int32_t>(random.below(3));
    for (int i = 0; i < local.target_count; ++i) {
        TargetModel& target = local.targets[static_cast<std::size_t>(i)];
        target.centre = random.below(2) == 0 ? tool.tip : Vector3(Vector3(0.2, 0, 0.03));
        target.radius = random.below(3) == 0 ? 0 : test::between(random, 1e-6, 1);
        target.stiffness = test::between(random, 1, 1e9);
        target.id = i;
    }
    if (random.below(5) == 0) {
        local.mode = LocalMode::grasp;
        GraspModel& grasp = local.grasp;
        grasp = GraspModel{};
        grasp.point = Vector3(0.2, 0, 0.016) + test::between(random, 1e-6, 1) * test::direction(random);
        grasp.reaction = test::between(random, 1e-6, 1e3) * test::direction(random);
        grasp.stiffness = test::between(random, 1, 1e9) * Matrix3::Identity();
        grasp.damping = test::between(random, 1e-3, 1e4);
        grasp.friction = random.below(3) == 0 ? 0 : test::between(random, 1e-3, 10);
        grasp.vertex = static_cast<std::int32_t>(random.below(5000)) - 1;
        if (random.below(6) == 0) grasp.stiffness(0, 0) = test::not_a_length(random);
        if (random.below(6) == 0) grasp.point.x() = test::not_a_length(random);
    }
}

// Upper bound of the force from spring, damper and friction.
void check_surface_force(const TissueContact& tissue, const ToolKinematics& tool,
                         const ToolContactResult& result, double tissue_speed) {
    if (!result.touching_surface) {
        ASSERT_TRUE(result.surface_force.isZero());
        return;
    }
    const double pressing = -result.surface_force.dot(result.normal), size = result.surface_force.norm();
    ASSERT_GE(pressing, -1e-9 * size);
    const double across = (result.surface_force + pressing * result.normal).norm();
    ASSERT_LE(across, tissue.friction * pressing + 1e-9 * size);
    // The spring at the wall's largest K over the depth, the damper at the speeds of tool and tissue.
    const double depth = -result.distance, speed = 2 * tool.tip_velocity.norm() + tissue_speed;
    ASSERT_LE(pressing, (tissue.most_stiffness * depth + tissue.damping * speed) * (1 + 1e-9));
}

std::uint64_t run(std::uint64_t number, Outcome& outcome) {
    Random random(number, 34);
    PatchOptions options;
    options.contact = extreme_tissue(random);
    if (random.below(4) == 0) options.radius = test::between(random, 1e-4, 0.1);
    if (random.below(4) == 0) options.reach = test::between(random, 1e-4, 1);
    test::ContactRig rig(random.below(2) == 0 ? test::Tube::plain : test::Tube::haustral, options);
    extreme_instrument(random, rig.model.instrument);
    rig.model.filter.mode = static_cast<FilterMode>(random.below(4));
    rig.model.search_always = random.below(4) == 0;
    throw_rings(random, rig);
    ToolKinematics tool = rig.tool_at(Vector3(0.2, 0, 0.018));
    rig.publish(tool);
    std::uint64_t bits = 1469598103934665603ULL;
    for (int tick = 0; tick < 8; ++tick) {
        tool = extreme_tool(random, rig, tool);
        rig.tick += random.below(10) == 0 ? random.below(100000) : 1;  // an old model
        const ToolContactResult& result = rig.touch(tool);
        EXPECT_TRUE(finite(result)) << "case " << number << " tick " << tick;
        double fastest = 0;
        for (const RingMotion& ring : rig.rings)
            fastest = std::max(fastest, ring.velocity.norm() + 0.1 * ring.angular_velocity.norm());
        check_surface_force(options.contact, tool, result, 10 * fastest);
        if (testing::Test::HasFatalFailure()) return 0;
        const bool sane =
            tool.tip.norm() < 1e6 && tool.tip_velocity.norm() < 1e6;  // (NaN and infinity are not)
        if (!sane) {
            EXPECT_TRUE(result.force.isZero());
            ++outcome.silenced;
        }
        outcome.touched += result.touching_surface ? 1 : 0;
        outcome.grasped += result.grasping ? 1 : 0;
        outcome.lost += result.lost ? 1 : 0;
        for (int k = 0; k < 3; ++k) {
            std::uint64_t word = 0;
            const double value = result.force[k];
            std::memcpy(&word, &value, sizeof word);
            bits = (bits ^ word) * 1099511628211ULL;
        }
        if (random.below(3) == 0) {
            rig.publish(tool);
            add_others(random, tool, *rig.local);
            if (random.below(8) == 0) ++rig.local->topology_version;
        }
    }
    return bits;
}

TEST(ContactExtremes, TicksStayFiniteAndTheSurfaceNeverAttracts) {
    Outcome outcome, again;
    for (int i = 0; i < test::cases_asked() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(i);
        const std::uint64_t bits = run(static_cast<std::uint64_t>(i), outcome);
        if (i % 10 == 0) {
            EXPECT_EQ(bits, run(static_cast<std::uint64_t>(i), again));
        }
    }
    std::printf(
        "%d ticks touched, %d held, %d lost the surface and said so, %d without a pose gave no force\n",
        outcome.touched, outcome.grasped, outcome.lost, outcome.silenced);
    EXPECT_GT(outcome.touched, 1000);
    EXPECT_GT(outcome.grasped, 100);
    EXPECT_GT(outcome.lost, 0) << "the cases must include lost contacts";
    EXPECT_GT(outcome.silenced, 100);
}

}  // namespace
}  // namespace fulcrum
