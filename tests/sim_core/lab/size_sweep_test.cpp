// SPDX-License-Identifier: Apache-2.0
// Operations against size, counted by the models themselves and so equal on every machine: none grows with an
// exponent above its limit. Times are in docs/results/size_sweep.md, by `fulcrum lab bench --sweep`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "sim_core/lab/size_sweep.h"

namespace fulcrum::lab {
namespace {

SizeSweep counted(const std::vector<SweepCase>& sweeps, const std::string& model, int largest) {
    const auto found = std::find_if(sweeps.begin(), sweeps.end(),
                                    [&](const SweepCase& sweep) { return sweep.model == model; });
    if (found == sweeps.end()) {
        ADD_FAILURE() << "no sweep of " << model;
        return {};
    }
    SizeSweep result = count_sweep(*found, largest);
    for (const SweepPoint& point : result.points) {
        std::printf("%s, %.0f: %.0f operations, %.3f each\n", model.c_str(), point.elements, point.operations,
                    point.operations / point.elements);
        EXPECT_GT(point.operations, 0);
    }
    std::printf("  exponent %.3f\n", result.operation_exponent());
    EXPECT_GE(result.points.size(), 2U);
    EXPECT_LE(result.operation_exponent(), result.exponent_limit) << model;
    return result;
}

TEST(SizeSweep, RodOperationsGrowLinearlyWithSegments) {
    std::vector<SweepCase> sweeps;
    add_rod_sweeps(sweeps);
    ASSERT_EQ(sweeps.size(), 4U);
    for (const SweepCase& sweep : sweeps)
        EXPECT_LE(counted(sweeps, sweep.model, 1024).operation_ratio(), 2) << sweep.model;
}

TEST(SizeSweep, CollisionOperationsGrowAtMostLinearly) {
    std::vector<SweepCase> sweeps;
    add_collision_sweeps(sweeps);
    ASSERT_EQ(sweeps.size(), 2U);
    EXPECT_LE(counted(sweeps, sweeps[0].model, 200).operation_ratio(), 2);
    counted(sweeps, sweeps[1].model, 20480);
}

TEST(SizeSweep, SkinningGrowsLinearlyAndContactTicksDoNotGrow) {
    std::vector<SweepCase> sweeps;
    add_skinning_sweeps(sweeps);
    add_contact_sweeps(sweeps);
    ASSERT_EQ(sweeps.size(), 3U);
    EXPECT_LE(counted(sweeps, sweeps[0].model, 20000).operation_ratio(), 2);
    // A tick skins the vertices of its walk and of the filter's two rings, at any surface resolution.
    EXPECT_LE(counted(sweeps, sweeps[1].model, 126000).operation_exponent(), 0.05);
    counted(sweeps, sweeps[2].model, 40000);
}

TEST(SizeSweep, ExponentsAndRatiosMatchThePoints) {
    SizeSweep sweep;
    sweep.exponent_limit = 1.05;
    sweep.ratio_limit = 2;
    for (const double n : {10.0, 100.0, 1000.0}) sweep.points.push_back({n, 3 * n, 0.2 * n * n});
    EXPECT_NEAR(sweep.operation_exponent(), 1, 1e-12);
    EXPECT_NEAR(sweep.time_exponent(), 2, 1e-12);
    EXPECT_NEAR(sweep.operation_ratio(), 1, 1e-12);
    EXPECT_NEAR(sweep.time_ratio(), 100, 1e-9);
    EXPECT_FALSE(sweep.within());
    for (SweepPoint& point : sweep.points) point.time_us = point.elements;
    EXPECT_TRUE(sweep.within());
}

TEST(SizeSweep, PageHasATablePerSweepAndMarksExceededLimits) {
    int runs = 0;
    SweepCase sweep;
    sweep.model = "squares";
    sweep.element = "vertex";
    sweep.operation = "steps";
    sweep.sizes = {2, 4};
    sweep.prepare = [&runs](int size) {
        SweepRun run;
        run.elements = size;
        run.step = [&runs, size] { runs += size * size; };
        run.operations = [&runs] { return static_cast<double>(runs); };
        return run;
    };
    const SizeSweep counted = count_sweep(sweep, 4);
    ASSERT_EQ(counted.points.size(), 2U);
    EXPECT_EQ(counted.points[0].operations, 4);
    EXPECT_EQ(counted.points[1].operations, 16);
    EXPECT_EQ(count_sweep(sweep, 3).points.size(), 1U);
    const SizeSweep timed = time_sweep(sweep);
    EXPECT_FALSE(timed.within()) << "an exponent of 2";
    const ResultPage page = size_sweep_page({timed});
    const std::string text = page.text(Machine{});
    EXPECT_NE(text.find("**no**"), std::string::npos);
    EXPECT_NE(text.find("## squares"), std::string::npos);
    EXPECT_NE(text.find("| vertices | time, us | time, ns a vertex |"), std::string::npos);
    EXPECT_EQ(to_json({timed})["sweeps"][0]["sizes"][1]["operations"], 16);
}

}  // namespace
}  // namespace fulcrum::lab
