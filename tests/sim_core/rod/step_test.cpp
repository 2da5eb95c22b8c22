// SPDX-License-Identifier: Apache-2.0
// The dynamic step under the conditions of scene B1.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstring>
#include <limits>

#include "sim_core/numerics/random.h"
#include "sim_core/rod/rod_system.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr double dt = 0.005;

// A bowel in a bow between two held ends over a floor, a mesentery above it.
struct Bowel {
    explicit Bowel(int segments = 64, RodEnd end = RodEnd::clamped) {
        RodSpec spec;
        spec.segments = segments;
        spec.length = 0.9;
        spec.ends[0] = spec.ends[1] = end;
        std::vector<Vector3> nodes;
        for (int i = 0; i <= segments; ++i) {
            const double u = static_cast<double>(i) / segments;
            nodes.emplace_back(0.25 * std::cos(3.0 * u), 0.25 * std::sin(3.0 * u), 0.02 * std::sin(6 * u));
        }
        spec.rest_nodes = nodes;
        rod = std::make_unique<Rod>(spec);
        state = rod->make_state();
        scratch = rod->make_scratch();
        inputs.gravity = Vector3(0, 0, -9.81);
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        inputs.contacts.reserve(128);
        inputs.grasps.reserve(4);
        for (int i = 0; i < 24; ++i) {
            RodTether tether;
            tether.s = rod->length() * (0.1 + 0.8 * i / 23.0);
            tether.offset = Vector3(0, 0.015, 0);
            const Vector3 p = rod->wall_point(state, tether.s, tether.offset);
            tether.anchor = Vector3(0.3 * p.x(), 0.3 * p.y(), 0.05);
            tether.rest_length = 1.15 * (p - tether.anchor).norm();
            tether.stiffness = 15;
            tether.damping = 0.2;
            inputs.tethers.push_back(tether);
        }
    }
    // Every sphere within reach of the floor is a contact: a fixed list, so that multipliers stay with their
    // spheres.
    void add_floor(double height, int spheres, double friction = 0.3) {
        for (int i = 0; i < spheres; ++i) {
            RodContact contact;
            contact.s = rod->length() * (i + 0.5) / spheres;
            contact.point = Vector3(0, 0, height);
            contact.radius = 0.015;
            contact.friction = friction;
            inputs.contacts.push_back(contact);
        }
    }
    RodGrasp& grasp(double s, const Vector3& offset) {
        RodGrasp g;
        g.s = s;
        g.offset = offset;
        g.target = rod->wall_point(state, s, offset);
        inputs.grasps.push_back(g);
        return inputs.grasps.back();
    }
    RodReport step() { return rod->step(state, inputs, dt, scratch); }
    std::unique_ptr<Rod> rod;
    RodState state;
    RodScratch scratch;
    RodInputs inputs;
};

TEST(RodStep, HandlesABowelOnAFloorWithTethersAndTwoGrasps) {
    Bowel bowel;
    bowel.add_floor(-0.06, 60);
    int iterations = 0;
    for (int i = 0; i < 200; ++i) {
        const RodReport report = bowel.step();
        ASSERT_TRUE(report.converged)
            << i << " residual " << report.residual << " iterations " << report.iterations;
        ASSERT_EQ(report.fault, RodFault::none);
        iterations += report.iterations;
    }
    EXPECT_LT(iterations, 200 * 6);
    bowel.grasp(0.3, Vector3(0, 0.015, 0));
    bowel.grasp(0.55, Vector3(0.015, 0, 0));
    double work = 0;
    for (int i = 0; i < 400; ++i) {
        const double speed = i < 200 ? 0.05 : -0.05;
        bowel.inputs.grasps[0].target += Vector3(0, 0, speed) * dt;
        bowel.inputs.grasps[1].target += Vector3(-0.3 * speed, 0, speed) * dt;
        const RodReport report = bowel.step();
        ASSERT_TRUE(report.converged)
            << i << " residual " << report.residual << " iterations " << report.iterations;
        ASSERT_LE(report.constraint_residual, 1e-9);
        ASSERT_LE(report.penetration, 1e-5);
        work += bowel.inputs.grasps[0].reaction.dot(Vector3(0, 0, speed) * dt);
        if (i == 199) {
            EXPECT_GT(bowel.inputs.grasps[0].reaction.z(), 0.02);
        }
    }
    EXPECT_GT(work, 0) << "lifting and lowering a damped bowel costs work";
}

TEST(RodStep, SettlesAndSupportsCarryTheWeight) {
    Bowel bowel;
    bowel.add_floor(-0.03, 60, 0.0);
    bowel.grasp(0.4, Vector3(0, 0.015, 0)).target += Vector3(0, 0, 0.02);
    RodReport report;
    for (int i = 0; i < 3000; ++i) report = bowel.step();
    ASSERT_TRUE(report.converged);
    Vector3 sum = bowel.inputs.grasps[0].reaction + report.end_force[0] + report.end_force[1];
    for (const RodContact& contact : bowel.inputs.contacts) sum += contact.lambda * contact.normal;
    for (const RodTether& tether : bowel.inputs.tethers) sum += tether.force;
    const double weight = 0.25 * bowel.rod->length() * 9.81;
    EXPECT_NEAR(sum.z(), weight, 1e-4 * weight);
    EXPECT_NEAR(sum.x(), 0, 1e-4 * weight);
    EXPECT_NEAR(sum.y(), 0, 1e-4 * weight);
    EXPECT_LT(bowel.rod->energy(bowel.state, bowel.inputs).kinetic, 1e-9);
}

// A short, soft bowel as in scene C4, clamped at one end, drawn by a hold near the clamp; then a load of 20 N
// with couples appears within one step. One trial of 400 reached 1,346 m/s and one 43 m/s with segments that
// were folded over.
TEST(RodStep, DoesNotFoldASegmentOverUnderALoadThatAppearsAtOnce) {
    RodSpec spec;
    spec.segments = 24;
    spec.length = 0.14;
    spec.outer_radius = 0.014;
    spec.inner_radius = 0.011;
    spec.young_modulus = 32300;
    spec.linear_density = 1.2;
    spec.mass_damping = 20;
    spec.ends[0] = RodEnd::clamped;
    spec.ends[1] = RodEnd::free;
    const Rod rod(spec);
    Random random(1, 2);
    const auto direction = [&] {
        return Vector3(2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1)
            .normalized();
    };
    for (int trial = 0; trial < 400; ++trial) {
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        RodGrasp hold;
        hold.s = 0.005 + 0.03 * random.uniform();
        hold.offset = Vector3(0.001, -0.014, 0);
        hold.target = rod.wall_point(state, hold.s, hold.offset);
        hold.stiffness = 800;
        hold.most = 9.6;
        inputs.grasps.push_back(hold);
        const Vector3 pull = 0.0005 * direction();
        for (int i = 0; i < 60; ++i) {
            inputs.grasps[0].target += pull;
            rod.step(state, inputs, dt, scratch);
        }
        const Vector3 push = direction();
        for (int k = 0; k < 5; ++k) inputs.loads.push_back({0.003 * k, 4.0 * push, 0.1 * direction()});
        const RodReport report = rod.step(state, inputs, dt, scratch);
        double speed = 0;
        for (const Vector3& velocity : state.velocities) speed = std::max(speed, velocity.norm());
        EXPECT_LT(speed, 30) << "trial " << trial << " in " << report.substeps << " parts";
        EXPECT_TRUE(report.finite) << "trial " << trial;
    }
}

TEST(RodStep, RepeatsBitForBitAndAllocatesNothing) {
    RodState results[2];
    for (RodState& result : results) {
        Bowel bowel;
        bowel.add_floor(-0.06, 60);
        bowel.grasp(0.3, Vector3(0, 0.015, 0));
        std::uint64_t before = 0;
        for (int i = 0; i < 200; ++i) {
            if (i == 20) before = test::allocation_count();
            bowel.inputs.grasps[0].target += Vector3(0.0002, 0, 0.0003);
            bowel.step();
            (void)bowel.rod->frame_at(bowel.state, 0.4);
            (void)bowel.rod->stiffness_at(bowel.state, 0.3, Vector3(0, 0.015, 0), bowel.scratch);
        }
        EXPECT_EQ(test::allocation_count() - before, 0u);
        result = bowel.state;
    }
    const auto same = [](const auto& a, const auto& b) {
        return std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    EXPECT_TRUE(same(results[0].nodes, results[1].nodes));
    EXPECT_TRUE(same(results[0].directors, results[1].directors));
    EXPECT_TRUE(same(results[0].velocities, results[1].velocities));
    EXPECT_TRUE(same(results[0].joint_twist, results[1].joint_twist));
    EXPECT_TRUE(same(results[0].spins, results[1].spins));
}

TEST(RodStep, ConservesMomentumInFreeFlight) {
    RodSpec spec;
    spec.mass_damping = 0;
    spec.segments = 24;
    Rod rod(spec);
    RodState state = rod.make_state();
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        state.velocities[i] = Vector3(0.1, std::sin(0.3 * static_cast<double>(i)), 0.2);
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    const auto momentum = [&] {
        Vector3 sum = Vector3::Zero();
        for (std::size_t i = 0; i < state.nodes.size(); ++i)
            sum += rod.node_mass(static_cast<int>(i)) * state.velocities[i];
        return sum;
    };
    const Vector3 start = momentum();
    RodSolve exact;
    exact.tolerance = 1e-12;
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(rod.step(state, inputs, dt, scratch, exact).finite);
    EXPECT_LT((momentum() - start).norm(), 1e-10);
}

TEST(RodStep, StiffnessAtAGraspMatchesASmallDisplacement) {
    Bowel bowel;
    const Vector3 offset(0, 0.015, 0);
    bowel.grasp(0.4, offset);
    for (int i = 0; i < 400; ++i) bowel.step();
    // The force responds to a displaced target within one step with the stiffness of that step.
    const RodState state = bowel.state;
    const RodInputs inputs = bowel.inputs;
    const Matrix3 stiffness = bowel.rod->stiffness_at(state, 0.4, offset, bowel.scratch);
    bowel.step();
    const Vector3 still = bowel.inputs.grasps[0].reaction;
    for (int axis = 0; axis < 3; ++axis) {
        bowel.state = state;
        bowel.inputs = inputs;
        bowel.inputs.grasps[0].target[axis] += 1e-6;
        bowel.step();
        const Vector3 change = (bowel.inputs.grasps[0].reaction - still) / 1e-6;
        EXPECT_LT((change - stiffness.col(axis)).norm(), 0.02 * stiffness.norm()) << axis;
    }
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix3>(stiffness).eigenvalues()[0], 0);
}

TEST(RodStep, GraspThatYieldsPullsAsASpringAndAtMostItsFriction) {
    Bowel bowel;
    const Vector3 offset(0, 0.015, 0);
    bowel.grasp(0.4, offset);
    const Vector3 start = bowel.inputs.grasps[0].target;
    bowel.inputs.grasps[0].stiffness = 800;
    for (const double lift : {0.004, 0.02, 0.08}) {
        for (const double most : {100.0, 0.5}) {
            RodGrasp& grasp = bowel.inputs.grasps[0];
            grasp.target = start + Vector3(0, 0, lift);
            grasp.most = most;
            for (int i = 0; i < 400; ++i) ASSERT_TRUE(bowel.step().finite);
            const Vector3 away = grasp.target - bowel.rod->wall_point(bowel.state, grasp.s, grasp.offset);
            EXPECT_NEAR(grasp.reaction.norm(), std::min(most, 800 * away.norm()), 1e-9);
            EXPECT_NEAR(grasp.reaction.cross(away).norm(), 0, 1e-9) << "towards the target";
        }
    }
    // What the rod alone answers with, the spring left out: rigidly held there, the same.
    bowel.inputs.grasps[0].most = 100;
    for (int i = 0; i < 400; ++i) bowel.step();
    const Vector3 here = bowel.rod->wall_point(bowel.state, 0.4, offset);
    const Matrix3 behind = bowel.rod->stiffness_at(bowel.state, 0.4, offset, bowel.scratch);
    bowel.inputs.grasps[0].stiffness = std::numeric_limits<double>::infinity();
    bowel.inputs.grasps[0].target = here;
    for (int i = 0; i < 10; ++i) bowel.step();
    const Matrix3 rigid = bowel.rod->stiffness_at(bowel.state, 0.4, offset, bowel.scratch);
    EXPECT_LT((behind - rigid).norm(), 0.02 * rigid.norm());
}

TEST(RodStep, TwoGraspsThatYieldOnOneSectionShareTheirDistance) {
    // Two wall points 0 to 15 mm apart, asked to be 6 mm nearer to each other, as jaws that reach for tissue
    // do: two springs of 800 N/m in series, whatever the rod between them.
    for (const double apart : {0.0, 0.002, 0.004, 0.008, 0.015}) {
        Bowel bowel;
        const Vector3 offset(0, 0.015, 0);
        for (const double s : {0.4, 0.4 + apart}) bowel.grasp(s, offset);
        for (RodGrasp& grasp : bowel.inputs.grasps) grasp.stiffness = 800;
        bowel.inputs.grasps[1].target += Vector3(0, 0, 0.006);
        for (int i = 0; i < 400; ++i) ASSERT_TRUE(bowel.step().finite);
        for (const RodGrasp& grasp : bowel.inputs.grasps)
            EXPECT_LT(grasp.reaction.norm(), 0.006 * 400 + 0.6) << apart;
    }
}

TEST(RodStep, PowerOfALoadEqualsThePowerOnItsFrame) {
    Bowel bowel;
    for (int i = 0; i < 10; ++i) bowel.step();
    bowel.inputs.gravity.setZero();
    for (const double s : {0.003, 0.2, 0.437, 0.75}) {
        RodLoad load;
        load.s = s;
        load.force = Vector3(1, -2, 0.5);
        load.moment = Vector3(0.02, 0.01, -0.03);
        bowel.inputs.loads = {load};
        const RodMotion motion = bowel.rod->frame_at(bowel.state, s);
        RodState state = bowel.state;
        bowel.rod->step(state, bowel.inputs, dt, bowel.scratch);
        // Power of the load on the unknowns, with their velocities at that time.
        const std::vector<double>& dead = bowel.scratch.data().dead;
        double power = 0;
        for (std::size_t i = 0; i < bowel.state.nodes.size(); ++i) {
            const Vector3& v = bowel.state.velocities[i];
            power += dead[4 * i] * v.x() + dead[4 * i + 1] * v.y() + dead[4 * i + 2] * v.z();
            if (i < bowel.state.spins.size()) power += dead[4 * i + 3] * bowel.state.spins[i];
        }
        const double expected = load.force.dot(motion.velocity) + load.moment.dot(motion.angular_velocity);
        EXPECT_NEAR(power, expected, 1e-12 * (std::fabs(power) + load.force.norm() * motion.velocity.norm()))
            << s;
    }
}

TEST(RodStep, ExtremeStepsStayFinite) {
    const double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    for (const double jump : {0.05, 0.3, 1.0, 10.0}) {
        Bowel bowel;
        bowel.add_floor(-0.06, 60);
        bowel.grasp(0.3, Vector3(0, 0.015, 0));
        bowel.grasp(0.5, Vector3(0, 0.015, 0));
        for (int i = 0; i < 60; ++i) {
            if (i == 10) bowel.inputs.grasps[0].target += Vector3(jump, -jump, jump);
            if (i == 30) bowel.inputs.grasps[0].target -= Vector3(jump, -jump, jump);
            const RodReport report = bowel.step();
            ASSERT_TRUE(Rod::finite(bowel.state)) << jump << " " << i;
            if (i > 50 && jump < 0.1) {
                EXPECT_NE(report.fault, RodFault::frozen) << i << " residual " << report.residual;
            }
        }
    }
    Bowel bowel;
    bowel.grasp(0.3, Vector3(0, 0.015, 0));
    for (const double bad : {nan, infinity, -infinity}) {
        bowel.inputs.grasps[0].target.x() = bad;
        const RodReport report = bowel.step();
        EXPECT_EQ(report.fault, RodFault::frozen);
        EXPECT_FALSE(report.finite);
        ASSERT_TRUE(Rod::finite(bowel.state));
    }
    bowel.inputs.grasps[0].target = bowel.rod->wall_point(bowel.state, 0.3, Vector3(0, 0.015, 0));
    EXPECT_TRUE(bowel.step().converged);
    for (const double force : {1.0, 1000.0}) {
        Bowel pulled;
        RodLoad load;
        load.s = 0.4;
        load.force = Vector3(0, force, force);
        load.moment = Vector3(force * 0.01, 0, 0);
        pulled.inputs.loads.push_back(load);
        for (int i = 0; i < 100; ++i) {
            pulled.step();
            ASSERT_TRUE(Rod::finite(pulled.state)) << force << " " << i;
        }
    }
}

}  // namespace
}  // namespace fulcrum
