// SPDX-License-Identifier: Apache-2.0
// Requirements on every spring and integrator: force = -grad E, tangent = d force, no force at rest, rigid
// motion does not change the energy, momentum is conserved.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/membrane/membrane.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

using test::momentum;

MembraneMaterial only(SpringKind kind) {
    MembraneMaterial material;
    material.structural_stiffness = kind == SpringKind::structural ? 40 : 0;
    material.shear_stiffness = kind == SpringKind::shear ? 25 : 0;
    material.bend_stiffness = kind == SpringKind::bend ? 3 : 0;
    return material;
}

Vector3 angular_momentum(const Membrane& membrane, const MembraneState& state) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        sum += membrane.masses()[v] * state.positions[v].cross(state.velocities[v]);
    return sum;
}

class EverySpring : public ::testing::TestWithParam<SpringKind> {};

TEST_P(EverySpring, ExistsAndItsForceIsMinusTheGradient) {
    const Membrane membrane(test::sheet(6, 5), only(GetParam()), {});
    ASSERT_FALSE(membrane.springs().empty());
    MembraneState state = membrane.make_state();
    test::shake(state.positions, 0.006, 3);
    std::vector<Vector3> forces, ahead, behind;
    membrane.forces(state, forces);
    const double h = 1e-6, t = 1e-7;
    double worst = 0, largest = 0;
    for (std::size_t v = 0; v < forces.size(); ++v) {
        for (int c = 0; c < 3; ++c) {
            MembraneState moved = state;
            moved.positions[v][c] += h;
            const double up = membrane.energy(moved).elastic();
            moved.positions[v][c] -= 2 * h;
            const double slope = (up - membrane.energy(moved).elastic()) / (2 * h);
            worst = std::max(worst, std::abs(forces[v][c] + slope));
            largest = std::max(largest, std::abs(forces[v][c]));
        }
    }
    EXPECT_GT(largest, 1e-3);
    EXPECT_LT(worst, 1e-7 * largest);

    std::vector<Vector3> direction(forces.size(), Vector3::Zero()), product;
    test::shake(direction, 1.0, 5);
    membrane.tangent_times(state, direction, product);
    MembraneState moved = state;
    for (std::size_t v = 0; v < forces.size(); ++v)
        moved.positions[v] = state.positions[v] + t * direction[v];
    membrane.forces(moved, ahead);
    for (std::size_t v = 0; v < forces.size(); ++v)
        moved.positions[v] = state.positions[v] - t * direction[v];
    membrane.forces(moved, behind);
    double difference = 0, size = 0;
    for (std::size_t v = 0; v < forces.size(); ++v) {
        difference += (product[v] + (ahead[v] - behind[v]) / (2 * t)).squaredNorm();
        size += product[v].squaredNorm();
    }
    EXPECT_LT(std::sqrt(difference / size), 1e-6);
}

TEST_P(EverySpring, RestHasNoForceAndRigidMotionKeepsTheEnergy) {
    const Membrane membrane(test::sheet(7, 6), only(GetParam()), {});
    MembraneState state = membrane.make_state();
    EXPECT_EQ(membrane.energy(state).elastic(), 0.0);
    const Matrix3 turn = Eigen::AngleAxisd(1.3, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (Vector3& p : state.positions) p = turn * p + Vector3(0.3, -0.2, 0.1);
    EXPECT_LT(membrane.energy(state).elastic(), 1e-28);
    std::vector<Vector3> forces;
    membrane.forces(state, forces);
    for (const Vector3& f : forces) EXPECT_LT(f.norm(), 1e-13);
}

TEST_P(EverySpring, PreStrainPullsInwards) {
    MembraneMaterial material = only(GetParam());
    material.pre_strain = 0.1;
    const Membrane membrane(test::sheet(6, 6), material, {});
    std::vector<Vector3> forces;
    membrane.forces(membrane.make_state(), forces);
    EXPECT_GT(forces[0].dot(Vector3(1, 1, 0)), 1e-6);
    EXPECT_GT(membrane.energy(membrane.make_state()).elastic(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Membrane, EverySpring,
                         ::testing::Values(SpringKind::structural, SpringKind::shear, SpringKind::bend));

class EveryIntegrator : public ::testing::TestWithParam<MembraneIntegrator> {
  protected:
    static MembraneMaterial material() {
        MembraneMaterial m;
        m.stiffness_damping = 2e-4;
        return m;
    }
};

TEST_P(EveryIntegrator, ConservesLinearMomentum) {
    const Membrane membrane(test::sheet(9, 8), material(), {});
    MembraneState state = membrane.make_state();
    test::shake(state.positions, 0.002, 1);
    test::shake(state.velocities, 0.5, 2);
    const Vector3 before = momentum(membrane, state);
    double scale = 0;
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        scale += membrane.masses()[v] * state.velocities[v].norm();
    MembraneScratch scratch = membrane.make_scratch(0.002);
    MembraneInputs inputs;
    MembraneSolve solve;
    solve.integrator = GetParam();
    for (int i = 0; i < 50; ++i) {
        const MembraneReport report = membrane.step(state, inputs, 0.002, scratch, solve);
        ASSERT_LE(report.fault, MembraneFault::unconverged);
    }
    EXPECT_LT((momentum(membrane, state) - before).norm(), 1e-10 * scale);
}

TEST_P(EveryIntegrator, SupportsAndLoadsBalanceTheMomentumOfAHeldSheet) {
    const Membrane membrane(test::sheet(9, 8), material(), {0, 8, 40});
    MembraneState state = membrane.make_state();
    MembraneScratch scratch = membrane.make_scratch(0.002);
    MembraneInputs inputs;
    inputs.gravity = Vector3(0.3, -1, -9.81);
    inputs.reactions.resize(3);
    inputs.attachments = {state.positions[0], state.positions[8], state.positions[40]};
    MembraneSolve solve;
    solve.integrator = GetParam();
    if (solve.integrator == MembraneIntegrator::global_local) {
        solve.iterations = 300;
        solve.tolerance = 1e-11;
    }
    for (int i = 0; i < 30; ++i) {
        const Vector3 before = momentum(membrane, state);
        inputs.attachments[1] += Vector3(1e-4, 2e-4, -1e-4);
        membrane.step(state, inputs, 0.002, scratch, solve);
        Vector3 impulse = 0.002 * membrane.material().mass * inputs.gravity;
        for (const Vector3& r : inputs.reactions) impulse += 0.002 * r;
        EXPECT_LT((momentum(membrane, state) - before - impulse).norm(), 1e-9 * impulse.norm() + 1e-12);
    }
}

TEST_P(EveryIntegrator, StepsRepeatBitForBitAndAllocateNothing) {
    const Membrane membrane(test::sheet(9, 8), material(), {0, 8});
    MembraneSolve solve;
    solve.integrator = GetParam();
    std::vector<Vector3> ends[2];
    for (auto& end : ends) {
        MembraneState state = membrane.make_state();
        MembraneScratch scratch = membrane.make_scratch(0.002);
        MembraneInputs inputs;
        inputs.gravity = Vector3(0, 0, -9.81);
        inputs.attachments = {state.positions[0], state.positions[8]};
        inputs.reactions.resize(2);
        const std::uint64_t made = test::allocations_in([&] {
            for (int i = 0; i < 20; ++i) {
                inputs.attachments[0] += Vector3(0, 1e-4, 0);
                if (i == 10) {
                    state.cut[5] = state.cut[17] = 1;
                    ++state.topology;
                }
                membrane.step(state, inputs, i < 15 ? 0.002 : 0.001, scratch, solve);
            }
        });
        EXPECT_EQ(made, 0U);
        end = state.positions;
    }
    EXPECT_EQ(ends[0], ends[1]);
}

INSTANTIATE_TEST_SUITE_P(Membrane, EveryIntegrator,
                         ::testing::Values(MembraneIntegrator::symplectic, MembraneIntegrator::global_local,
                                           MembraneIntegrator::implicit));

// Change of angular momentum over 0.1 s, as a share of it.
double turn_lost(MembraneIntegrator integrator, double dt) {
    const Membrane membrane(test::sheet(8, 8), MembraneMaterial(), {});
    MembraneState state = membrane.make_state();
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        state.velocities[v] = Vector3(0, 0, 5).cross(state.positions[v] - Vector3(0.05, 0.05, 0));
    const Vector3 before = angular_momentum(membrane, state);
    MembraneScratch scratch = membrane.make_scratch(dt);
    MembraneInputs inputs;
    MembraneSolve solve;
    solve.integrator = integrator;
    const int steps = static_cast<int>(std::lround(0.1 / dt));
    for (int i = 0; i < steps; ++i) membrane.step(state, inputs, dt, scratch, solve);
    return (angular_momentum(membrane, state) - before).norm() / before.norm();
}

TEST(Membrane, SymplecticEulerConservesAngularMomentum) {
    EXPECT_LT(turn_lost(MembraneIntegrator::symplectic, 0.001), 1e-10);
}

TEST(Membrane, ImplicitEulerLosesAngularMomentumToFirstOrder) {
    const double coarse = turn_lost(MembraneIntegrator::implicit, 0.0005);
    const double fine = turn_lost(MembraneIntegrator::implicit, 0.00025);
    EXPECT_GT(coarse, 1e-6);
    EXPECT_GT(coarse / fine, 1.6);
    EXPECT_LT(coarse / fine, 2.5);
    RecordProperty("order", std::to_string(std::log2(coarse / fine)));
}

}  // namespace
}  // namespace fulcrum
