// SPDX-License-Identifier: Apache-2.0
// The rod compared with solutions by other methods: the catenary, a grasped elastica by shooting, beam
// formulas for every pair of ends, equilibrium of a held section, and the levels against the elastica.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/bowel/spheres.h"
#include "sim_core/lab/catenary.h"
#include "sim_core/lab/elastica.h"
#include "sim_core/lab/held_elastica.h"
#include "sim_core/lab/reference_rod.h"
#include "sim_core/rod/rod.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

RodSpec solid(int segments, double length, double radius) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = length;
    spec.outer_radius = radius;
    spec.inner_radius = 0;
    return spec;
}

TEST(RodReference, HangingChainConvergesToTheCatenary) {
    const double length = 0.6, span = 0.4, axial = 100;
    double before = 1;
    std::vector<Vector3> last;
    for (const double radius : {0.004, 0.002, 0.001, 0.0005, 0.00025}) {
        RodSpec spec = solid(200, length, radius);
        spec.young_modulus = axial / (pi * radius * radius);  // the same chain, increasingly soft in bending
        spec.ends[0] = spec.ends[1] = RodEnd::pinned;
        const Rod rod(spec);
        std::vector<Vector3> nodes;
        for (int i = 0; i <= spec.segments; ++i) {
            const double u = static_cast<double>(i) / spec.segments;
            nodes.emplace_back(span * u, 0, -0.8 * u * (1 - u));
        }
        // Each softer chain starts from the previous one.
        RodState state = rod.make_state(before < 1 ? last : nodes);
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        inputs.gravity.z() = -9.81;
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        const RodReport report = rod.solve(state, inputs, scratch);
        ASSERT_TRUE(report.converged && report.positive_definite) << radius;
        const double weight = 9.81 * spec.linear_density, sag = -state.nodes[100].z();
        const lab::Catenary chain{length, span, weight, axial};
        const double expected = -lab::catenary_point(chain, lab::catenary_tension(chain), 0.5 * length).z;
        const double error = std::fabs(sag / expected - 1);
        std::printf("EI/(w L^3) = %.1e: sag %.6f m, catenary %.6f m, apart %.1e\n",
                    rod.bending_stiffness() / (weight * length * length * length), sag, expected, error);
        EXPECT_LT(error, before) << radius;
        before = error;
        last = state.nodes;
        // Each support carries half of the weight, to the tolerance of the solve.
        EXPECT_NEAR(report.end_force[0].z(), 0.5 * weight * length, 1e-5 * weight * length);
    }
    EXPECT_LT(before, 1e-4);
}

// Refinement of the `lab validate` case with 256 segments: a jaw's force is distributed over a segment, so
// the tension along the rod next to it is correct to first order.
TEST(RodReference, TwoGraspsConvergeToTheElasticaByShooting) {
    RodSpec spec = solid(48, 0.4, 0.015);
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    lab::HeldElastica problem;
    problem.length = spec.length;
    problem.held_at = {0.15, 0.3};
    problem.moved = {{{-0.005, 0.05}, {-0.01, -0.02}}};
    double before = 0;
    for (const int segments : {48, 96, 192}) {
        spec.segments = segments;
        lab::RestingRod resting(spec);
        problem.bending_stiffness = resting.rod.bending_stiffness();
        problem.axial_stiffness = resting.rod.axial_stiffness();
        const lab::HeldElasticaSolution exact = lab::solve_held_elastica(problem);
        ASSERT_LT(exact.residual, 1e-10);
        const RodReport report = lab::hold_as(problem, resting);
        ASSERT_TRUE(report.converged);
        EXPECT_TRUE(report.positive_definite);
        double error = 0, size = 0;
        Vector3 sum = report.end_force[0] + report.end_force[1];
        for (std::size_t k = 0; k < 2; ++k) {
            const Vector3 jaw(exact.reaction[k][0], 0, exact.reaction[k][1]);
            const Vector3& reaction = resting.inputs.grasps[k].reaction;
            error = std::max(error, (reaction - jaw).norm());
            size = std::max(size, jaw.norm());
            sum += reaction;
        }
        std::printf("%d segments: reactions apart by %.2e of the largest (%.4f N)\n", segments, error / size,
                    size);
        EXPECT_LT(sum.norm(), 1e-5 * size);
        if (before > 0) {
            EXPECT_GT(before / error, 1.7);
        }
        before = error;
        if (segments == 192) {
            EXPECT_LT(error, 5e-3 * size);
        }
    }
}

// Small deflection under a force at the middle, by the beam formulas of each pair of ends.
TEST(RodReference, EveryPairOfEndsMatchesItsBeamFormula) {
    struct Row {
        RodEnd near, far;
        double factor;  // w = factor P L^3 / EI under the force
    };
    for (const Row row :
         {Row{RodEnd::clamped, RodEnd::clamped, 1.0 / 192}, Row{RodEnd::pinned, RodEnd::pinned, 1.0 / 48},
          Row{RodEnd::held, RodEnd::held, 1.0 / 48}, Row{RodEnd::clamped, RodEnd::pinned, 7.0 / 768},
          Row{RodEnd::clamped, RodEnd::held, 7.0 / 768}, Row{RodEnd::clamped, RodEnd::free, 1.0 / 24},
          Row{RodEnd::free, RodEnd::clamped, 1.0 / 24}}) {
        RodSpec spec = solid(64, 0.4, 0.015);
        spec.ends[0] = row.near;
        spec.ends[1] = row.far;
        lab::RestingRod resting(spec);
        auto& [rod, state, scratch, inputs] = resting;
        const double expected = 1e-6,
                     force = expected * rod.bending_stiffness() / std::pow(0.4, 3) / row.factor;
        inputs.nodal_forces.assign(65, Vector3::Zero());
        inputs.nodal_forces[32].z() = force;
        RodSolve exact;
        exact.tolerance = 1e-9;
        const RodReport report = rod.solve(state, inputs, scratch, exact);
        EXPECT_TRUE(report.converged && report.positive_definite);
        EXPECT_NEAR(state.nodes[32].z(), expected, 2e-3 * expected)
            << row.factor << static_cast<int>(row.far);
        EXPECT_NEAR((report.end_force[0] + report.end_force[1]).z(), -force, 1e-6 * force);
        if (row.near == RodEnd::free) {
            EXPECT_EQ(report.end_force[0].norm(), 0);
        }
        if (row.near == RodEnd::pinned) {
            EXPECT_LT(report.end_moment[0].norm(), 1e-8 * force * 0.4);
        }
        if (row.near == RodEnd::clamped && row.far == RodEnd::clamped) {
            EXPECT_NEAR(std::fabs(report.end_moment[0].y()), force * 0.4 / 8, 2e-3 * force * 0.4);
        }
    }
    // Twist: a held end carries G J theta / L, a pinned or a free one rotates along.
    for (const RodEnd far : {RodEnd::held, RodEnd::clamped, RodEnd::pinned, RodEnd::free}) {
        RodSpec spec = solid(64, 0.4, 0.015);
        spec.ends[0] = RodEnd::clamped;
        spec.ends[1] = far;
        lab::RestingRod resting(spec);
        auto& [rod, state, scratch, inputs] = resting;
        const double angle = 0.7;
        for (RodFrame* end : {&inputs.ends[0]}) {
            end->rotation.col(0) = Vector3(0, std::cos(angle), std::sin(angle));
            end->rotation.col(1) = Vector3(0, -std::sin(angle), std::cos(angle));
        }
        const RodReport report = rod.solve(state, inputs, scratch);
        EXPECT_TRUE(report.converged);
        const double torque =
            far == RodEnd::held || far == RodEnd::clamped ? rod.torsional_stiffness() * angle / 0.4 : 0;
        EXPECT_NEAR(report.end_moment[0].x(), torque, 1e-6 * rod.torsional_stiffness())
            << static_cast<int>(far);
        EXPECT_NEAR(report.end_moment[1].x(), -torque, 1e-6 * rod.torsional_stiffness())
            << static_cast<int>(far);
    }
}

// A section held in position and direction acts as a clamp: the part before it has no load, the jaw carries
// force and moment of the part beyond.
TEST(RodReference, HeldRotationIsAConstraintWithItsMomentAsReaction) {
    RodSpec spec = solid(80, 0.4, 0.015);
    spec.ends[0] = RodEnd::clamped;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    RodGrasp grasp;
    grasp.s = 0.2025;  // between nodes
    grasp.offset = Vector3(0, 0.015, 0);
    grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
    grasp.hold_rotation = true;
    grasp.target_rotation = rod.frame_at(state, grasp.s).frame.rotation;
    inputs.grasps.push_back(grasp);
    inputs.nodal_forces.assign(81, Vector3::Zero());
    const Vector3 force(0, 4e-3, -2e-2);
    inputs.nodal_forces[80] = force;
    RodSolve exact;
    exact.tolerance = 1e-10;
    RodReport report = rod.solve(state, inputs, scratch, exact);
    ASSERT_TRUE(report.converged && report.positive_definite);
    EXPECT_LE(report.constraint_residual, 1e-9);
    const RodGrasp& held = inputs.grasps[0];
    EXPECT_LT((held.reaction + force).norm(), 1e-5 * force.norm());
    EXPECT_LT(report.end_force[0].norm(), 1e-5 * force.norm());
    const Vector3 wall = rod.wall_point(state, grasp.s, grasp.offset);
    const Vector3 moment = -(state.nodes[80] - wall).cross(force);
    EXPECT_LT((held.moment - moment).norm(), 1e-5 * moment.norm());
    // The blended section has the requested orientation, to rounding of the residual: 1e-9 m at the wall.
    const Matrix3 turned = grasp.target_rotation.transpose() * rod.frame_at(state, grasp.s).frame.rotation;
    EXPECT_LT(std::acos(std::min(1.0, 0.5 * (turned.trace() - 1))), 1e-4);

    // Turned about the rod: G J theta over the free length before it, nothing beyond.
    inputs.nodal_forces.clear();
    inputs.grasps[0].offset.setZero();
    inputs.grasps[0].reaction.setZero();
    inputs.grasps[0].moment.setZero();
    state = rod.make_state();
    inputs.grasps[0].target = rod.wall_point(state, grasp.s, Vector3::Zero());
    double expected = 0;
    // In small steps through ten turns (under tension, so that it stays straight), and in jumps of two
    // radians.
    inputs.grasps[0].target.x() += 0.2;
    for (const double step : {0.2, 2.0}) {
        state = rod.make_state();
        inputs.grasps[0].moment.setZero();
        inputs.grasps[0].reaction.setZero();
        for (double angle = step; angle < 20 * pi + step; angle += step) {
            inputs.grasps[0].target_rotation.col(0) = Vector3(0, std::cos(angle), std::sin(angle));
            inputs.grasps[0].target_rotation.col(1) = Vector3(0, -std::sin(angle), std::cos(angle));
            inputs.grasps[0].target_rotation.col(2) = Vector3(1, 0, 0);
            report = rod.solve(state, inputs, scratch, exact);
            ASSERT_TRUE(report.converged)
                << step << " " << angle << " " << report.residual << " " << report.constraint_residual;
            expected = angle;
        }
        // To the middle of the blend between two segments: the twist up to each contributes by its share.
        const double torque = rod.torsional_stiffness() * expected / grasp.s;
        EXPECT_NEAR(inputs.grasps[0].moment.x(), torque, 0.01 * torque) << step;
        EXPECT_NEAR(report.end_moment[0].x(), -inputs.grasps[0].moment.x(), 1e-6 * torque) << step;
    }
}

// docs/THEORY.md, section 8: error of each level compared with the elastica; cost in linear systems.
TEST(RodReference, EachLevelHasItsStatedErrorAndTheNextIsBetter) {
    RodSpec spec = solid(96, 0.4, 0.015);
    spec.ends[0] = RodEnd::clamped;
    const Rod rod(spec);
    lab::Cantilever cantilever;
    cantilever.bending_stiffness = rod.bending_stiffness();
    cantilever.axial_stiffness = rod.axial_stiffness();
    cantilever.distributed = 10 * rod.bending_stiffness() / std::pow(0.4, 3);
    const lab::CantileverTip tip = lab::solve_cantilever(cantilever, 1000);
    const auto error = [&](RodSolve solve, int parts) {
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        inputs.ends[0] = state.ends[0];
        RodReport report;
        int systems = 0;
        for (int k = 1; k <= parts; ++k) {
            inputs.gravity.z() = -cantilever.distributed / spec.linear_density * k / parts;
            report = rod.solve(state, inputs, scratch, solve);
            systems += report.iterations;
        }
        const double apart = std::hypot(state.nodes.back().x() - tip.x, state.nodes.back().z() - tip.z) / 0.4;
        std::printf("%-10s %3d load steps, %3d systems: tip %.2e L\n",
                    solve.level == RodSolve::Level::linearised
                        ? "linearised"
                        : (solve.level == RodSolve::Level::newton ? "newton" : "newton(k)"),
                    parts, systems, apart);
        return apart;
    };
    RodSolve linear;
    linear.level = RodSolve::Level::linearised;
    double before = 10;
    for (const int parts : {1, 4, 16, 64}) {
        const double now = error(linear, parts);
        EXPECT_LT(now, before) << parts;
        before = now;
    }
    RodSolve some;
    some.level = RodSolve::Level::newton_k;
    before = 10;
    for (const int k : {1, 3, 6, 12}) {
        some.iterations = k;
        const double now = error(some, 1);
        EXPECT_LE(now, before) << k;
        before = now;
    }
    EXPECT_LT(error(RodSolve{}, 1), 2e-5);
}

// The collision shape is independent of the rod's nodes and follows the same curve.
TEST(RodReference, SpheresAreSampledIndependentlyOfTheNodes) {
    const double length = 0.3, bend = 6;  // natural curvature, 1/m
    const SphereChain chain = sample_spheres(length, 0.011, [](double s) { return 0.012 + 0.004 * s; });
    EXPECT_NEAR(chain.arc_lengths.back(), length, 1e-15);
    double before = 0;
    for (const int segments : {16, 31, 64, 257}) {
        RodSpec spec = solid(segments, length, 0.01);
        spec.intrinsic_curvature[0] = bend;
        const Rod rod(spec);
        const RodState state = rod.make_state();
        double worst = 0;
        for (const double s : chain.arc_lengths) {
            const Vector3 exact(std::sin(bend * s) / bend, 0, (std::cos(bend * s) - 1) / bend);
            const Vector3 centre = rod.frame_at(state, s).frame.position;
            worst = std::max(worst,
                             std::hypot((centre - exact).x(), std::fabs(centre.z()) - std::fabs(exact.z())));
        }
        const double cell = length / segments;
        EXPECT_LT(worst, bend * cell * cell) << segments;
        if (before > 0) {
            EXPECT_LT(worst, before);
        }
        before = worst;
    }
}

// Both ends held, a grasp between them, loaded in all directions: ends towards each other, along the rod and
// across. It may buckle; every warm frame must reach its residual nevertheless.
TEST(RodReference, WarmFramesKeepTheirResidualWhilePushing) {
    for (const int push : {0, 1, 2, 3, 4}) {
        RodSpec spec = solid(50, 0.4, 0.015);
        spec.ends[0] = spec.ends[1] = RodEnd::held;
        const Rod rod(spec);
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        // Pushes 3 and 4: nearly weightless and straight, so that it buckles during the push.
        inputs.gravity = Vector3(0, 0, push < 3 ? -9.81 : -0.01);
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        ASSERT_TRUE(rod.solve(state, inputs, scratch).converged);
        RodGrasp grasp;
        grasp.s = 0.2;
        grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
        inputs.grasps.push_back(grasp);
        int most = 0, sum = 0;
        const int frames = 240;  // 5 ms at 50 mm/s: 60 mm, a third of the half that is pushed
        for (int i = 0; i < frames; ++i) {
            if (push == 0 || push == 3) inputs.grasps[0].target += Vector3(0.00025, 0, 0);
            if (push == 1) inputs.grasps[0].target += Vector3(0.0002, 0, 0.00015);
            if (push == 2 || push == 4) inputs.ends[1].position -= Vector3(0.00025, 0, 0);
            const RodReport report = rod.solve(state, inputs, scratch);
            ASSERT_TRUE(report.converged)
                << push << " " << i << " " << report.residual << " " << report.constraint_residual;
            ASSERT_LE(report.residual, 1e-6);
            ASSERT_LE(report.constraint_residual, 1e-9);
            EXPECT_TRUE(report.positive_definite);
            most = std::max(most, report.iterations);
            sum += report.iterations;
        }
        double out = 0;
        for (const Vector3& node : state.nodes) out = std::max(out, std::hypot(node.y(), node.z()));
        EXPECT_GT(out, 0.02) << push;  // it has buckled or sags
        std::printf("push %d: %.2f systems a frame, at most %d\n", push, static_cast<double>(sum) / frames,
                    most);
    }
}

}  // namespace
}  // namespace fulcrum
