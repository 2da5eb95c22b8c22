// SPDX-License-Identifier: Apache-2.0
// Effect of jaws and blades on a membrane: changing holds, removed springs; momentum and energy.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/membrane/membrane.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

using test::momentum;

constexpr double dt = 0.005;

MembraneMaterial tissue(double pre_strain = 0) {
    MembraneMaterial material;
    material.structural_stiffness = 30;
    material.shear_stiffness = 15;
    material.bend_stiffness = 1.5;
    material.mass = 0.01;
    material.pre_strain = pre_strain;
    return material;
}

class HeldByJaws : public testing::TestWithParam<MembraneIntegrator> {
  protected:
    static MembraneSolve solve() {
        MembraneSolve solve;
        solve.integrator = GetParam();
        if (solve.integrator == MembraneIntegrator::global_local) {
            solve.iterations = 300;
            solve.tolerance = 1e-11;
        }
        return solve;
    }
};

TEST_P(HeldByJaws, ReactionEqualsTheGainInMomentumOfTheSheet) {
    const Membrane membrane(test::sheet(9, 8), tissue(), {});
    MembraneState state = membrane.make_state();
    MembraneScratch scratch = membrane.make_scratch(dt);
    MembraneInputs inputs;
    inputs.holds.resize(3);
    const std::int32_t vertices[] = {40, 41, 40};  // two jaws on one vertex
    for (std::size_t k = 0; k < 3; ++k) {
        inputs.holds[k].vertex = vertices[k];
        inputs.holds[k].stiffness = 200.0 * static_cast<double>(k + 1);
        inputs.holds[k].target = state.positions[static_cast<std::size_t>(vertices[k])];
    }
    double size = 0;
    for (int i = 0; i < 40; ++i) {
        const Vector3 before = momentum(membrane, state);
        for (MembraneHold& hold : inputs.holds) hold.target += Vector3(1e-4, 0, 3e-4);
        ASSERT_LE(membrane.step(state, inputs, dt, scratch, solve()).fault, MembraneFault::unconverged);
        Vector3 impulse = Vector3::Zero();
        for (const MembraneHold& hold : inputs.holds) impulse += dt * hold.reaction;
        EXPECT_LT((momentum(membrane, state) - before - impulse).norm(), 1e-8 * impulse.norm() + 1e-12);
        size += impulse.norm();
    }
    EXPECT_GT(size, 1e-4);
    EXPECT_NEAR(momentum(membrane, state).z(), 0.01 * 0.06, 0.003 * 0.06) << "carried along at 60 mm/s";
}

TEST_P(HeldByJaws, MatrixIsUpdatedForHoldsAndRestoredAfterwards) {
    const Membrane membrane(test::sheet(9, 8), tissue(), {0, 8});
    MembraneState state = membrane.make_state();
    MembraneScratch scratch = membrane.make_scratch(dt);
    MembraneInputs inputs;
    inputs.gravity = Vector3(0, 0, -9.81);
    inputs.reactions.resize(2);
    inputs.holds.reserve(4);
    membrane.step(state, inputs, dt, scratch, solve());
    const int made = scratch.builds();
    const std::uint64_t allocations = test::allocation_count();
    for (int round = 0; round < 5; ++round) {
        inputs.holds.clear();
        for (std::int32_t v : {30, 31, 0}) {  // the last one is attached: its hold does nothing
            MembraneHold hold;
            hold.vertex = v + round % 2;
            hold.stiffness = 500;
            hold.target = state.positions[static_cast<std::size_t>(hold.vertex)] + Vector3(0, 0, 1e-3);
            inputs.holds.push_back(hold);
        }
        for (int i = 0; i < 4; ++i)
            ASSERT_LE(membrane.step(state, inputs, dt, scratch, solve()).fault, MembraneFault::unconverged);
    }
    inputs.holds.clear();
    for (int i = 0; i < 4; ++i) membrane.step(state, inputs, dt, scratch, solve());
    EXPECT_EQ(test::allocation_count(), allocations);
    EXPECT_EQ(scratch.builds(), made);
    // No trace of the holds remains: a scratch that never had them gives the same step.
    MembraneScratch fresh = membrane.make_scratch(dt);
    MembraneState other = state;
    membrane.step(state, inputs, dt, scratch, solve());
    membrane.step(other, inputs, dt, fresh, solve());
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        EXPECT_LT((state.positions[v] - other.positions[v]).norm(), 1e-10);
}

TEST_P(HeldByJaws, BadHoldsAreRefused) {
    const Membrane membrane(test::sheet(4, 4), tissue(), {0});
    MembraneScratch scratch = membrane.make_scratch(dt);
    for (int broken = 0; broken < 4; ++broken) {
        MembraneState state = membrane.make_state();
        MembraneInputs inputs;
        MembraneHold hold;
        hold.vertex = broken == 0 ? 16 : 5;
        hold.stiffness = broken == 1 ? -1 : 100;
        hold.target = broken == 2 ? Vector3(0, NAN, 0) : Vector3::Zero();
        inputs.holds.assign(broken == 3 ? Membrane::most_holds + 1 : 1, hold);
        EXPECT_EQ(membrane.step(state, inputs, dt, scratch, solve()).fault, MembraneFault::refused) << broken;
        EXPECT_EQ(state.positions, membrane.make_state().positions);
    }
}

// docs/THEORY.md, section 6: removed tissue takes its energy with it and none is created, while the matrix
// follows one edge at a time and lags behind a cut that is larger than the updates of one step.
TEST_P(HeldByJaws, CuttingEveryTriangleAddsNoEnergy) {
    for (const double pre_strain : {0.0, 0.1}) {
        const Membrane membrane(test::sheet(12, 11), tissue(pre_strain), {0, 11, 120, 131});
        MembraneState state = membrane.make_state();
        test::shake(state.velocities, 0.05, 4);
        for (const std::int32_t v : membrane.attached())
            state.velocities[static_cast<std::size_t>(v)].setZero();
        MembraneScratch scratch = membrane.make_scratch(dt);
        MembraneInputs inputs;
        MembraneSolve few;  // as in a world step
        few.integrator = GetParam();
        if (few.integrator == MembraneIntegrator::global_local) few.iterations = 6;
        double energy = membrane.energy(state).elastic() + membrane.energy(state).kinetic;
        const double start = energy;
        double removed = 0;
        const auto& springs = membrane.springs();
        for (std::size_t next = 0; next < springs.size();) {
            for (std::size_t i = 0; i < 25 && next < springs.size(); ++i, ++next) state.cut[next] = 1;
            ++state.topology;
            const double after_cut = membrane.energy(state).elastic() + membrane.energy(state).kinetic;
            ASSERT_LE(after_cut, energy) << "a removed spring takes its stored energy";
            removed += energy - after_cut;
            ASSERT_LT(membrane.step(state, inputs, dt, scratch, few).fault, MembraneFault::refused);
            energy = membrane.energy(state).elastic() + membrane.energy(state).kinetic;
            // Symplectic Euler keeps a neighbour of the energy, bounded as in
            // EnergyDoesNotGrowWithoutASource; six iterations of global-local leave a little of the step
            // undone.
            const double undone = few.integrator == MembraneIntegrator::global_local ? 1e-4 * start : 0;
            const double bound = few.integrator == MembraneIntegrator::symplectic
                                     ? (start - removed) / (1 - 0.98 * 0.98)
                                     : after_cut * (1 + 1e-9) + undone;
            ASSERT_LE(energy, bound) << next;
        }
        EXPECT_EQ(membrane.energy(state).elastic(), 0);
        EXPECT_GT(removed, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Membrane, HeldByJaws,
                         testing::Values(MembraneIntegrator::symplectic, MembraneIntegrator::global_local,
                                         MembraneIntegrator::implicit));

}  // namespace
}  // namespace fulcrum
