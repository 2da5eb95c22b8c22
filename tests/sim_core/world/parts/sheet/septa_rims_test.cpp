// SPDX-License-Identifier: Apache-2.0
// Reported cuts along and across the borders of septa match the surface that was cut.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "sim_core/numerics/random.h"
#include "tests/sim_core/world/parts/sheet/cut_truth.h"
#include "tests/sim_core/world/parts/sheet/septa_rig.h"

namespace fulcrum {
namespace {

// The reported cuts are compared with the cut surface only; no path leads from one septum to the next.
class SeptaRims : public testing::TestWithParam<std::uint64_t> {};

TEST_P(SeptaRims, CutsAlongAndAcrossBordersAreReportedInPlace) {
    test::SeptaRig rig;
    const double width = rig.scene.septa->width;
    rig.take_rectum();
    rig.lift(0.008);
    Random random(GetParam(), 0x51DEU);
    int reported = 0;
    std::vector<std::array<double, 2>> all;
    for (int stroke = 0; stroke < 8; ++stroke) {
        const int septum = stroke / 4;
        const double side = random.uniform(0, 1) < 0.5 ? 0 : 1, inwards = side > 0 ? -1 : 1;
        const auto by_rim = [&](double inside, double outside) {
            return side + inwards * random.uniform(-outside, inside);
        };
        const auto behind = [&](double share) -> Vector3 {
            const double up = random.uniform(-0.006, 0.012);
            return rig.on_line(septum, share, -0.006) - up * rig.curve.posterior(rig.arc_length(septum));
        };
        rig.events.clear();
        const double from = by_rim(0.15, 0), speed = random.uniform(0.02, 0.15);
        rig.set_on(septum, from);
        rig.wish[1].button = true;
        rig.go(1, behind(from + 0.02 * inwards), 0.03);
        rig.go(1, behind(by_rim(0.2, 0.12)), speed);
        rig.go(1, behind(by_rim(0.2, 0.10)), speed);
        rig.wish[1].button = false;
        rig.steps(3);
        rig.go(1, rig.wish[1].tip + 0.07 * (rig.trocar[1].position - rig.wish[1].tip).normalized(), 0.3);

        Vector3 last = Vector3::Zero();
        std::vector<std::array<double, 2>> paths;
        for (const Event& event : rig.events) {
            if (event.kind != EventKind::cut_begin && event.kind != EventKind::cut_advance) continue;
            const Vector3 here(event.value, -1e-6 * event.detail, 0), displacement = here - last;
            if (event.kind == EventKind::cut_advance) {
                ++reported;
                paths.push_back({std::min(last.x(), here.x()), std::max(last.x(), here.x())});
                EXPECT_EQ(std::floor(here.x() / width), std::floor(last.x() / width)) << "stroke " << stroke;
                const int samples = std::max(1, static_cast<int>(displacement.norm() / 0.0003));
                for (int i = 0; i < samples; ++i) {
                    const Vector3 place = last + (i + 0.5) / samples * displacement;
                    EXPECT_FALSE(test::whole_around(rig.view(), place, 0.0008))
                        << "stroke " << stroke << " of " << displacement.norm() << " m at "
                        << place.transpose();
                }
            }
            last = here;
        }
        all.insert(all.end(), paths.begin(), paths.end());
    }
    // And all divided tissue was reported, except at the ends of strokes: a blade's cap, a piece that falls
    // at a corner, and a corner that is edge-on under the blade, which then divides more than the points of
    // its path.
    const double plane = rig.scene.septa->plane_height, fat = rig.scene.septa->fat_height - plane;
    for (int septum = 0; septum < 2; ++septum) {
        const test::PartedLine line = test::parted_line(rig.view(), {septum * width, (septum + 1) * width},
                                                        {-plane + 0.0001, fat}, all);
        EXPECT_LE(line.longest_unreported, 0.0028 + 1e-9)
            << "septum " << septum << " at " << line.unreported_at;
    }
    EXPECT_GT(reported, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SeptaRims, testing::Values(1, 6, 10));

}  // namespace
}  // namespace fulcrum
