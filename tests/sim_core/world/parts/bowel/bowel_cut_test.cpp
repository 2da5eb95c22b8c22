// SPDX-License-Identifier: Apache-2.0
// The bowel's wall cut in the world: scissors through the complete chain of device, tick, world and surface;
// the force to the hand, grasps across a cut, saving and replay.
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "tests/sim_core/world/parts/bowel/bowel_cut_rig.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "sim_core/numerics/random.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

using test::BowelCutRig;

constexpr double limit = 0.3 * (1 + 1e-9);  // N in a tick of 1 ms

void expect_sound(BowelCutRig& rig) {
    const std::vector<Vector3> positions = rig.positions();
    const CutMesh& surface = rig.cut().skin().surface();
    const CutCheck check = check_cut(surface, positions.data());
    EXPECT_TRUE(check.passed()) << check.complaint();
    EXPECT_NEAR(surface.area_before(), surface.area_visible() + surface.area_removed(),
                1e-9 * surface.area_before());
}

// Eqs. 6 and 7: enough force across, enough along, button pressed.
TEST(BowelCut, BladeEntersByEquationSevenAndTheCutFollowsIt) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0.02, 0, 0));
    const Vector3 start = rig.top_now();
    rig.go(1, start + Vector3(0, 0, 0.015), 0.2);
    rig.go(1, start + Vector3(0, 0, 0.0012), 0.05);
    rig.go(1, start + Vector3(-0.006, 0, 0), 0.03);
    EXPECT_EQ(rig.count(EventKind::cut_begin), 0) << "without its button";
    rig.wish[1].button = true;
    rig.go(1, start + Vector3(-0.008, 0, 0.0022), 0.03);
    EXPECT_EQ(rig.count(EventKind::cut_begin), 0) << "hardly touching";
    rig.wish[1].button = false;
    rig.go(1, start + Vector3(0, 0, 0.015), 0.2);
    EXPECT_TRUE(rig.cut().skin().whole());

    rig.cut_by_hand(Vector3(-0.02, 0, 0));
    EXPECT_EQ(rig.count(EventKind::cut_begin), 1);
    EXPECT_GE(rig.count(EventKind::cut_advance), 8);
    EXPECT_EQ(rig.blade().touch, BladeTouch::cutting);
    EXPECT_LE(rig.sent[1].norm(), 0.08 + 0.01) << "the hand feels the dynamic friction";
    EXPECT_EQ(rig.world.local_models().hand[1].topology_version, rig.cut().skin().version());
    rig.wish[1].button = false;
    rig.steps(2);
    EXPECT_EQ(rig.count(EventKind::cut_end), 1);
    expect_sound(rig);
    const CutMesh& surface = rig.cut().skin().surface();
    EXPECT_EQ(rig.count(EventKind::cut_rolled_back), 0);
    // Its position, reported along the bowel and around it.
    double first = 0, last = 0;
    for (const Event& event : rig.events) {
        if (event.kind == EventKind::cut_begin) first = event.value;
        if (event.kind == EventKind::cut_advance) last = event.value;
    }
    const double length = std::abs(last - first);
    std::printf("length along the bowel %.4f m, removed %.3g m2\n", length, surface.area_removed());
    EXPECT_GT(surface.area_removed(), 0.5 * length * rig.scene.bowel->blade_width);
    EXPECT_LT(surface.area_removed(), 0.03 * rig.scene.bowel->blade_width);
    const BowelCutView& view = rig.world.snapshot().bowel.cut;
    EXPECT_EQ(view.visible_area, surface.area_visible());
    const auto hidden = std::count(view.hidden.begin(), view.hidden.end(), 1);
    EXPECT_GT(hidden, 5);
    EXPECT_EQ(view.triangle_count + surface.root_count() - hidden, surface.visible_count());
}

TEST(BowelCut, CutLiftAndPushOfTheLipStayWithinTheSlewLimit) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0.02, 0, 0));
    rig.worst_change = 0;
    const auto felt = [&](const char* what) {
        EXPECT_LE(rig.worst_change, limit) << what;
        std::printf("%-24s change %.3f N/ms, largest %.3f N\n", what, rig.worst_change, rig.largest_force);
        rig.worst_change = rig.largest_force = 0;
    };
    const Vector3 start = rig.top_now();
    rig.cut_by_hand(Vector3(-0.015, 0, 0));
    ASSERT_EQ(rig.blade().touch, BladeTouch::cutting);
    felt("cut");
    rig.wish[1].button = false;
    rig.go(1, start + Vector3(-0.015, 0, 0.02), 0.1);
    EXPECT_EQ(rig.blade().touch, BladeTouch::away);
    felt("lift the blade");
    rig.go(0, rig.wish[0].tip + Vector3(0, 0, 0.008), 0.05);
    felt("lift the wall");
    // Pressed on the slit: it is narrower than the tool, so the tip does not fall through.
    const Vector3 middle = rig.top_now();
    rig.go(1, middle + Vector3(-0.006, 0, 0.01), 0.2);
    rig.go(1, middle + Vector3(-0.006, 0, 0.0005), 0.05);
    EXPECT_GT(rig.sent[1].norm(), 0.15);
    EXPECT_GT(rig.blade().cover, 0.5);
    felt("press the slit");
    for (const double y : {0.004, -0.004}) {
        rig.go(1, middle + Vector3(-0.006, y, 0.0), 0.06);
        felt("across the lips");
    }
    rig.go(1, middle + Vector3(-0.006, 0, 0.02), 0.1);
    felt("lift off");
    EXPECT_EQ(rig.sent[1].norm(), 0.0);
    expect_sound(rig);
}

TEST(BowelCut, DiscFallsAndLeavesAHoleWithLipsThatTouchTheShaft) {
    BowelCutRig rig;
    const CutSkin::Report disc = rig.cut_circle(rig.top, 0.007);
    ASSERT_EQ(disc.parted, 1);
    EXPECT_GT(disc.parted_area, 1.0e-4);
    EXPECT_LT(disc.parted_area, 2.2e-4);
    const Vector3 hole = rig.top_now();
    rig.step();
    EXPECT_EQ(rig.cut().skin().fallen(), 1);
    EXPECT_GT(std::count_if(rig.world.snapshot().bowel.cut.triangle_loose.begin(),
                            rig.world.snapshot().bowel.cut.triangle_loose.end(),
                            [](std::uint8_t k) { return k != 0; }),
              20);
    const double before = rig.cut().skin().surface().area_removed();
    const Vector3 in = (hole - rig.trocar[1].position).normalized();
    rig.go(1, hole - 0.03 * in, 0.2);
    rig.worst_change = rig.largest_force = 0;
    rig.go(1, hole + 0.009 * in, 0.05);  // through it
    EXPECT_LE(rig.largest_force, 0.05) << "the fallen piece carries no force";
    EXPECT_EQ(rig.blade().touch, BladeTouch::clearing);
    rig.go(1, hole + 0.009 * in + Vector3(0.002, 0, 0), 0.03);
    EXPECT_LE(rig.largest_force, 0.05) << "the hole is open";
    rig.go(1, hole + 0.009 * in + Vector3(0.025, 0, 0), 0.03);
    std::printf("lip %.3f N, change %.3f\n", rig.sent[1].norm(), rig.worst_change);
    EXPECT_GT(rig.sent[1].norm(), 0.05) << "the lip";
    EXPECT_LT(rig.sent[1].x(), 0);
    rig.go(1, hole + 0.009 * in, 0.03);
    rig.go(1, hole - 0.03 * in, 0.05);
    EXPECT_EQ(rig.blade().touch, BladeTouch::away);
    EXPECT_LE(rig.worst_change, limit);
    EXPECT_NEAR(rig.cut().skin().surface().area_removed(), before + disc.parted_area, 1e-9)
        << "fallen and removed";
    expect_sound(rig);
}

// The lip of a hole drags at the shaft where it goes through the wall, not at the tip beyond.
TEST(BowelCut, LipHasTheLeverOfThePlaceOfTheShaftThatItTouches) {
    BowelCutRig rig;
    ASSERT_EQ(rig.cut_circle(rig.top, 0.007).parted, 1);
    const Vector3 hole = rig.top_now();
    const Vector3 in = (hole - rig.trocar[1].position).normalized();
    rig.go(1, hole - 0.03 * in, 0.2);
    rig.go(1, hole + 0.009 * in, 0.05);
    rig.go(1, hole + 0.009 * in + Vector3(0.025, 0, 0), 0.03);
    const SheetContactModel lip = rig.world.local_models().hand[1].sheet;
    ASSERT_GE(lip.tissue, 0);
    const ToolKinematics tool = rig.outputs.back().contact[1].tool;
    EXPECT_GT(lip.back, 0.003);
    EXPECT_LT(lip.back, 0.04);
    EXPECT_LT((lip.place - (tool.tip - lip.back * tool.axis)).norm(), 1e-6);

    // The record of the next ticks, the hand still.
    rig.step();
    const HandSample& record = rig.outputs.back().sample.hand[1];
    const Vector3 force = sample_force_unit * Vector3(record.force[0], record.force[1], record.force[2]);
    const Vector3 torque = sample_torque_unit * Vector3(record.torque[0], record.torque[1], record.torque[2]);
    EXPECT_GT(force.norm(), 0.05);
    EXPECT_LT((force - lip.drag).norm(), 0.002) << "nothing else is touched";
    const Vector3 by_place = (lip.place - tool.trocar).cross(force);
    const Vector3 by_tip = (tool.tip - tool.trocar).cross(force);
    EXPECT_LT((torque - by_place).norm(), (torque - by_tip).norm());
    EXPECT_LT((torque - by_place).norm(), 0.2 * (by_tip - by_place).norm() + 1e-4);
}

TEST(BowelCut, JawsKeepRemainingTissueAndLoseRemovedTissue) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0, 0, 0));
    const GraspState& held = rig.bowel().grasp(Hand::left);
    ASSERT_TRUE(held.held);
    rig.go(0, rig.wish[0].tip + Vector3(0, 0, 0.010), 0.05);
    rig.steps(100);
    const double pull = held.reaction.norm();
    EXPECT_GT(pull, 0.1);
    // A slit through the patch.
    const Vector3 at = held.point;
    rig.worst_change = 0;
    std::int32_t under = -1;
    double least = 1;
    for (std::int32_t v = 0; v < rig.bowel().skin().vertices(); ++v) {
        const double away = (rig.now(v) - at).norm();
        if (away >= least) continue;
        least = away;
        under = v;
    }
    std::vector<std::int32_t> length;
    for (int i = 0; i <= 6; ++i) length.push_back(rig.vertex_at(under, 0.002 * (i - 3), 0));
    rig.cut_along(length);
    ASSERT_FALSE(rig.cut().skin().whole());
    rig.steps(20);
    EXPECT_TRUE(held.held);
    EXPECT_NEAR(held.reaction.norm(), pull, 0.02) << "the wall point is still held";
    EXPECT_LE(rig.worst_change, limit);
    // All of it, as a disc that falls.
    rig.worst_change = 0;
    ASSERT_GE(rig.cut_circle(under, 0.009).parted, 1);
    rig.steps(60);
    EXPECT_FALSE(held.held);
    EXPECT_TRUE(rig.world.snapshot().grasps[0].slipped) << "reported as lost, not as released";
    EXPECT_LE(rig.worst_change, limit);
    EXPECT_LE(rig.sent[0].norm(), 0.02);
    expect_sound(rig);
}

TEST(BowelCut, UncutBowelIsUnchangedBitForBit) {
    Scene plain = test::enterotomy();
    for (TissueSpec& tissue : plain.tissues) tissue.cutting.reset();
    BowelCutRig rig;
    test::SheetRig other(plain);
    EXPECT_EQ(other.world.find<BowelPart>()->cut(), nullptr);
    EXPECT_TRUE(other.world.snapshot().bowel.cut.hidden.empty());
    const Vector3 start = rig.top_now();
    for (test::SheetRig* one : {static_cast<test::SheetRig*>(&rig), &other}) {
        one->go(1, start + Vector3(0, 0, 0.015), 0.2);
        one->go(1, start + Vector3(0, 0, -0.002), 0.05);
        one->go(1, start + Vector3(0.01, 0.003, -0.002), 0.05);
    }
    EXPECT_GT(rig.sent[1].norm(), 0.1);
    EXPECT_EQ(rig.sent[1], other.sent[1]);
    for (std::size_t i = 0; i < rig.world.snapshot().bowel.nodes.size(); ++i)
        ASSERT_EQ(rig.world.snapshot().bowel.nodes[i], other.world.snapshot().bowel.nodes[i]);
}

TEST(BowelCut, ReplaysFromASavedCutBitForBit) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0.02, 0, 0));
    rig.cut_by_hand(Vector3(-0.01, 0, 0));
    ASSERT_EQ(rig.blade().touch, BladeTouch::cutting);
    const auto saved = rig.world.save();
    ASSERT_NE(saved, nullptr);
    const auto hash_of = [](const World& world) {
        StateHash hash;
        world.find<BowelPart>()->hash(hash);
        return hash.value();
    };
    std::vector<std::vector<TickOutput>> outputs;
    std::vector<std::uint64_t> hashes;
    const std::uint64_t version = rig.cut().skin().version();
    for (int i = 0; i < 60; ++i) {
        rig.wish[1].tip += Vector3(-1.5e-4, 2e-5, 0);
        rig.step();
        outputs.push_back(rig.outputs);
        hashes.push_back(hash_of(rig.world));
    }
    EXPECT_GT(rig.cut().skin().version(), version + 5);
    World fresh(rig.scene, 1);
    fresh.restore(*saved);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        fresh.step(outputs[i].data(), outputs[i].size());
        ASSERT_EQ(hash_of(fresh), hashes[i]) << i;
    }
    EXPECT_EQ(fresh.find<BowelPart>()->cut()->skin().surface().digest(), rig.cut().skin().surface().digest());
    for (int h = 0; h < hand_count; ++h)
        EXPECT_EQ(fresh.local_models().hand[h].sheet.drag, rig.world.local_models().hand[h].sheet.drag);
}

TEST(BowelCut, CuttingAllocatesNothing) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0.02, 0, 0));
    rig.cut_by_hand(Vector3(-0.005, 0, 0));
    ASSERT_EQ(rig.blade().touch, BladeTouch::cutting);
    const std::uint64_t version = rig.cut().skin().version();
    std::uint64_t allocations = 0;
    for (int i = 0; i < 40; ++i) {
        rig.wish[1].tip += Vector3(-1.5e-4, 0, 0);
        rig.step();
        allocations += test::allocations_in([&] { rig.world.step(rig.outputs.data(), rig.outputs.size()); });
    }
    EXPECT_GT(rig.cut().skin().version(), version);
    EXPECT_EQ(allocations, 0U);
}

// Hands that jump about in the bowel with their buttons pressed: everything stays finite, valid, and within
// the force limits.
TEST(BowelCut, StaysValidUnderJumpingHands) {
    BowelCutRig rig;
    Random random(7);
    rig.cut_circle(rig.top, 0.006);
    for (int i = 0; i < 150; ++i) {
        for (int h = 0; h < hand_count; ++h) {
            if (random.below(3) != 0) continue;
            rig.wish[h].tip = rig.top_now() + 0.03 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1),
                                                             random.uniform(-1, 0.6));
            rig.wish[h].button = random.below(4) != 0;
            rig.wish[h].closed = random.below(2) != 0;
        }
        rig.step();
        ASSERT_LT(rig.record.outcome, 3U) << i;
        ASSERT_TRUE(rig.sent[0].allFinite() && rig.sent[1].allFinite());
        ASSERT_LE(rig.sent[1].norm(), rig.scene.force_limit * (1 + 1e-9));
    }
    expect_sound(rig);
}

TEST(BowelCut, ABladeStaysInItsCutWhileItsDeviceDoesNotAnswer) {
    BowelCutRig rig;
    rig.hold_beside(Vector3(0.02, 0, 0));
    rig.cut_by_hand(Vector3(-0.012, 0, 0));
    ASSERT_EQ(rig.blade().touch, BladeTouch::cutting);
    const std::uint64_t version = rig.cut().skin().version();
    rig.wish[1].silent = true;
    rig.steps(3);
    EXPECT_EQ(rig.blade().touch, BladeTouch::cutting);
    EXPECT_EQ(rig.cut().skin().version(), version) << "it stays where it was";
    rig.wish[1].silent = false;
    rig.go(1, rig.wish[1].tip + Vector3(-0.008, 0, 0), 0.03);
    EXPECT_EQ(rig.blade().touch, BladeTouch::cutting);
    EXPECT_EQ(rig.count(EventKind::cut_begin), 1);
    EXPECT_EQ(rig.count(EventKind::cut_end), 0);
    EXPECT_GT(rig.cut().skin().version(), version) << "and divides what comes next";
}

}  // namespace
}  // namespace fulcrum
