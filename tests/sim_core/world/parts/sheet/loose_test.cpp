// SPDX-License-Identifier: Apache-2.0
// Tissue that is detached while a blade is in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "sim_core/world/part/blade_law.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum {
namespace {

/// A blade held in a sheet from below, and the piece cut free around it.
struct BladeFromBelow {
    Scene scene = test::sheet_scene();
    SheetPart part{scene, scene.step_period()};
    std::array<SheetAction, hand_count> actions;
    std::uint32_t tick = 0;
    int begun = 0, ended = 0, reported = 0, fallen = 0;
    double farthest = 0;  ///< m, between a cutting blade and its position in the tissue

    const SheetHand& hand() const { return part.state().hands[1]; }
    Vector3 on(double x, double off, double up) const {
        const SheetSpec& sheet = *scene.sheet;
        return sheet.centre + (x - 0.5 * sheet.line_length) * sheet.along + off * sheet.across +
               Vector3(0, 0, up);
    }
    void step() {
        part.step(actions.data(), tick += 5, scene.step_period());
        for (int e = 0; e < part.event_count(); ++e) {
            const EventKind kind = part.events()[e].kind;
            begun += kind == EventKind::cut_begin ? 1 : 0;
            ended += kind == EventKind::cut_end ? 1 : 0;
            reported += kind == EventKind::cut_advance ? 1 : 0;
            fallen += kind == EventKind::piece_fallen ? 1 : 0;
        }
        if (hand().touch == BladeTouch::cutting)
            farthest = std::max(farthest, (part.place(hand().place) - hand().target).norm());
    }
    void go(const Vector3& to, double speed) {
        Vector3& tip = actions[1].tool.tip;
        const Vector3 from = tip;
        const int count = std::max(1, static_cast<int>((to - from).norm() / (speed * scene.step_period())));
        for (int i = 1; i <= count; ++i) {
            tip = from + static_cast<double>(i) / count * (to - from);
            step();
        }
    }
    void enter() {
        SheetAction& action = actions[1];
        action.instrument = &scene.instruments[1];
        action.tool.axis = Vector3(0, 0, 1);
        action.tool.tip = on(0.035, -0.008, -0.01);
        action.tool.inside = action.tool.present = true;
        action.tool.buttons = button_primary;
        go(on(0.035, -0.008, -0.001), 0.1);
        go(on(0.055, -0.008, 0.01), 0.04);
    }
    /// A square around the blade, 2 mm at a time.
    void part_around(double half) {
        const Vector3 middle = part.place(hand().place), x = scene.sheet->along, y = scene.sheet->across;
        const Vector3 corners[] = {middle - half * x - half * y, middle + half * x - half * y,
                                   middle + half * x + half * y, middle - half * x + half * y};
        for (std::size_t k = 0; k < 4; ++k) {
            const Vector3 direction = (corners[(k + 1) % 4] - corners[k]).normalized();
            for (double run = -0.0005; run < 2 * half; run += 0.002) {
                BladeStep blade;
                blade.from = corners[k] + (run - blade_law::overlap) * direction;
                blade.to = corners[k] + (run + 0.002) * direction;
                blade.normal = Vector3(0, 0, 1);
                blade.width = scene.sheet->blade_width;
                blade.depth = 0.02;
                blade.root =
                    part.surface().nearest_root(0.5 * (blade.from + blade.to), part.state().positions.data());
                ASSERT_EQ(part.cut(blade).outcome, CutOutcome::cut) << k << " " << run;
            }
        }
    }
};

// A piece falls for a second before it is removed: the blade must neither move with it nor jump to the tissue
// nearest to the fallen piece.
TEST(SheetLoose, BladeReleasesAFallingPiece) {
    BladeFromBelow rig;
    rig.enter();
    ASSERT_EQ(rig.hand().touch, BladeTouch::cutting);
    ASSERT_LT(rig.hand().side, 0) << "a falling piece does not pass over the tip";
    rig.part_around(0.008);
    ASSERT_GT(rig.part.state().loose[static_cast<std::size_t>(rig.hand().place.fragment)], 0)
        << "the blade is in it";
    const int reported = rig.reported;
    for (int i = 0; i < 40; ++i) rig.step();
    EXPECT_NE(rig.hand().touch, BladeTouch::cutting);
    EXPECT_EQ(rig.ended, rig.begun);
    for (int i = 0; i < 250; ++i) rig.step();
    EXPECT_EQ(rig.reported, reported);
    EXPECT_EQ(rig.ended, rig.begun);
    EXPECT_GT(rig.part.surface().area_removed(), 0.8 * 0.016 * 0.016) << "m2: the piece was removed";
    EXPECT_LT(rig.farthest, 0.005);
}

}  // namespace
}  // namespace fulcrum
