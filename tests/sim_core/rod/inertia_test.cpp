// SPDX-License-Identifier: Apache-2.0
// Forces of a moving rod on its supports: reactions under inertia, the moment of a spinning rod, and the
// grasp reaction with one linear solve per step.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "sim_core/lab/reference_rod.h"
#include "sim_core/rod/rod_tables.h"

namespace fulcrum {
namespace {

Vector3 momentum(const Rod& rod, const RodState& state) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        sum += rod.node_mass(static_cast<int>(i)) * state.velocities[i];
    return sum;
}

// A free rod, held at one point that is moved by 16 mm in 0.16 s with a smooth start; the jaw's force at 0.1
// s.
struct Moved {
    Vector3 reaction = Vector3::Zero();
    double unbalanced = 0;  ///< N s, worst step: gain in momentum minus impulse of the jaw
};

Moved move_jaw(double dt, RodSolve::Level level = RodSolve::Level::newton) {
    RodSpec spec;
    spec.segments = 32;
    spec.length = 0.4;
    lab::RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    const Vector3 home = resting.grasp(0.15, Vector3(0, 0.015, 0)).target;
    RodSolve solve;
    solve.level = level;
    solve.tolerance = 1e-10;
    Moved result;
    const int steps = static_cast<int>(std::lround(0.1 / dt));
    for (int i = 1; i <= steps; ++i) {
        const double t = i * dt;
        const double u = t / 0.16, progress = u * u * u * u * (35 - u * (84 - u * (70 - 20 * u)));
        inputs.grasps[0].target = home + Vector3(0.006, 0.008, 0.012) * progress;
        const Vector3 before = momentum(rod, state);
        const RodReport report = rod.step(state, inputs, dt, scratch, solve);
        EXPECT_TRUE(report.finite && report.fault == RodFault::none) << i;
        // Damping takes c m v of every node.
        const Vector3 after = momentum(rod, state);
        const Vector3 gained = after - before + spec.mass_damping * dt * after;
        result.unbalanced = std::max(result.unbalanced, (gained - dt * inputs.grasps[0].reaction).norm());
    }
    result.reaction = inputs.grasps[0].reaction;
    return result;
}

TEST(RodInertia, GraspImpulseEqualsTheGainInMomentumAndIsFirstOrderInTheStep) {
    const Moved fine = move_jaw(0.1 / 6400);
    double before = 0;
    for (const int steps : {50, 100, 200, 400}) {
        const Moved moved = move_jaw(0.1 / steps);
        const double error = (moved.reaction - fine.reaction).norm() / fine.reaction.norm();
        std::printf("steps of %.2f ms: reaction %.5f N, off by %.2e, impulse to %.1e N s\n", 100.0 / steps,
                    moved.reaction.norm(), error, moved.unbalanced);
        EXPECT_LT(moved.unbalanced, 1e-10);
        if (before > 0) {
            EXPECT_GT(before / error, 1.7);
            EXPECT_LT(before / error, 2.5);
        }
        before = error;
    }
    EXPECT_LT(before, 0.02);
}

// One linear system per step: its multipliers are the reaction. The remaining constraint residual of the full
// step is not a force.
TEST(RodInertia, OneLinearSolvePerStepGivesTheReactionOfTheFullSolve) {
    for (const int steps : {20, 50, 200}) {
        const Moved full = move_jaw(0.1 / steps), one = move_jaw(0.1 / steps, RodSolve::Level::linearised);
        const double apart = (one.reaction - full.reaction).norm() / full.reaction.norm();
        std::printf("steps of %.1f ms: %.4f N, linearised off by %.1e\n", 100.0 / steps, full.reaction.norm(),
                    apart);
        EXPECT_LT(apart, 0.01) << steps;
    }
}

// Moment of the clamp about z, mean over 0.05 s of turning about y at `turning` while the rod spins about its
// axis.
double clamp_moment(double spin, double turning, double dt) {
    RodSpec spec;
    spec.segments = 8;
    spec.length = 0.1;
    spec.inner_radius = 0;
    spec.young_modulus = 1e7;
    spec.mass_damping = 0;
    spec.ends[0] = RodEnd::clamped;
    lab::RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    for (double& each : state.spins) each = spin;
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        state.velocities[i] = Vector3(0, turning, 0).cross(state.nodes[i]);
    RodSolve exact;
    exact.tolerance = 1e-11;
    double sum = 0;
    const int steps = static_cast<int>(std::lround(0.1 / dt));
    int counted = 0;
    for (int i = 1; i <= steps; ++i) {
        const double about_y = turning * i * dt, about_x = spin * i * dt;
        const Vector3 t(std::cos(about_y), 0, -std::sin(about_y)),
            up(std::sin(about_y), 0, std::cos(about_y)), side(0, 1, 0);
        RodFrame& end = inputs.ends[0];
        end.rotation.col(0) = std::cos(about_x) * side + std::sin(about_x) * up;
        end.rotation.col(1) = -std::sin(about_x) * side + std::cos(about_x) * up;
        end.rotation.col(2) = t;
        const RodReport report = rod.step(state, inputs, dt, scratch, exact);
        EXPECT_TRUE(report.finite && report.fault == RodFault::none) << i;
        if (2 * i <= steps) continue;
        sum += report.end_moment[0].dot(up);
        ++counted;
    }
    return sum / counted;
}

TEST(RodInertia, TurningASpinningRodLoadsItsClampWithTheGyroscopicMoment) {
    RodSpec spec;
    spec.segments = 8;
    spec.length = 0.1;
    spec.inner_radius = 0;
    const Rod rod(spec);
    double inertia = 0;
    for (std::size_t j = 0; j < 8; ++j) inertia += rod.tables().spin_inertia[j];
    const double solid = 0.5 * spec.linear_density * spec.length * spec.outer_radius * spec.outer_radius;
    EXPECT_NEAR(inertia, solid, 1e-3 * solid);
    const double spin = 40, turning = 3, expected = -inertia * spin * turning;
    for (const double dt : {1e-3, 5e-4, 2.5e-4}) {
        // Half of the difference between the two directions of spin: other bending contributions cancel.
        const double moment = 0.5 * (clamp_moment(spin, turning, dt) - clamp_moment(-spin, turning, dt));
        std::printf("steps of %.2f ms: %.4e N m, I spin turning = %.4e N m\n", 1e3 * dt, moment, expected);
        EXPECT_NEAR(moment, expected, 0.05 * std::fabs(expected));
    }
}

}  // namespace
}  // namespace fulcrum
