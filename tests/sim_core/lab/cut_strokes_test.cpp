// SPDX-License-Identifier: Apache-2.0
// Random strokes on sphere, tube, sheet and bowel, at rest and deforming: every step is validated where it
// touched, and the whole surface after every tenth stroke. 5,000 strokes; FULCRUM_STROKES=N runs N (`fulcrum
// lab strokes N` prints the results).
#include "sim_core/lab/cut_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace fulcrum {
namespace {

int strokes_asked() {
    const char* text = std::getenv("FULCRUM_STROKES");
    return text != nullptr ? std::atoi(text) : 5000;
}

TEST(CutStrokes, KeepEveryInvariant) {
    const int each = std::max(1, strokes_asked() / 8);
    lab::StrokeTally all;
    for (const lab::StrokeSurface& surface : lab::stroke_surfaces())
        for (const bool deform : {false, true}) {
            const lab::StrokeTally tally = lab::run_strokes(surface.mesh, deform, each, deform ? 11 : 7);
            EXPECT_EQ(tally.violations, 0) << surface.name << ", " << tally.complaint;
            EXPECT_EQ(tally.strokes, each);
            EXPECT_GT(tally.cuts, tally.steps / 2);
            EXPECT_EQ(tally.full, 0);
            EXPECT_LE(tally.area_error, 1e-9);
            all.add(tally);
        }
    EXPECT_LT(all.roll_backs, 0.001 * all.steps) << all.roll_backs << " of " << all.steps << " steps";
}

}  // namespace
}  // namespace fulcrum
