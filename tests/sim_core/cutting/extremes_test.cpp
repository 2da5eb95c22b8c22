// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for cuts: for any mesh and blade, every invariant holds after each step and
// whatever could not be cut is reported. FULCRUM_CASES=N runs N / 200 meshes of each stress case.
#include <gtest/gtest.h>

#include "sim_core/lab/cut_strokes.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/cutting/surfaces.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

using test::cut_sheet;
using test::Surface;

TEST(CutExtremes, AllInvariantsHoldForAnyInput) {
    const int meshes = std::max(1, test::cases_asked() / 200);
    lab::StrokeTally all;
    const std::vector<std::string> names = lab::stress_names();
    for (std::size_t which = 0; which < names.size(); ++which) {
        lab::StrokeTally tally;
        for (int i = 0; i < meshes; ++i) lab::run_stress(which, static_cast<std::uint64_t>(i), tally);
        EXPECT_EQ(tally.violations, 0) << tally.complaint;
        EXPECT_EQ(tally.full, 0) << names[which];
        EXPECT_GT(tally.cuts, 0) << names[which];
        EXPECT_LE(tally.area_error, 1e-9) << names[which];
        all.add(tally);
    }
    EXPECT_GT(all.refused, 0);
    EXPECT_GT(all.widened, 0);
    EXPECT_GT(all.flat, 0);
    EXPECT_LT(all.roll_backs, 0.001 * all.steps) << all.roll_backs << " of " << all.steps << " steps";
    EXPECT_EQ(all.uncut, 0);
}

TEST(CutExtremes, RolledBackCutSucceedsOnALaterAttempt) {
    // The one in about 50,000 steps of the stress cases whose first attempt leaves a part without area.
    lab::StrokeTally tally;
    lab::run_stress(4, 862, tally);
    EXPECT_EQ(tally.violations, 0) << tally.complaint;
    EXPECT_GT(tally.roll_backs, 0);
    EXPECT_GT(tally.retried, 0);
    EXPECT_EQ(tally.uncut, 0);
}

TEST(CutExtremes, BandTooThinForItsTrianglesIsWidenedAndReported) {
    Surface surface(cut_sheet(2, 2, 0.05), {}, 100);
    BladeStep thin = surface.step(0.011, 0.02, 0.031, 0.027, 1e-8);
    thin.start = thin.end = BladeEnd::round;
    const CutReport report = surface.cut(thin);
    EXPECT_EQ(report.outcome, CutOutcome::cut);
    EXPECT_EQ(report.roll_backs, 0);
    EXPECT_GT(report.width, 1e-5);
    EXPECT_LT(report.width, 1e-4);
    EXPECT_NEAR(report.removed_area, 0.0212 * report.width, 0.02 * 0.0212 * report.width);
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
    EXPECT_EQ(surface.cut(surface.step(0.011, 0.06, 0.031, 0.067, 0.001)).width, 0.001);
}

TEST(CutExtremes, StepOfOneMetreCutsASheetInTwo) {
    Surface surface(cut_sheet(20, 20, 0.01), {}, 400);
    EXPECT_EQ(surface.cut(surface.step(-0.9, 0.0721, 1.1, 0.0933, 0.001)).outcome, CutOutcome::cut);
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
    EXPECT_EQ(surface.mesh.find_pieces(), 2);
}

TEST(CutExtremes, EveryTriangleCanBeCutRepeatedly) {
    Surface surface(cut_sheet(10, 10, 0.01), {}, 1500);
    for (int pass = 0; pass < 2; ++pass)
        for (int i = 0; i < 20; ++i) {
            const double x = 0.005 * i + 0.0013 + 0.0007 * pass;
            const CutReport report = pass == 0 ? surface.cut(surface.step(x, -0.01, x + 0.002, 0.11, 0.0005))
                                               : surface.cut(surface.step(-0.01, x, 0.11, x - 0.001, 0.0005));
            EXPECT_EQ(report.outcome, CutOutcome::cut);
        }
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
    for (std::int32_t r = 0; r < surface.mesh.root_count(); ++r)
        EXPECT_GT(surface.mesh.root(r).removed_share, 0);
}

TEST(CutExtremes, BackAndForthRemovesTheAreaOnce) {
    Surface surface(cut_sheet(10, 10, 0.01), {}, 1500);
    for (int i = 0; i < 40; ++i) {
        const bool back = i % 2 == 1;
        surface.cut(surface.step(back ? 0.07 : 0.02, back ? 0.055 : 0.043, back ? 0.02 : 0.07,
                                 back ? 0.043 : 0.055, 0.001));
    }
    const double area = 0.001 * std::hypot(0.05, 0.012);
    EXPECT_NEAR(surface.mesh.area_removed(), area, 0.01 * area);
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
}

TEST(CutExtremes, NonFinitePositionIsRefusedWithoutChange) {
    Surface surface(cut_sheet(4, 4, 0.01), {}, 100);
    BladeStep step = surface.step(0.005, 0.013, 0.03, 0.021, 0.001);
    const std::uint64_t digest = surface.mesh.digest();
    surface.positions[static_cast<std::size_t>(surface.mesh.triangle(step.root).vertices[0])].x() =
        std::nan("");
    EXPECT_EQ(surface.cut(step).outcome, CutOutcome::invalid);
    EXPECT_EQ(surface.mesh.digest(), digest);
}

TEST(CutExtremes, StepAllocatesNothing) {
    Surface surface(cut_sheet(20, 20, 0.005), {0}, 300);
    BladeStep steps[40];
    for (int i = 0; i < 40; ++i) {
        const double x = 0.002 * i + 0.0101;
        steps[i] = surface.step(x, 0.03 + 3e-5 * i * i, x + 0.002, 0.03 + 3e-5 * (i + 1) * (i + 1), 0.001,
                                BladeEnd::round);
    }
    std::uint64_t allocated = 0;
    int cuts = 0;
    for (const BladeStep& step : steps) {
        CutReport report;
        allocated += test::allocations_in([&] { report = surface.cut(step); });
        cuts += report.outcome == CutOutcome::cut ? 1 : 0;
    }
    EXPECT_GT(cuts, 30);
    EXPECT_EQ(allocated, 0U);
    EXPECT_EQ(test::allocations_in([&] {
                  for (std::int32_t p = surface.mesh.find_pieces() - 1; p >= 0; --p)
                      if (!surface.mesh.piece(p).fixed)
                          surface.mesh.remove_piece(p, surface.positions.data());
              }),
              0U);
}

TEST(CutExtremes, SameStrokesGiveTheSameBits) {
    std::uint64_t digests[2] = {};
    for (std::uint64_t& digest : digests) {
        Surface surface(lab::make_sphere(2, 0.03), {}, 300);
        Random random(4);
        for (int i = 0; i < 30; ++i) {
            const Vector3 from = 0.03 * test::direction(random);
            BladeStep step;
            step.from = from;
            step.to = from + 0.006 * test::inside_unit_box(random);
            step.normal = from;
            step.root = surface.mesh.nearest_root(from, surface.positions.data());
            surface.cut(step);
        }
        digest = surface.mesh.digest();
    }
    EXPECT_EQ(digests[0], digests[1]);
}

TEST(CutExtremes, ContinuesIdenticallyFromASaveInTheMiddleOfAStroke) {
    Surface surface(cut_sheet(10, 10, 0.01), {}, 300);
    surface.stroke({{0.013, 0.02}, {0.03, 0.031}, {0.051, 0.03}}, 0.001);
    const CutState saved = surface.mesh.state();
    const std::vector<Vector3> positions = surface.positions;
    const BladeStep next = surface.step(0.051, 0.03, 0.072, 0.051, 0.001, BladeEnd::round);
    surface.cut(next);
    const std::uint64_t digest = surface.mesh.digest();
    const CutCases cases = surface.mesh.cases();
    Surface other(cut_sheet(10, 10, 0.01), {}, 300);
    other.mesh.restore(saved);
    other.positions = positions;
    other.cut(next);
    EXPECT_EQ(other.mesh.digest(), digest);
    EXPECT_EQ(other.mesh.cases().count, cases.count);
}

}  // namespace
}  // namespace fulcrum
