// SPDX-License-Identifier: Apache-2.0
// `lab run` for a membrane, and its reference workloads' errors on small sheets.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/geometry/mesh_file.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/membrane_study.h"
#include "sim_core/lab/membrane_tradeoff.h"
#include "sim_core/lab/studies.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

class MembraneStudy : public ::testing::Test {
  protected:
    void SetUp() override {
        std::ofstream sheet(folder_ / "sheet.obj"), triangle(folder_ / "triangle.obj");
        write_obj(sheet, test::sheet(9, 9));
        TriangleMesh one;
        one.vertices = {Vector3(0, 0, 0), Vector3(0.01, 0, 0), Vector3(0, 0.01, 0)};
        one.triangles = {{0, 1, 2}};
        write_obj(triangle, one);
    }
    nlohmann::json run(const nlohmann::json& change) const {
        nlohmann::json keys = {{"model", "membrane"},
                               {"mesh", "sheet.obj"},
                               {"fixed", {0, 8}},
                               {"stiffness_n_m", 50},
                               {"damping", 0.2},
                               {"mass_kg", 0.01},
                               {"gravity", {0, 0, -9.81}},
                               {"integrator", "implicit"},
                               {"dt_s", 0.001},
                               {"steps", 20}};
        keys.update(change);
        std::ofstream(folder_ / "study.json") << keys.dump();
        return lab::run_study((folder_ / "study.json").string());
    }
    test::OwnFolder folder_;
};

TEST_F(MembraneStudy, IntegratorsConvergeForSmallSteps) {
    nlohmann::json results[3];
    const char* names[] = {"symplectic", "global_local", "implicit"};
    for (int i = 0; i < 3; ++i) {
        results[i] = run({{"integrator", names[i]}, {"dt_s", 1e-4}, {"steps", 300}});
        EXPECT_TRUE(results[i]["finite"].get<bool>());
        ASSERT_EQ(results[i]["vertices"].size(), 81U);
        EXPECT_GT(results[i]["time_us_per_step"].get<double>(), 0);
        EXPECT_GT(results[i]["dt_limit_s"].get<double>(), results[i]["dt_safe_s"].get<double>());
        EXPECT_NEAR(results[i]["damping_ratio"].get<double>(), 0.2, 1e-9);
    }
    const auto z = [&](int i) { return results[i]["vertices"][76][2].get<double>(); };
    EXPECT_LT(z(2), -0.001);
    EXPECT_NEAR(z(0), z(2), 0.02 * std::abs(z(2)));
    EXPECT_NEAR(z(1), z(2), 0.02 * std::abs(z(2)));
}

TEST_F(MembraneStudy, SingleTriangleHasTheClosedFormLimit) {
    const auto result = run({{"mesh", "triangle.obj"}, {"fixed", {0, 2}}, {"damping", 0.0}});
    // Only vertex 1 moves: springs to 0 (along x) and to 2 (along the diagonal), k sum n n^T = k ((1.5,
    // -0.5), (-0.5, 0.5)).
    const double k = 50, m = 0.01 / 3, a = k * 1.5, b = k * 0.5, c = k * 0.5;
    const double top = 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
    EXPECT_NEAR(result["dt_limit_s"].get<double>(), 2 / std::sqrt(top / m), 1e-9);
    EXPECT_EQ(result["springs"]["structural"], 3);
    EXPECT_EQ(result["springs"]["bend"], 0);
}

TEST_F(MembraneStudy, StepAboveTheLimitIsDividedAndReported) {
    const auto result = run({{"integrator", "symplectic"}, {"stiffness_n_m", 1e4}, {"dt_s", 0.005}});
    EXPECT_TRUE(result["finite"].get<bool>());
    EXPECT_LT(result["dt_limit_s"].get<double>(), 0.005);
    EXPECT_GT(result["substeps"].get<int>(), 1);
    EXPECT_EQ(result["fault"], "substepped");
    const auto refused =
        run({{"integrator", "symplectic"}, {"stiffness_n_m", 1e12}, {"dt_s", 0.05}, {"steps", 3}});
    EXPECT_EQ(refused["fault"], "refused");
    EXPECT_EQ(refused["faults"]["refused"], 3);
    EXPECT_TRUE(refused["finite"].get<bool>());
}

TEST_F(MembraneStudy, StaticSolveMatchesDampedSteps) {
    const auto still = run({{"steps", 0}});
    const auto stepped = run({{"steps", 400}, {"dt_s", 0.02}, {"damping", 5.0}});
    EXPECT_NEAR(still["energy_j"].get<double>(), stepped["energy_j"].get<double>(),
                1e-3 * std::abs(still["energy_j"].get<double>()));
    EXPECT_LE(still["residual"].get<double>(), 1e-10);
}

TEST_F(MembraneStudy, InvalidKeysAreReported) {
    for (const nlohmann::json& change : {nlohmann::json{{"fixed", {81}}},
                                         {{"fixed", "all"}},
                                         {{"fixed", {1, 1}}},
                                         {{"stiffness_n_m", -1}},
                                         {{"mass_kg", 0}},
                                         {{"integrator", "euler"}},
                                         {{"steps", 1.5}},
                                         {{"dt_s", 0}},
                                         {{"gravity", {1, 2}}},
                                         {{"mesh", "none.obj"}},
                                         {{"steps", 0}, {"fixed", nlohmann::json::array()}}}) {
        EXPECT_THROW(run(change), InputError) << change.dump();
    }
}

TEST(MembraneSlivers, AreSteppedBelowTheirLimitAndReportedAboveIt) {
    const lab::StabilityMap map = lab::membrane_sliver_map();
    ASSERT_EQ(map.cells.size(), map.axes[0].values.size() * map.axes[1].values.size());
    int divided = 0, refused = 0;
    for (const lab::StabilityCell& cell : map.cells) {
        EXPECT_TRUE(cell.finite && std::isfinite(cell.measure));
        for (std::size_t k = 0; k < map.theory[0].y.size(); ++k) {
            if (map.theory[0].y[k] != cell.at[1]) continue;
            // Divided above the limit; the enforced bound is up to two times below it.
            if (cell.at[0] > map.theory[0].x[k]) {
                EXPECT_NE(cell.outcome, lab::StabilityOutcome::stable) << cell.at[0] << ", " << cell.at[1];
            } else if (cell.at[0] < 0.45 * map.theory[0].x[k]) {
                EXPECT_EQ(cell.outcome, lab::StabilityOutcome::stable) << cell.at[0] << ", " << cell.at[1];
            }
        }
        divided += cell.outcome == lab::StabilityOutcome::degraded ? 1 : 0;
        refused += cell.outcome == lab::StabilityOutcome::fault ? 1 : 0;
    }
    EXPECT_GT(divided, 0);
    EXPECT_GT(refused, 0);
}

TEST(MembraneSweep, OperationsGrowLinearlyWithTheNodes) {
    const lab::HeldSheet small(22), large(224);
    const MembraneScratch::Operations few = small.membrane.make_scratch().operations(),
                                      many = large.membrane.make_scratch().operations();
    const auto exponent = [](std::int64_t a, std::int64_t b, double times) {
        return std::log(static_cast<double>(b) / static_cast<double>(a)) / std::log(times);
    };
    const double times = static_cast<double>(large.membrane.vertices()) / small.membrane.vertices();
    EXPECT_LE(exponent(few.springs, many.springs, times), 1.05);
    EXPECT_LE(exponent(few.solve, many.solve, times), 1.05);
    // A frame: the ratio of cycles to spring evaluations does not depend on the size.
    EXPECT_LE(exponent(few.solve + few.springs, many.solve + many.springs, times), 1.05);
    // Built once, for the nodes that are not held: the small sheet has fewer of those.
    const auto free = [](const Membrane& m) { return m.vertices() - static_cast<int>(m.attached().size()); };
    EXPECT_LE(
        exponent(few.build, many.build, static_cast<double>(free(large.membrane)) / free(small.membrane)),
        1.05);
}

TEST(MembraneSweep, SameIterationsSufficeForEverySize) {
    // What keeps the work of a solve in step with the nodes: 10 iterations to 1 %, coarse and fine.
    for (const int side : {16, 32, 64}) {
        lab::HeldSheet sheet(side);
        MembraneScratch scratch = sheet.membrane.make_scratch(0);
        const MembraneState start = sheet.membrane.make_state();
        MembraneState exact = start, quick = start;
        MembraneSolve implicit, local;
        implicit.integrator = MembraneIntegrator::implicit;
        local.iterations = 10;
        ASSERT_TRUE(sheet.membrane.solve(exact, sheet.inputs, scratch, implicit).converged);
        sheet.membrane.solve(quick, sheet.inputs, scratch, local);
        EXPECT_LT(lab::energy_gap(sheet.membrane, start, quick, exact, sheet.inputs, 0, scratch), 0.01)
            << side;
    }
}

TEST(MembraneWorkloads, AreRegisteredWithTheirBudgets) {
    std::vector<lab::Workload> workloads;
    lab::add_membrane_workloads(workloads);
    ASSERT_EQ(workloads.size(), 4U);
    EXPECT_EQ(workloads[3].name, "membrane_frame");
    const auto prepared = workloads[0].prepare();
    prepared.between();
    prepared.step();
    const auto error = prepared.error();
    ASSERT_TRUE(error.has_value());
    EXPECT_LT(*error, 0.01);
    EXPECT_GT(*error, 0.0);
}

}  // namespace
}  // namespace fulcrum
