// SPDX-License-Identifier: Apache-2.0
// The stability limit, the solvers against each other, and cutting.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "sim_core/membrane/membrane.h"
#include "sim_core/numerics/input_error.h"
#include "tests/sim_core/membrane/sheets.h"

namespace fulcrum {
namespace {

// Highest frequency from the dense tangent.
double highest(const Membrane& membrane, const MembraneState& state) {
    const auto n = static_cast<std::size_t>(membrane.vertices());
    std::vector<std::uint8_t> held(n, 0);
    for (const std::int32_t v : membrane.attached()) held[static_cast<std::size_t>(v)] = 1;
    Eigen::MatrixXd tangent(3 * n, 3 * n);
    std::vector<Vector3> unit(n), product;
    for (std::size_t i = 0; i < 3 * n; ++i) {
        std::fill(unit.begin(), unit.end(), Vector3::Zero());
        unit[i / 3][static_cast<int>(i % 3)] = 1;
        membrane.tangent_times(state, unit, product);
        for (std::size_t j = 0; j < 3 * n; ++j) {
            const bool away = held[i / 3] != 0 || held[j / 3] != 0;
            tangent(static_cast<int>(j), static_cast<int>(i)) =
                away ? 0
                     : product[j / 3][static_cast<int>(j % 3)] /
                           std::sqrt(membrane.masses()[i / 3] * membrane.masses()[j / 3]);
        }
    }
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(tangent, Eigen::EigenvaluesOnly)
                         .eigenvalues()
                         .maxCoeff());
}

TEST(MembraneLimit, IsWithinTheStatedFactorOfTheTrueFrequency) {
    for (int trial = 0; trial < 6; ++trial) {
        TriangleMesh mesh = test::sheet(7, 6);
        if (trial % 2 == 1) test::shake(mesh.vertices, 0.003, static_cast<std::uint64_t>(trial));
        MembraneMaterial material;
        material.pre_strain = 0.03 * trial;
        material.stiffness_damping = trial > 2 ? 1e-4 : 0;
        const Membrane membrane(
            mesh, material,
            trial % 3 == 0 ? std::vector<std::int32_t>{} : std::vector<std::int32_t>{0, 6, 20});
        const MembraneState state = membrane.make_state();
        MembraneScratch scratch = membrane.make_scratch();
        const MembraneLimit limit = membrane.limit(state, scratch);
        const double exact = highest(membrane, state);
        EXPECT_LE(limit.frequency, exact * (1 + 1e-9));
        EXPECT_GE(limit.frequency, 0.99 * exact);
        EXPECT_GE(limit.safe_frequency, exact);
        EXPECT_LE(limit.safe_frequency, 2 * exact);
        const double z = limit.damping_ratio;
        EXPECT_NEAR(z, 0.5 * material.stiffness_damping * limit.frequency, 1e-12);
        EXPECT_NEAR(limit.time_step, 2 / limit.frequency * (std::sqrt(1 + z * z) - z), 1e-15);
        EXPECT_LE(limit.safe_time_step, limit.time_step);
    }
}

TEST(MembraneLimit, IsTheLimitAtWhichSymplecticEulerDiverges) {
    // One spring between two masses: 2/w (sqrt(1 + z^2) - z), checked by running undivided steps just below
    // and above it.
    TriangleMesh mesh = test::sheet(2, 2);
    MembraneMaterial material;
    material.stiffness_damping = 1e-4;
    const Membrane membrane(mesh, material, {});
    MembraneScratch scratch = membrane.make_scratch();
    const MembraneLimit limit = membrane.limit(membrane.make_state(), scratch);
    for (const double share : {0.5, 0.97, 1.5, 40.0}) {
        MembraneState state = membrane.make_state();
        test::shake(state.positions, 1e-5, 1);
        MembraneInputs inputs;
        MembraneSolve solve;
        solve.integrator = MembraneIntegrator::symplectic;
        const double start = membrane.energy(state).elastic();
        MembraneReport report;
        for (int i = 0; i < 400; ++i)
            report = membrane.step(state, inputs, share * limit.time_step, scratch, solve);
        EXPECT_LT(membrane.energy(state).elastic() + membrane.energy(state).kinetic, start) << share;
        EXPECT_EQ(report.fault == MembraneFault::substepped, report.substeps > 1);
        EXPECT_GE(report.substeps * limit.safe_time_step, share * limit.time_step) << "never above the limit";
    }
    MembraneState state = membrane.make_state();
    MembraneInputs inputs;
    MembraneSolve solve;
    solve.integrator = MembraneIntegrator::symplectic;
    solve.most_substeps = 3;
    const auto before = state.positions;
    EXPECT_EQ(membrane.step(state, inputs, 20 * limit.time_step, scratch, solve).fault,
              MembraneFault::refused);
    EXPECT_EQ(state.positions, before);
}

struct Hung {
    Membrane membrane;
    MembraneInputs inputs;
    explicit Hung(int size, double pre_strain = 0)
        : membrane(test::sheet(size, size), material(pre_strain), edges(size)) {
        inputs.gravity = Vector3(0, 0, -9.81);
        inputs.reactions.resize(membrane.attached().size());
    }
    static MembraneMaterial material(double pre_strain) {
        MembraneMaterial m;
        m.pre_strain = pre_strain;
        return m;
    }
    static std::vector<std::int32_t> edges(int size) {
        std::vector<std::int32_t> held;
        for (int r = 0; r < size; ++r) {
            held.push_back(r * size);
            held.push_back(r * size + size - 1);
        }
        return held;
    }
};

TEST(MembraneSolve, StaticSolversAgreeAndSupportsCarryTheWeight) {
    Hung hung(20);
    MembraneScratch scratch = hung.membrane.make_scratch();
    MembraneState start = hung.membrane.make_state(), exact = start, quick = start;
    MembraneSolve implicit, local;
    implicit.integrator = MembraneIntegrator::implicit;
    local.iterations = 15;
    const MembraneReport reference = hung.membrane.solve(exact, hung.inputs, scratch, implicit);
    EXPECT_TRUE(reference.converged);
    EXPECT_LE(reference.residual, 1e-10);
    Vector3 sum = Vector3::Zero();
    for (const Vector3& r : hung.inputs.reactions) sum += r;
    EXPECT_LT((sum + hung.membrane.material().mass * hung.inputs.gravity).norm(), 1e-9);
    const double before = hung.membrane.incremental_potential(start, start, hung.inputs, 0, scratch);
    const double least = hung.membrane.incremental_potential(start, exact, hung.inputs, 0, scratch);
    hung.membrane.solve(quick, hung.inputs, scratch, local);
    EXPECT_LT(hung.membrane.incremental_potential(start, quick, hung.inputs, 0, scratch) - least,
              0.01 * (before - least));
}

TEST(MembraneSolve, GlobalLocalFrameIsWithinOnePercentOfImplicit) {
    Hung hung(24, 0.03);
    MembraneScratch scratch = hung.membrane.make_scratch(0.005);
    MembraneState state = hung.membrane.make_state();
    MembraneSolve implicit, local;
    implicit.integrator = MembraneIntegrator::implicit;
    local.iterations = 8;
    hung.membrane.solve(state, hung.inputs, scratch, implicit);
    for (const std::int32_t v : hung.membrane.attached())
        hung.inputs.attachments.push_back(state.positions[static_cast<std::size_t>(v)]);
    for (int frame = 0; frame < 10; ++frame) {
        for (std::size_t a = 1; a < hung.inputs.attachments.size(); a += 2)
            hung.inputs.attachments[a] += Vector3(0, 1e-4, 2e-4);
        MembraneState exact = state, quick = state, held = state;
        ASSERT_TRUE(hung.membrane.step(exact, hung.inputs, 0.005, scratch, implicit).converged);
        hung.membrane.step(quick, hung.inputs, 0.005, scratch, local);
        for (std::size_t a = 0; a < hung.inputs.attachments.size(); ++a)
            held.positions[static_cast<std::size_t>(hung.membrane.attached()[a])] =
                hung.inputs.attachments[a];
        const auto value = [&](const MembraneState& end) {
            return hung.membrane.incremental_potential(state, end, hung.inputs, 0.005, scratch);
        };
        if (frame > 2) {
            EXPECT_LT(value(quick) - value(exact), 0.01 * (value(held) - value(exact))) << frame;
        }
        state = exact;
    }
}

TEST(MembraneSolve, FourIterationsSufficeInEveryFrameAfterASuddenStart) {
    // An edge starts at 50 mm/s from rest and continues on a circle.
    lab::HeldSheet sheet(24);
    const Membrane& membrane = sheet.membrane;
    MembraneState state = membrane.make_state();
    MembraneSolve implicit, local;
    implicit.integrator = MembraneIntegrator::implicit;
    MembraneScratch scratch = membrane.make_scratch(0);
    ASSERT_TRUE(membrane.solve(state, sheet.inputs, scratch, implicit).converged);
    scratch = membrane.make_scratch(0.005);
    local.iterations = 4;
    for (int frame = 1; frame <= 460; ++frame) {
        sheet.move_edge(frame);
        if (frame > 20 && frame % 40 != 0) {  // errors of the start must not accumulate
            membrane.step(state, sheet.inputs, 0.005, scratch, local);
            continue;
        }
        const MembraneState start = state;
        MembraneState exact = start;
        ASSERT_TRUE(membrane.step(exact, sheet.inputs, 0.005, scratch, implicit).converged);
        membrane.step(state, sheet.inputs, 0.005, scratch, local);
        EXPECT_LT(lab::energy_gap(membrane, start, state, exact, sheet.inputs, 0.005, scratch), 0.01)
            << frame;
    }
}

TEST(MembraneSolve, PreStrainMakesACutGape) {
    Hung hung(21, 0.15);
    hung.inputs.gravity.setZero();
    MembraneState state = hung.membrane.make_state();
    MembraneScratch scratch = hung.membrane.make_scratch(0.005);
    const int built = scratch.builds();
    // Every spring across the line x = 0.0525 between y = 0.03 and 0.07 is cut: its ends must move apart.
    const auto& springs = hung.membrane.springs();
    const auto at = [&](std::int32_t v) {
        return hung.membrane.make_state().positions[static_cast<std::size_t>(v)];
    };
    for (std::size_t s = 0; s < springs.size(); ++s) {
        const Vector3 a = at(springs[s].first), b = at(springs[s].second);
        const double y = 0.5 * (a.y() + b.y());
        if ((a.x() - 0.0525) * (b.x() - 0.0525) < 0 && y > 0.03 && y < 0.07) state.cut[s] = 1;
    }
    ++state.topology;
    MembraneSolve solve;
    solve.iterations = 20;
    for (int i = 0; i < 200; ++i)
        ASSERT_LT(hung.membrane.step(state, hung.inputs, 0.005, scratch, solve).fault,
                  MembraneFault::refused);
    EXPECT_EQ(scratch.builds(), built) << "the matrix follows by updates, without a stall";
    EXPECT_GT(scratch.updates(), 20);
    const std::size_t left = 10 * 21 + 10, right = left + 1;
    EXPECT_GT((state.positions[right] - state.positions[left]).norm(), 0.0075) << "5 mm before";
    // The updated matrix performs like one built with the cut.
    MembraneState other = state;
    MembraneScratch fresh = hung.membrane.make_scratch(0.004);
    hung.membrane.step(state, hung.inputs, 0.005, scratch, solve);
    hung.membrane.step(other, hung.inputs, 0.005, fresh, solve);
    double difference = 0;
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        difference = std::max(difference, (state.positions[v] - other.positions[v]).norm());
    EXPECT_LT(difference, 1e-9);
}

TEST(MembraneSolve, BadInputIsReported) {
    TriangleMesh mesh = test::sheet(3, 3);
    EXPECT_THROW(Membrane(mesh, MembraneMaterial(), {9}), InputError);
    EXPECT_THROW(Membrane(mesh, MembraneMaterial(), {1, 1}), InputError);
    MembraneMaterial material;
    material.mass = 0;
    EXPECT_THROW(Membrane(mesh, material, {}), InputError);
    material = {};
    material.shear_stiffness = std::nan("");
    EXPECT_THROW(Membrane(mesh, material, {}), InputError);
    mesh.triangles[0] = {0, 0, 1};
    EXPECT_THROW(Membrane(mesh, MembraneMaterial(), {}), InputError);
    mesh.triangles[0] = {0, 1, 12};
    EXPECT_THROW(Membrane(mesh, MembraneMaterial(), {}), InputError);
}

}  // namespace
}  // namespace fulcrum
