// SPDX-License-Identifier: Apache-2.0
// The reported cut matches the tissue that was cut.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/sim_core/world/parts/sheet/cut_truth.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

// Slowly, and so fast that the blade passes the border in the middle of a step.
class SheetReport : public testing::TestWithParam<double> {};

TEST_P(SheetReport, StrokeFromBorderToBorderIsReportedWhereTissueWasCut) {
    test::SheetRig rig;
    const SheetSpec& sheet = *rig.scene.sheet;
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    const auto on = [&](double x, double up, double off) -> Vector3 {
        return sheet.centre + (x - 0.5 * sheet.line_length) * sheet.along + off * sheet.across +
               Vector3(0, 0, up);
    };
    const double low = 0.5 * (sheet.line_length - sheet.length), high = sheet.length + low;
    rig.go(1, on(low + 0.001, 0.02, 0), 0.2);
    rig.go(1, on(low + 0.001, 0.002, 0), 0.1);
    rig.wish[1].button = true;
    rig.go(1, on(low + 0.012, -0.006, 0), 0.04);
    for (double x = low + 0.012; x < high - 0.02; x += 0.002)
        rig.go(1, on(x, -0.006, 0.002 * std::sin(400 * x)), 0.03);
    rig.go(1, on(high + 0.01, -0.006, 0), GetParam());
    rig.wish[1].button = false;
    rig.steps(5);

    Vector3 last = Vector3::Zero();
    std::vector<std::array<double, 2>> paths;
    for (const Event& event : rig.events) {
        if (event.kind != EventKind::cut_begin && event.kind != EventKind::cut_advance) continue;
        const Vector3 here(event.value, -1e-6 * event.detail, 0), displacement = here - last;
        EXPECT_GT(here.x(), low - 1e-6) << "on the sheet";
        EXPECT_LT(here.x(), high + 1e-6) << "on the sheet";
        if (event.kind == EventKind::cut_advance) {
            paths.push_back({last.x(), here.x()});
            const int samples = std::max(1, static_cast<int>(displacement.norm() / 0.0003));
            for (int i = 0; i < samples; ++i) {
                const Vector3 place = last + (i + 0.5) / samples * displacement;
                EXPECT_FALSE(test::whole_around(rig.world.snapshot().sheet, place, 0.0008))
                    << place.transpose();
            }
        }
        last = here;
    }
    EXPECT_GT(paths.size(), 60U);
    const test::PartedLine line =
        test::parted_line(rig.world.snapshot().sheet, {low, high}, {-0.01, 0.01}, paths);
    EXPECT_LE(line.longest_unreported, 0.0008 + 1e-9) << "at " << line.unreported_at;
    EXPECT_GT(line.parted, 0.9 * sheet.length);
}

INSTANTIATE_TEST_SUITE_P(Speeds, SheetReport, testing::Values(0.03, 0.3, 1.0));

}  // namespace
}  // namespace fulcrum
