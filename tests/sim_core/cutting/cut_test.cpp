// SPDX-License-Identifier: Apache-2.0
// Effect of cuts on the whole surface.
#include <gtest/gtest.h>

#include "tests/sim_core/cutting/surfaces.h"

namespace fulcrum {
namespace {

using test::border_of_sheet;
using test::cut_sheet;
using test::Surface;

TEST(Cut, RemovesTheBandOnly) {
    Surface surface(cut_sheet(8, 8, 0.01), {}, 100);
    const CutReport report = surface.cut(surface.step(0.0213, 0.0331, 0.0582, 0.0447, 0.002));
    ASSERT_EQ(report.outcome, CutOutcome::cut);
    const double length = std::hypot(0.0582 - 0.0213, 0.0447 - 0.0331);
    EXPECT_NEAR(report.removed_area, 0.002 * length, 1e-3 * 0.002 * length);
    EXPECT_NEAR(surface.mesh.area_visible() + surface.mesh.area_removed(), 0.0064, 1e-15);
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
    EXPECT_EQ(surface.mesh.find_pieces(), 1);
}

TEST(Cut, FromBorderToBorderLeavesTwoPieces) {
    Surface surface(cut_sheet(8, 8, 0.01), {}, 100);
    ASSERT_EQ(surface.cut(surface.step(-0.005, 0.031, 0.085, 0.046, 0.001)).outcome, CutOutcome::cut);
    EXPECT_TRUE(surface.check().passed()) << surface.check().complaint();
    EXPECT_EQ(surface.mesh.find_pieces(), 2);
}

}  // namespace
}  // namespace fulcrum
