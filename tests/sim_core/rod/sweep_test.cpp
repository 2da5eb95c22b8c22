// SPDX-License-Identifier: Apache-2.0
// Operation counts over 16 to 1024 segments: counted by the solver itself, so the same on every machine.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

struct Count {
    double joints = 0, blocks = 0, systems = 0;
};

// A warm frame (both ends held, a grasp at 50 mm/s) or a cold cantilever at load 10.
Count count(int segments, MaterialLaw law, bool warm) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = 0.4;
    spec.inner_radius = 0;
    spec.law = law;
    spec.ends[0] = warm ? RodEnd::held : RodEnd::clamped;
    spec.ends[1] = warm ? RodEnd::held : RodEnd::free;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    inputs.gravity.z() =
        warm ? -9.81 : -10 * rod.bending_stiffness() / std::pow(0.4, 3) / spec.linear_density;
    Count sum;
    RodReport report = rod.solve(state, inputs, scratch);
    EXPECT_TRUE(report.converged) << segments;
    sum.systems = report.iterations;
    const int frames = 40;
    if (warm) {
        RodGrasp grasp;
        grasp.s = 0.2;
        grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
        inputs.grasps.push_back(grasp);
        scratch.data().joint_evaluations = scratch.data().block_factors = 0;
        sum.systems = 0;
        for (int i = 0; i < frames; ++i) {
            inputs.grasps[0].target += 0.00025 * Vector3(0, 0.6, 0.8);
            report = rod.solve(state, inputs, scratch);
            EXPECT_TRUE(report.converged) << segments << " " << i;
            sum.systems += report.iterations;
        }
    }
    const double share = warm ? 1.0 / frames : 1.0;
    sum.joints = share * static_cast<double>(scratch.data().joint_evaluations);
    sum.blocks = share * static_cast<double>(scratch.data().block_factors);
    sum.systems *= share;
    return sum;
}

TEST(RodSweep, OperationsGrowLinearlyFromSixteenToAThousandSegments) {
    for (const bool warm : {true, false}) {
        for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::exp2}) {
            double sx = 0, sy = 0, sxx = 0, sxy = 0, least = 1e300, most = 0;
            int sizes = 0;
            for (int segments = 16; segments <= 1024; segments *= 2, ++sizes) {
                const Count c = count(segments, law, warm);
                const double work = c.joints + c.blocks, each = work / segments;
                std::printf(
                    "%s %s %4d segments: %.2f systems, %.0f joints, %.0f block rows, %.2f a segment\n",
                    warm ? "warm" : "cold", law == MaterialLaw::linear ? "linear" : "EXP2", segments,
                    c.systems, c.joints, c.blocks, each);
                const double x = std::log(segments), y = std::log(work);
                sx += x, sy += y, sxx += x * x, sxy += x * y;
                least = std::min(least, each);
                most = std::max(most, each);
            }
            const double exponent = (sizes * sxy - sx * sy) / (sizes * sxx - sx * sx);
            std::printf("  exponent %.3f\n", exponent);
            EXPECT_LE(exponent, 1.05);
            EXPECT_LE(most / least, 2);
        }
    }
}

}  // namespace
}  // namespace fulcrum
