// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for membranes: for any input the output is finite, and failures are
// reported. Part of the cases run with the suite; FULCRUM_CASES=N runs N of them (2,500 in about a minute).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/membrane/membrane.h"
#include "sim_core/numerics/input_error.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

using test::between;

TriangleMesh extreme_mesh(Random& random) {
    const auto kind = random.below(6);
    TriangleMesh mesh =
        test::sheet(static_cast<int>(2 + random.below(9)), static_cast<int>(2 + random.below(9)));
    if (kind == 0) {  // one triangle
        mesh.vertices = {Vector3(0, 0, 0), Vector3(0.01, 0, 0), Vector3(0.002, 0.01, 0)};
        mesh.triangles = {{0, 1, 2}};
    } else if (kind == 1) {  // slivers of aspect 1e6
        for (Vector3& p : mesh.vertices) p.y() *= 1e-6;
    } else if (kind == 2) {  // coincident vertices, zero-length edges
        for (int i = 0; i < 3; ++i)
            mesh.vertices[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))] = mesh.vertices[0];
    } else if (kind == 3) {  // everything in one point
        for (Vector3& p : mesh.vertices) p = Vector3(0.1, 0.2, 0.3);
    } else if (kind == 4) {
        test::shake(mesh.vertices, 0.02, random.bits());
    }
    return mesh;
}

TEST(MembraneExtremes, StepsStayFiniteAndReportFaults) {
    const int cases = test::cases_asked();
    int steps = 0, substepped = 0, unconverged = 0, refused = 0, frozen = 0;
    for (int number = 0; number < cases; ++number) {
        Random random(static_cast<std::uint64_t>(number), 77);
        const TriangleMesh mesh = extreme_mesh(random);
        MembraneMaterial material;
        // A sheet 1 mm thick of Young's modulus 1 Pa to 1 GPa has springs of about E t.
        material.structural_stiffness = between(random, 1, 1e9) * 1e-3;
        material.shear_stiffness = random.below(4) == 0 ? 0 : 0.5 * material.structural_stiffness;
        material.bend_stiffness = random.below(4) == 0 ? 0 : 0.05 * material.structural_stiffness;
        material.mass = between(random, 1e-5, 1);
        material.pre_strain = random.below(3) == 0 ? random.uniform(-0.4, 0.8) : 0;
        material.stiffness_damping = random.below(2) == 0 ? 0 : between(random, 1e-6, 1e-1);
        std::vector<std::int32_t> attached;
        for (std::uint32_t k = random.below(3); k > 0; --k) {
            const auto v =
                static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(mesh.vertices.size())));
            if (std::find(attached.begin(), attached.end(), v) == attached.end()) attached.push_back(v);
        }
        const Membrane membrane(mesh, material, attached);
        const double dt = between(random, 5e-5, 5e-2);
        MembraneScratch scratch = membrane.make_scratch(dt);
        MembraneState state = membrane.make_state();
        MembraneInputs inputs;
        inputs.gravity = Vector3(0, 0, -9.81);
        inputs.reactions.resize(attached.size());
        for (const std::int32_t v : attached)
            inputs.attachments.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
        MembraneSolve solve;
        solve.integrator = static_cast<MembraneIntegrator>(random.below(3));
        solve.iterations = solve.integrator == MembraneIntegrator::implicit ? 15 : 0;
        const auto event = random.below(8);
        for (int i = 0; i < 6; ++i, ++steps) {
            if (i == 2) {
                const double bad[] = {std::nan(""), INFINITY, -INFINITY, 1e300};
                if (event == 0) inputs.forces.assign(mesh.vertices.size(), Vector3(1000, -1000, 1000));
                if (event == 1) inputs.gravity.y() = bad[random.below(4)];
                if (event == 2 && !attached.empty())
                    inputs.attachments[0] += Vector3(1, 0, 0);  // 1 m in one step
                if (event == 3 && !attached.empty()) inputs.attachments[0].z() = bad[random.below(4)];
                if (event == 4) {
                    inputs.forces.assign(mesh.vertices.size(), Vector3::Zero());
                    inputs.forces[random.below(static_cast<std::uint32_t>(mesh.vertices.size()))].x() =
                        bad[random.below(4)];
                }
                if (event == 5) {  // everything is cut
                    std::fill(state.cut.begin(), state.cut.end(), std::uint8_t{1});
                    ++state.topology;
                }
                if (event == 6) test::shake(state.velocities, 10, random.bits());
            }
            const std::vector<Vector3> before = state.positions;
            const MembraneReport report = membrane.step(state, inputs, dt, scratch, solve);
            ASSERT_TRUE(Membrane::finite(state)) << "case " << number << " step " << i;
            for (const Vector3& r : inputs.reactions) ASSERT_TRUE(r.allFinite()) << "case " << number;
            ASSERT_TRUE(std::isfinite(report.residual) && std::isfinite(report.energy) &&
                        std::isfinite(report.potential))
                << "case " << number;
            const bool input_bad = i >= 2 && (event == 1 || event == 4 || (event == 3 && !attached.empty()));
            if (input_bad) {
                ASSERT_GE(report.fault, MembraneFault::refused)
                    << "case " << number << ": bad input must be reported";
            }
            if (report.fault >= MembraneFault::refused) {
                ASSERT_EQ(state.positions, before) << "case " << number << ": a refused step changes nothing";
                ASSERT_FALSE(report.converged);
            }
            substepped += report.fault == MembraneFault::substepped ? 1 : 0;
            unconverged += report.fault == MembraneFault::unconverged ? 1 : 0;
            refused += report.fault == MembraneFault::refused ? 1 : 0;
            frozen += report.fault == MembraneFault::frozen ? 1 : 0;
        }
    }
    std::printf("%d cases, %d steps: %d substepped, %d unconverged, %d refused, %d frozen\n", cases, steps,
                substepped, unconverged, refused, frozen);
    EXPECT_GT(refused, 0);
    EXPECT_GT(substepped, 0);
    EXPECT_LT(frozen, steps / 10) << "freezing must be rare";
}

// Without a source of energy the energy must not grow, at any stiffness and time step.
TEST(MembraneExtremes, EnergyDoesNotGrowWithoutASource) {
    for (int number = 0; number < 60; ++number) {
        Random random(static_cast<std::uint64_t>(number), 78);
        MembraneMaterial material;
        material.structural_stiffness = between(random, 1e-2, 1e5);
        material.shear_stiffness = 0.5 * material.structural_stiffness;
        material.bend_stiffness = 0.05 * material.structural_stiffness;
        const Membrane membrane(test::sheet(7, 6), material, {0, 6});
        const double dt = between(random, 5e-5, 5e-2);
        MembraneScratch scratch = membrane.make_scratch(dt);
        MembraneState state = membrane.make_state();
        // Small enough that no spring collapses: a collapsed spring has an unbounded tangent, and theory
        // gives no bound for symplectic Euler.
        test::shake(state.positions, 0.001, random.bits());
        state.positions[0] = membrane.make_state().positions[0];
        state.positions[6] = membrane.make_state().positions[6];
        MembraneInputs inputs;
        MembraneSolve solve;
        solve.integrator = static_cast<MembraneIntegrator>(number % 3);
        const MembraneEnergy start = membrane.energy(state);
        for (int i = 0; i < 40; ++i) {
            const MembraneReport report = membrane.step(state, inputs, dt, scratch, solve);
            if (report.fault >= MembraneFault::refused) break;
            const MembraneEnergy now = membrane.energy(state);
            // The others lose; symplectic Euler keeps E - (h w / 2)^2 of it a mode, so that with h <= 0.98 of
            // the limit the energy itself stays below 1 / (1 - 0.98^2) of the start's.
            const double bound =
                solve.integrator == MembraneIntegrator::symplectic ? 1 / (1 - 0.98 * 0.98) : 1.0 + 1e-9;
            ASSERT_LE(now.elastic() + now.kinetic, bound * start.elastic())
                << number << " " << name_of(report.fault);
        }
    }
}

}  // namespace
}  // namespace fulcrum
