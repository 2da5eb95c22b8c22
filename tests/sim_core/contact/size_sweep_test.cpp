// SPDX-License-Identifier: Apache-2.0
// Work of skinning and contact against the surface's size, counted, so that it is the same on every machine:
// skinning grows no faster than vertices, a tick of contact no faster than what fits under a tool.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "sim_core/bowel/display_skin.h"
#include "sim_core/lab/contact_run.h"

namespace fulcrum::lab {
namespace {

struct Work {
    double triangles = 0, vertices = 0;
    double rows = 0;        ///< bytes that drawing the whole surface once reads
    double skinned = 0;     ///< vertices skinned in a tick of contact
    double candidates = 0;  ///< vertices skinned in building a patch
    double touched = 0;     ///< share of the ticks
};

Work work_of(int triangles) {
    const auto run = build_contact_run_of(triangles);
    Work work;
    work.triangles = static_cast<double>(run->skin->rest().triangles.size());
    work.vertices = run->skin->vertices();
    work.rows = static_cast<double>(DisplaySkin(*run->skin).bytes());
    constexpr int ticks = 200;
    for (int i = 0; i < ticks; ++i) {
        run->prepare_tick(0);
        run->touch();
        for (const std::uint32_t stamp : run->tick_scratch.position_stamp)
            work.skinned += stamp == run->tick_scratch.stamp ? 1.0 / ticks : 0.0;
        work.candidates += static_cast<double>(run->scratch.found.size()) / ticks;
        work.touched += run->result.touching_surface ? 1.0 / ticks : 0.0;
    }
    return work;
}

double exponent(double small, double large, double times) {
    return std::log(large / small) / std::log(times);
}

TEST(SurfaceSize, SkinningGrowsWithVerticesAndATickOfContactWithWhatIsUnderTheTool) {
    std::vector<Work> sweep;
    for (const int triangles : {4000, 12600, 40000, 126000}) {
        sweep.push_back(work_of(triangles));
        const Work& work = sweep.back();
        std::printf(
            "%.0f triangles: %.0f bytes of rows, %.0f a vertex; %.1f vertices skinned a tick, %.0f a patch, "
            "touching %.2f\n",
            work.triangles, work.rows, work.rows / work.vertices, work.skinned, work.candidates,
            work.touched);
        EXPECT_GT(work.touched, 0.5);
    }
    const Work &small = sweep.front(), &large = sweep.back();
    const double times = large.vertices / small.vertices;
    std::printf("exponents: skinning %.3f, tick %.3f, patch %.3f\n", exponent(small.rows, large.rows, times),
                exponent(small.skinned, large.skinned, times),
                exponent(small.candidates, large.candidates, times));
    EXPECT_LE(exponent(small.rows, large.rows, times), 1.05);
    EXPECT_LE(large.rows / large.vertices, 2 * small.rows / small.vertices);
    EXPECT_LE(exponent(small.candidates, large.candidates, times), 1.05);
    // A tick skins what its walk and the filter's two rings look at, however fine the rest is.
    EXPECT_LE(exponent(small.skinned, large.skinned, times), 0.05);
}

}  // namespace
}  // namespace fulcrum::lab
