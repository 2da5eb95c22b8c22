// SPDX-License-Identifier: Apache-2.0
// The plane behind the rectum in the running world: grasped, lifted, divided, saved.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_core/world/couplings/septa_on_rectum.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "tests/sim_core/world/parts/sheet/drags.h"
#include "tests/sim_core/world/parts/sheet/septa_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

TEST(SeptaWorld, RestsWithoutFaultAndWithoutMotion) {
    test::SeptaRig rig;
    const std::vector<Vector3> before = rig.view().line;
    ASSERT_EQ(before.size() % 4, 0U);
    const std::vector<Vector3> nodes = rig.world.snapshot().bowel.nodes;
    std::uint32_t worst = 0;
    for (int i = 0; i < 600; ++i) {
        rig.step();
        worst = std::max(worst, rig.record.outcome);
    }
    EXPECT_EQ(worst, 0U);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((rig.view().line[i] - before[i]).norm(), 2e-4);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        EXPECT_LT((rig.world.snapshot().bowel.nodes[i] - nodes[i]).norm(), 2e-4);
    EXPECT_EQ(rig.largest_force, 0);
    for (int k = 0; k < 4; ++k) EXPECT_GT(rig.traction(k), 0) << "pre-strained";
    EXPECT_LT(rig.world.find<SeptaOnRectum>()->edge().coupling(), 0.5);
}

TEST(SeptaWorld, LiftingTheRectumRaisesTheTractionAcrossEveryPlane) {
    test::SeptaRig rig;
    double last[4], pull = 0;
    for (int k = 0; k < 4; ++k) last[k] = rig.traction(k);
    rig.take_rectum();
    ASSERT_TRUE(rig.world.snapshot().grasps[0].held);
    EXPECT_GT(rig.world.snapshot().grasps[0].arc_length, 0) << "of the rectum";
    EXPECT_FALSE(rig.hand(0).jaws.held()) << "not of a septum";
    for (const double by : {0.003, 0.006, 0.009, 0.012}) {
        rig.lift(by);
        ASSERT_TRUE(rig.world.snapshot().grasps[0].held);
        for (int k = 0; k < 4; ++k) {
            EXPECT_GT(rig.traction(k), last[k]) << by << " m, septum " << k;
            last[k] = rig.traction(k);
        }
        const double now = rig.world.snapshot().grasps[0].reaction.norm();
        EXPECT_GT(now, pull) << "and the hand feels it";
        pull = now;
        // Septa nearer to the hand are stretched more.
        EXPECT_GT(last[0], last[3]);
    }
    EXPECT_LT(pull, 3.0) << "N: within the rectum's limit";
    // The plane under the hand can be brought into a useful traction band.
    EXPECT_GT(last[0], 10);
    EXPECT_LT(last[0], 40);
}

TEST(SeptaWorld, JawsGraspTheNearerTissue) {
    const Scene scene = test::septa_scene();
    const SacralCurve curve = rectum_parameters(scene).curve;
    const double s = curve.arc_length(scene.septa->first_angle), half = 0.5 * scene.instruments[0].jaw_length;
    struct Case {
        double height, before;  ///< m above the fascia and cranially of the septum, of the middle of the
                                ///< jaws, which lie across it
        bool septum;
    };
    for (const Case& at : {Case{0.006, 0, true}, Case{0.012, 0.001, true}, Case{0.0165, 0.006, false}}) {
        World world(scene, 1);
        TickOutput output;
        ToolKinematics& tool = output.contact[0].tool;
        tool.axis = curve.cranial(s);
        tool.rotation.col(2) = tool.axis;
        tool.rotation.col(0) = Vector3::UnitX();
        tool.rotation.col(1) = tool.axis.cross(Vector3::UnitX());
        tool.tip = curve.point(s + at.before, 0.2, at.height) + half * tool.axis;
        tool.trocar = tool.tip - 0.2 * tool.axis;
        tool.inside = tool.present = true;
        tool.grip = 8;
        for (std::uint32_t i = 1; i <= 4; ++i) {
            output.sample.tick = 5 * i;
            world.step(&output, 1);
        }
        EXPECT_EQ(world.find<SheetPart>()->holds(0), at.septum) << at.height;
        EXPECT_EQ(world.find<BowelPart>()->grasp(Hand::left).held, !at.septum) << at.height;
        EXPECT_TRUE(world.snapshot().grasps[0].held);
        EXPECT_EQ(world.snapshot().grasps[0].arc_length < 0, at.septum) << "shown as what it is";
        EXPECT_EQ(world.local_models().hand[0].mode, LocalMode::grasp);
        EXPECT_EQ(world.local_models().hand[0].grasp.tissue,
                  scene.tissue_index(at.septum ? "areolar" : "bowel"));
    }
}

TEST(SeptaWorld, AGraspAtTheRimOfASeptumIsNotOneOfTheNext) {
    const Scene scene = test::septa_scene();
    const SacralCurve curve = rectum_parameters(scene).curve;
    const double s = curve.arc_length(scene.septa->first_angle), half = 0.5 * scene.instruments[0].jaw_length;
    const double rim = 0.5 * scene.septa->width / (curve.fascia_radius() - scene.septa->plane_height);
    World world(scene, 1);
    TickOutput output;
    ToolKinematics& tool = output.contact[0].tool;
    tool.axis = curve.cranial(s);
    tool.rotation.col(2) = tool.axis;
    tool.rotation.col(0) = Vector3::UnitX();
    tool.rotation.col(1) = tool.axis.cross(Vector3::UnitX());
    tool.tip = curve.point(s, rim + 0.06, 0.006) + half * tool.axis;  // about 2 mm beyond it
    tool.trocar = tool.tip - 0.2 * tool.axis;
    tool.inside = tool.present = true;
    tool.grip = 8;
    for (std::uint32_t i = 1; i <= 4; ++i) {
        output.sample.tick = 5 * i;
        world.step(&output, 1);
    }
    ASSERT_TRUE(world.find<SheetPart>()->holds(0));
    const double place = world.snapshot().grasps[0].offset.x();
    EXPECT_GT(place, scene.septa->width - 0.002);
    EXPECT_LT(place, scene.septa->width) << "lines are end to end";
}

TEST(SeptaWorld, ASeptumThatSlipsIsReportedAsASlipOfItsTissue) {
    const Scene scene = test::septa_scene();
    const SacralCurve curve = rectum_parameters(scene).curve;
    const double s = curve.arc_length(scene.septa->first_angle), half = 0.5 * scene.instruments[0].jaw_length;
    World world(scene, 1);
    TickOutput output;
    ToolKinematics& tool = output.contact[0].tool;
    tool.axis = curve.cranial(s);
    tool.rotation.col(2) = tool.axis;
    tool.rotation.col(0) = Vector3::UnitX();
    tool.rotation.col(1) = tool.axis.cross(Vector3::UnitX());
    tool.tip = curve.point(s, 0.2, 0.006) + half * tool.axis;
    tool.trocar = tool.tip - 0.2 * tool.axis;
    tool.inside = tool.present = true;
    tool.grip = 8;
    std::uint32_t tick = 0;
    const auto step = [&] {
        output.sample.tick = tick += 5;
        world.step(&output, 1);
        return world.snapshot().grasps[0];
    };
    for (int i = 0; i < 4; ++i) step();
    ASSERT_TRUE(world.find<SheetPart>()->holds(0));
    EXPECT_EQ(world.snapshot().grasps[0].body, HeldBody::sheet);
    tool.grip = 1;  // weak jaws, pulled away from the plane
    GraspState grasp = world.snapshot().grasps[0];
    for (int i = 0; i < 400 && grasp.held; ++i) {
        tool.tip += 2e-4 * tool.axis;
        tool.trocar += 2e-4 * tool.axis;
        grasp = step();
    }
    ASSERT_FALSE(grasp.held);
    EXPECT_TRUE(grasp.slipped) << "not released";
    EXPECT_EQ(grasp.body, HeldBody::sheet);
    EXPECT_EQ(grasp.tissue, scene.tissue_index("fat")) << "the mesorectal side of the plane, not the bowel";
    EXPECT_TRUE(step().slipped) << "until the next hold";
}

TEST(SeptaWorld, HookDividesTheFirstSeptumAndReleasesTheRectum) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.010);
    const double held_before = rig.world.snapshot().grasps[0].reaction.norm();
    const double pull_before = rig.world.find<SeptaOnRectum>()->edge().pulls()[0].force.norm();
    rig.divide(0, 0.02, 1.2);
    rig.withdraw();
    rig.steps(60);
    // One path from border to border; at the border, where the last fibres tear before the blade, it may be
    // reported in parts.
    EXPECT_EQ(rig.count(EventKind::cut_begin), rig.count(EventKind::cut_end));
    EXPECT_LE(rig.count(EventKind::cut_begin), 3);
    for (const Event& event : rig.events) {
        if (event.kind == EventKind::cut_end) {
            EXPECT_GT(event.value, rig.scene.septa->width - 0.002);
        }
    }
    EXPECT_GT(rig.count(EventKind::cut_advance), 40);
    int divided = 0;
    for (std::size_t i = 0; i < 12; ++i) divided += rig.view().line_divided[i];
    EXPECT_GE(divided, 11);
    for (std::size_t i = 12; i < rig.view().line_divided.size(); ++i)
        EXPECT_EQ(rig.view().line_divided[i], 0) << "the others are intact";
    for (const Event& event : rig.events) {
        if (event.kind != EventKind::cut_advance) continue;
        EXPECT_GT(event.value, 0);
        EXPECT_LT(event.value / rig.view().septum_length, 1) << "on the first septum's line";
        EXPECT_EQ(event.tissue, rig.scene.tissue_index(event.detail <= -3000 ? "fat" : "areolar"));
        EXPECT_LT(std::abs(event.detail), 3000) << "um: near the plane";
    }
    // Its pull on the rectum is gone except for the strand that remains at the border, and so is the
    // counter-force on the hand.
    EXPECT_LT(rig.world.find<SeptaOnRectum>()->edge().pulls()[0].force.norm(), 0.3 * pull_before);
    EXPECT_LT(rig.world.snapshot().grasps[0].reaction.norm(), held_before);
    EXPECT_TRUE(check_cut(rig.sheet().surface(), rig.sheet().state().positions.data()).passed())
        << check_cut(rig.sheet().surface(), rig.sheet().state().positions.data()).complaint();
    EXPECT_EQ(rig.record.outcome, 0U);
}

// Both variants: every plane divided, one after the other, as in a complete task.
TEST(SeptaWorld, WholePlaneIsDividedWithoutFaultInStandardAndNarrowPelvis) {
    for (const char* variant : {"c4_posterior", "c4_posterior_narrow"}) {
        test::SeptaRig rig(load_scene(test::source_path(std::string("assets/scenes/") + variant + ".json")));
        rig.take_rectum();
        rig.lift(0.010);
        const double before = rig.world.snapshot().grasps[0].reaction.norm();
        std::uint32_t worst = 0;
        for (int k = 0; k < rig.scene.septa->count; ++k) {
            // A blind hand: where the blade did not enter it is placed again, slightly further on.
            const int begun = rig.count(EventKind::cut_begin);
            for (const double from : {0.06, 0.10, 0.14}) {
                rig.divide(k, from, 1.1, 0.05);
                worst = std::max(worst, rig.record.outcome);
                rig.withdraw(k);
                worst = std::max(worst, rig.record.outcome);
                if (rig.count(EventKind::cut_begin) > begun) break;
            }
            EXPECT_GT(rig.count(EventKind::cut_begin), begun) << variant << ", septum " << k;
            rig.lift(0.010 + 0.002 * (k + 1));
            worst = std::max(worst, rig.record.outcome);
        }
        EXPECT_EQ(worst, 0U) << variant;
        EXPECT_EQ(rig.count(EventKind::cut_rolled_back), 0) << variant;
        int divided = 0;
        for (const std::uint8_t at : rig.view().line_divided) divided += at;
        EXPECT_GT(divided, 0.7 * static_cast<double>(rig.view().line_divided.size())) << variant;
        EXPECT_TRUE(rig.world.snapshot().grasps[0].held);
        EXPECT_LT(rig.world.snapshot().grasps[0].reaction.norm(), before)
            << "the rectum is released although it is lifted further";
        EXPECT_TRUE(check_cut(rig.sheet().surface(), rig.sheet().state().positions.data()).passed())
            << variant;
        for (const Vector3& place : rig.view().envelope) EXPECT_TRUE(place.allFinite());
    }
}

// The slew limit during cut, lift and push.
TEST(SeptaWorld, ForceChangesWithinTheSlewLimitDuringGraspLiftCutAndPush) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.008);
    rig.divide(0, 0.05, 0.6);
    rig.go(1, rig.wish[1].tip + Vector3(0, 0, 0.004), 0.02);
    rig.withdraw();
    // Back onto the fresh lip from in front, pushed and released.
    rig.go(1, rig.on_line(0, 0.45, 0.012), 0.1);
    rig.go(1, rig.on_line(0, 0.45, -0.004) + Vector3(0, 0, 0.003), 0.04);
    rig.go(1, rig.on_line(0, 0.45, 0.02), 0.04);
    EXPECT_GT(rig.count(EventKind::cut_advance), 10);
    EXPECT_GT(rig.largest_force, 0.1) << "there must be contact";
    EXPECT_LE(rig.worst_change, 0.3 + 1e-9) << "N in a ms";
}

// Tips over the border of the wall, through septa and their borders, shafts across each other.
TEST(SeptaWorld, DraggingAnywhereCausesNoForceJump) {
    for (const std::uint64_t seed : {1U, 2U}) {
        test::SeptaRig rig;
        Random random(seed, 0xD7A6U);
        const auto somewhere = [&](Random& r) -> Vector3 {
            if (r.uniform(0, 1) < 0.4) {
                const Vector3 aside(0, r.uniform(-0.005, 0.01), r.uniform(-0.005, 0.01));
                return rig.on_line(static_cast<int>(r.uniform(0, 3.999)), r.uniform(0, 1), 0.01) + aside;
            }
            return rig.curve.point(r.uniform(-0.02, 0.14), r.uniform(-1.5, 1.5), r.uniform(-0.004, 0.01));
        };
        rig.go(0, rig.curve.point(0.10, 0.5, 0.01), 0.3);
        rig.go(1, rig.curve.point(0.10, -0.5, 0.01), 0.3);
        EXPECT_LE(test::drag_about(rig, 50, random, somewhere), 0.3 + 1e-9) << "N in a ms, seed " << seed;
        EXPECT_GT(rig.largest_force, 1) << "there must be contact";
        EXPECT_EQ(rig.record.outcome, 0U);
    }
}

TEST(SeptaWorld, MuscularisIsNeverCut) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.006);
    rig.divide(0, 0.3, 0.5);
    // From the plane straight into the rectum, repeatedly.
    const Vector3 in = -rig.curve.posterior(rig.arc_length(0));
    rig.go(1, rig.wish[1].tip + 0.016 * in, 0.03);
    rig.go(1, rig.wish[1].tip + 0.010 * Vector3::UnitX(), 0.03);
    double highest = 0;
    for (const Event& event : rig.events) {
        if (event.kind == EventKind::cut_advance) highest = std::max(highest, -1e-6 * event.detail);
    }
    const SeptaSpec& spec = *rig.scene.septa;
    EXPECT_GT(highest, spec.areolar_height - spec.plane_height) << "the blade must leave the plane";
    EXPECT_LT(highest, spec.fat_height - spec.plane_height - 1e-4);
    const SheetLayout& layout = rig.sheet().layout();
    for (const std::int32_t v : layout.driven)
        EXPECT_GE(rig.sheet().state().bindings[static_cast<std::size_t>(v)].fragment, 0)
            << "its wall must be complete";
}

TEST(SeptaWorld, StepsWithCutsAllocateNothing) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.008);
    rig.divide(0, 0.05, 0.3);
    rig.events.reserve(2000);
    const std::uint64_t version = rig.sheet().surface().version();
    const std::uint64_t allocations = test::allocation_count();
    rig.draw(0, 0.3, 0.7, 0.03);
    rig.withdraw();
    EXPECT_EQ(test::allocation_count(), allocations);
    EXPECT_GT(rig.sheet().surface().version(), version + 15);
}

TEST(SeptaWorld, EnvelopeAndDisplayDataAreReported) {
    test::SeptaRig rig;
    const SeptaSpec& spec = *rig.scene.septa;
    const SheetView& view = rig.view();
    EXPECT_EQ(view.septum_length, spec.width);
    EXPECT_EQ(view.fat_from, spec.areolar_height - spec.plane_height);
    ASSERT_EQ(view.envelope.size(), static_cast<std::size_t>(spec.count * view.envelope_columns));
    for (const Vector3& place : view.envelope) EXPECT_TRUE(place.allFinite());
    const Vector3& first = view.envelope[0];
    EXPECT_LT(first.x(), 0) << "the patient's right first";
    EXPECT_LT((first - rig.curve.point(rig.arc_length(0),
                                       -0.5 * spec.width / (rig.curve.fascia_radius() - spec.plane_height),
                                       spec.areolar_height))
                  .norm(),
              0.003);
    for (std::size_t i = 1; i < view.line_positions.size(); ++i)
        EXPECT_GT(view.line_positions[i], view.line_positions[i - 1]);
    for (std::size_t i = 0; i < view.line_positions.size(); ++i) {
        EXPECT_EQ(static_cast<std::size_t>(view.line_positions[i] / view.septum_length),
                  i / (view.line.size() / 4));
    }
    for (std::int32_t v = 0; v < view.vertex_count; ++v) {
        const Vector3& rest = view.rest[static_cast<std::size_t>(v)];
        EXPECT_GE(rest.x(), -1e-12);
        EXPECT_LE(rest.x(), spec.count * spec.width + 1e-12);
        EXPECT_GE(rest.y(), -spec.plane_height - 1e-12);
        EXPECT_LE(rest.y(), spec.fat_height - spec.plane_height + 1e-12);
    }
}

/// Outputs of a complete dissection, to be fed to other worlds.
struct Kept {
    std::vector<std::vector<TickOutput>> outputs;
    std::vector<std::uint64_t> hashes;
};

Kept dissect(test::SeptaRig& rig) {
    Kept kept;
    rig.take_rectum();
    rig.lift(0.008);
    rig.set_on(0, 0.05);
    rig.wish[1].button = true;
    rig.go(1, rig.on_line(0, 0.15, -0.006), 0.03);
    const Vector3 direction = (rig.on_line(0, 0.8, -0.005) - rig.wish[1].tip).normalized();
    for (int i = 0; i < 160; ++i) {
        rig.wish[1].tip += 1.5e-4 * direction;
        rig.step();
        kept.outputs.push_back(rig.outputs);
        StateHash hash;
        rig.sheet().hash(hash);
        rig.world.find<BowelPart>()->hash(hash);
        kept.hashes.push_back(hash.value());
    }
    return kept;
}

TEST(SeptaWorld, SameInputGivesTheSameBits) {
    test::SeptaRig one, two;
    const Kept a = dissect(one), b = dissect(two);
    EXPECT_EQ(a.hashes, b.hashes);
    EXPECT_EQ(one.hash, two.hash);
    EXPECT_GT(one.count(EventKind::cut_advance), 15);
}

// A save in the middle of a dissection restores.
TEST(SeptaWorld, SaveInTheMiddleOfADissectionRestores) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.008);
    rig.divide(0, 0.05, 0.3);
    ASSERT_EQ(rig.hand(1).touch, BladeTouch::cutting);
    const std::shared_ptr<const World::Saved> saved = rig.world.save();
    ASSERT_NE(saved, nullptr);
    const std::uint64_t version = rig.sheet().surface().version();
    Kept kept;
    for (int i = 0; i < 120; ++i) {
        rig.wish[1].tip = rig.on_line(0, 0.3 + 0.003 * i, -0.005);
        rig.step();
        kept.outputs.push_back(rig.outputs);
        StateHash hash;
        rig.sheet().hash(hash);
        rig.world.find<BowelPart>()->hash(hash);
        kept.hashes.push_back(hash.value());
    }
    EXPECT_GT(rig.sheet().surface().version(), version + 10) << "cutting must continue";
    World fresh(rig.scene, 1);
    for (World* world : {&rig.world, &fresh}) {
        world->restore(*saved);
        EXPECT_EQ(world->find<SheetPart>()->surface().version(), version);
        for (std::size_t i = 0; i < kept.outputs.size(); ++i) {
            world->step(kept.outputs[i].data(), kept.outputs[i].size());
            StateHash hash;
            world->find<SheetPart>()->hash(hash);
            world->find<BowelPart>()->hash(hash);
            ASSERT_EQ(hash.value(), kept.hashes[i])
                << (world == &fresh ? "in a new world, step " : "in the same world, step ") << i;
        }
    }
}

// docs/METRICS.md, energy_safe: activation in the mesorectum is off target, whether the blade came there
// directly or was drawn out of the plane.
TEST(SeptaEnergy, EnergyOnMesorectalFatIsOffTarget) {
    test::SeptaRig rig;
    rig.take_rectum();
    rig.lift(0.008);
    const double fat = rig.scene.septa->areolar_height - rig.scene.septa->plane_height;
    int on_plane = 0, on_fat = 0;
    const auto watch = [&] {
        const FieldView& field = rig.world.snapshot().field[0];
        const SheetHand& hand = rig.hand(1);
        if (!field.tools[1].active || hand.touch != BladeTouch::cutting) return;
        const double height = rig.sheet().rest(hand.place).y();
        if (field.tools[1].target == EnergyTarget::sheet) {
            ++on_plane;
            EXPECT_LT(height, fat);
        } else if (field.tools[1].target == EnergyTarget::fat) {
            ++on_fat;
            EXPECT_GE(height, fat);
        }
    };
    rig.set_on(0, 0.3);
    rig.wish[1].energy = true;
    for (int i = 0; i < 300; ++i) {
        const Vector3 up = -0.00005 * std::max(0, i - 100) * rig.curve.posterior(rig.arc_length(0));
        rig.wish[1].tip = rig.on_line(0, 0.3 + 0.001 * i, 0.003 - std::min(0.009, 0.0003 * i)) + up;
        rig.step();
        watch();
    }
    EXPECT_GT(on_plane, 30);
    EXPECT_GT(on_fat, 30);
}

TEST(SeptaWorld, AnExchangeEndsTheCutHoweverShortItIs) {
    Scene scene = test::septa_scene();
    scene.structures->exchange_time = 0;
    test::SeptaRig rig(scene);
    rig.take_rectum();
    rig.lift(0.008);
    rig.divide(0, 0.05, 0.3);
    ASSERT_EQ(rig.hand(1).touch, BladeTouch::cutting);
    rig.wish[1].exchange = true;
    rig.steps(4);
    EXPECT_EQ(rig.world.snapshot().field[0].tools[1].kind, InstrumentKind::suction);
    EXPECT_NE(rig.hand(1).touch, BladeTouch::cutting) << "its button is still pressed";
    EXPECT_EQ(rig.count(EventKind::cut_end), rig.count(EventKind::cut_begin));
}

}  // namespace
}  // namespace fulcrum
