// SPDX-License-Identifier: Apache-2.0
// A sheet held under traction and divided by two hands in the running world, ticks included.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_core/world/parts/sheet/sheet_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

Vector3 on_line(const Scene& scene, double x, double above) {
    return scene.sheet->centre + (x - 0.5 * scene.sheet->line_length) * scene.sheet->along +
           Vector3(0, 0, above);
}

/// Grasped at the flap; the blade placed at `from` (m along the line), pressed in and moved to `to`.
void divide(test::SheetRig& rig, double from, double to, double speed = 0.03) {
    rig.go(1, on_line(rig.scene, from, 0.02), 0.2);
    rig.go(1, on_line(rig.scene, from, 0.002), 0.1);
    rig.wish[1].button = true;
    rig.go(1, on_line(rig.scene, from + 0.012, -0.006), 0.04);
    rig.go(1, on_line(rig.scene, to, -0.006), speed);
}

TEST(SheetWorld, SceneWithoutASheetHasNone) {
    World world(load_scene(test::source_path("assets/scenes/a2_targets.json")), 1);
    EXPECT_EQ(world.find<SheetPart>(), nullptr);
    EXPECT_TRUE(world.snapshot().sheet.positions.empty());
    EXPECT_TRUE(world.snapshot().events.empty());
}

TEST(SheetWorld, BladeDividesTheSheetAlongTheLineUnderTraction) {
    test::SheetRig rig;
    for (const double traction : rig.world.snapshot().sheet.line_traction)
        EXPECT_GT(traction, 0) << "pre-strained";
    const double slack = rig.sheet().state().traction[10];
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    rig.steps(30);
    ASSERT_TRUE(rig.hand(0).jaws.held());
    EXPECT_TRUE(rig.world.snapshot().grasps[0].held);
    EXPECT_GT(rig.sheet().state().traction[10], 1.5 * slack) << "traction must open the plane";
    divide(rig, 0.02, 0.075);
    EXPECT_EQ(rig.hand(1).touch, BladeTouch::cutting);
    bool flagged = false;
    for (const TickOutput& output : rig.outputs)
        flagged = flagged || (output.sample.hand[1].flags & hand_cutting) != 0;
    EXPECT_TRUE(flagged);
    EXPECT_EQ(rig.outputs[0].sample.hand[1].tissue, rig.scene.tissue_index("areolar"));
    rig.wish[1].button = false;
    rig.steps(2);
    for (const TickOutput& output : rig.outputs) flagged = (output.sample.hand[1].flags & hand_cutting) != 0;
    EXPECT_FALSE(flagged);

    EXPECT_EQ(rig.count(EventKind::cut_begin), 1);
    EXPECT_EQ(rig.count(EventKind::cut_end), 1);
    EXPECT_GT(rig.count(EventKind::cut_advance), 40);
    EXPECT_EQ(rig.count(EventKind::cut_advance), rig.count(EventKind::cut_traction));
    double position = 0, length = 0;
    for (const Event& event : rig.events) {
        EXPECT_EQ(event.tissue, rig.scene.tissue_index("areolar"));
        if (event.kind == EventKind::cut_advance) {
            EXPECT_GT(event.value, position - 0.002) << "the cut must advance";
            EXPECT_LT(std::abs(event.detail), 9000) << "um from the line";
            position = event.value;
        }
        if (event.kind == EventKind::cut_traction) {
            EXPECT_GT(event.value, 0.5) << "N/m across a blade in a sheet under traction";
            EXPECT_GT(event.detail, 0);
            length += 1e-6 * event.detail;
        }
    }
    EXPECT_GT(length, 0.03);
    EXPECT_LT(length, 0.08);
    const WorldSnapshot& snapshot = rig.world.snapshot();
    int divided = 0;
    for (const std::uint8_t at : snapshot.sheet.line_divided) divided += at;
    EXPECT_GE(divided, 6);
    EXPECT_LE(divided, 16);

    const CutMesh& surface = rig.sheet().surface();
    EXPECT_TRUE(check_cut(surface, rig.sheet().state().positions.data()).passed())
        << check_cut(surface, rig.sheet().state().positions.data()).complaint();
    EXPECT_NEAR(surface.area_removed(), length * rig.scene.sheet->blade_width,
                0.5 * length * rig.scene.sheet->blade_width);
    EXPECT_NEAR(snapshot.sheet.visible_area + snapshot.sheet.removed_area, surface.area_before(),
                1e-9 * surface.area_before());
    // Drawn: as many triangles as are visible, with vertices at the positions of the springs' nodes.
    EXPECT_EQ(snapshot.sheet.triangle_count, surface.visible_count());
    EXPECT_EQ(snapshot.sheet.vertex_count, surface.vertex_count());
    for (std::int32_t t = 0; t < snapshot.sheet.triangle_count; ++t) {
        for (const std::int32_t v : snapshot.sheet.triangles[static_cast<std::size_t>(t)]) {
            ASSERT_LT(v, snapshot.sheet.vertex_count);
            ASSERT_LT(
                (snapshot.sheet.positions[static_cast<std::size_t>(v)] - rig.scene.sheet->centre).norm(),
                0.12);
        }
    }
    // The remaining mass is proportional to area; the springs' pieces and the surface's fragments agree.
    const auto& membrane = rig.sheet().state().membrane;
    EXPECT_NEAR(rig.sheet().membrane().mass(membrane),
                surface.area_visible() * rig.sheet().membrane().density(), 1e-12);
}

TEST(SheetWorld, NoCutWithoutForceButtonAndBlade) {
    for (int lacking = 0; lacking < 3; ++lacking) {
        Scene scene = test::sheet_scene();
        if (lacking == 2) scene.instruments[1].kind = InstrumentKind::probe;
        test::SheetRig rig(scene);
        rig.hold_flap(0, Vector3(0, 0.006, 0.008));
        rig.go(1, on_line(scene, 0.02, 0.02), 0.2);
        rig.wish[1].button = lacking != 1;
        rig.go(1, on_line(scene, 0.02, lacking == 0 ? 0.0016 : -0.006), 0.05);
        rig.go(1, on_line(scene, 0.06, lacking == 0 ? 0.0016 : -0.006), 0.03);
        EXPECT_EQ(rig.sheet().surface().version(), 0U) << lacking;
        EXPECT_EQ(rig.count(EventKind::cut_begin), 0);
    }
}

// docs/THEORY.md, section 6: at a swap the stored energy of the sheet does not grow, and nothing moves.
TEST(SheetWorld, SwapsNeitherRaiseTheEnergyNorMoveVertices) {
    test::SheetRig rig;
    rig.hold_flap(0.01, Vector3(0, 0.006, 0.010));
    SheetPart& sheet = *rig.world.find<SheetPart>();
    Vector3 at = on_line(rig.scene, 0.03, 0);
    double lost = 0;
    int still = 0;
    for (int i = 0; i < 40; ++i) {
        rig.step();  // the lips move between the cuts
        const SheetPart::State before = sheet.state();
        const MembraneEnergy old = sheet.membrane().energy(before.membrane);
        BladeStep blade;
        blade.from = at - Vector3(0.0004, 0, 0);
        blade.to = at = at + Vector3(0.0011, 0.0002 * std::sin(0.3 * i), 0);
        blade.width = 0.0006;
        blade.depth = 0.02;
        blade.root = sheet.surface().nearest_root(blade.from, sheet.state().positions.data());
        std::vector<Vector3> rest;
        for (std::int32_t v = 0; v < sheet.surface().vertex_count(); ++v)
            rest.push_back(sheet.surface().vertex(v).rest);
        sheet.cut(blade);
        const MembraneEnergy now = sheet.membrane().energy(sheet.state().membrane);
        ASSERT_LE(now.structural, old.structural * (1 + 1e-12));
        ASSERT_LE(now.shear, old.shear * (1 + 1e-12));
        ASSERT_LE(now.bend, old.bend * (1 + 1e-12));
        ASSERT_LE(now.kinetic, old.kinetic * (1 + 1e-12));
        lost += old.elastic() - now.elastic();
        for (const Vector3& position : sheet.state().positions) ASSERT_TRUE(position.allFinite());
        for (std::size_t v = 0; v < rest.size(); ++v) {
            if (sheet.state().bindings[v].fragment < 0) continue;
            // Tidying may have assigned another vertex to this number.
            if (sheet.surface().vertex(static_cast<std::int32_t>(v)).rest != rest[v]) continue;
            ++still;
            ASSERT_LT((sheet.state().positions[v] - before.positions[v]).norm(), 1e-12);
        }
    }
    EXPECT_GT(sheet.surface().version(), 25U);
    EXPECT_GT(lost, 0);
    EXPECT_GT(still, 40 * 400);
}

TEST(SheetWorld, SameInputGivesTheSameBitsAndASaveContinuesIdentically) {
    std::uint64_t hash[2];
    for (std::uint64_t& of_run : hash) {
        test::SheetRig rig;
        rig.hold_flap(0, Vector3(0, 0.006, 0.008));
        divide(rig, 0.03, 0.055);
        of_run = rig.hash;
    }
    EXPECT_EQ(hash[0], hash[1]);

    // Saved in the middle, restored in a new part: both continue identically.
    test::SheetRig rig;
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    divide(rig, 0.02, 0.05);
    SheetPart other(rig.scene, rig.scene.step_period());
    other.restore(rig.sheet().state(), rig.sheet().surface().state());
    SheetAction actions[hand_count];
    for (std::size_t h = 0; h < hand_count; ++h) {
        actions[h].instrument = rig.scene.instrument(static_cast<Hand>(h));
        actions[h].tool = rig.outputs.back().contact[h].tool;
    }
    for (std::uint32_t i = 0; i < 60; ++i) {
        actions[1].tool.tip += Vector3(1.5e-4, 0, 0);
        rig.world.find<SheetPart>()->step(actions, 1000 + i, 0.005);
        other.step(actions, 1000 + i, 0.005);
    }
    StateHash a, b;
    rig.sheet().hash(a);
    other.hash(b);
    EXPECT_EQ(a.value(), b.value());
    EXPECT_EQ(other.surface().digest(), rig.sheet().surface().digest());
    EXPECT_GT(other.surface().version(), 20U);
}

TEST(SheetWorld, StepsWithCutsAllocateNothing) {
    test::SheetRig rig;
    rig.hold_flap(0, Vector3(0, 0.006, 0.008));
    divide(rig, 0.02, 0.03);
    rig.events.reserve(1000);
    const std::uint64_t version = rig.sheet().surface().version();
    const std::uint64_t allocations = test::allocation_count();
    rig.go(1, on_line(rig.scene, 0.07, -0.006), 0.03);
    EXPECT_EQ(test::allocation_count(), allocations);
    EXPECT_GT(rig.sheet().surface().version(), version + 20);
}

}  // namespace
}  // namespace fulcrum
