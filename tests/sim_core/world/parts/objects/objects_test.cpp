// SPDX-License-Identifier: Apache-2.0
// Rings on a tray in the world of A3: taken, lifted, handed over, put down, dropped, pushed. The hands move
// as scripts say; forces and events are read as the record has them.
#include <gtest/gtest.h>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/parts/objects/objects_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr int left = 0, right = 1;

Scene ring_scene() {
    return load_scene(test::source_path("assets/scenes/a3_rings.json"));
}

struct RingRig : test::SheetRig {
    explicit RingRig(const Scene& of = ring_scene()) : SheetRig(of) {}

    const ObjectsView& view() const { return world.snapshot().objects; }
    const ObjectView& ring(int i) const { return view().objects[static_cast<std::size_t>(i)]; }
    const GraspState& grasp(int hand) const { return world.snapshot().grasps[hand]; }
    double weight() const { return scene.objects->mass * 9.81; }

    /// Middle of the tube that is nearest to where a hand comes from.
    Vector3 tube(int hand, int i) const {
        const std::vector<Vector3>& corners = view().corners;
        Vector3 best = ring(i).position;
        double use = -1e9;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vector3 arm = ring(i).rotation * (0.5 * (corners[k] + corners[(k + 1) % corners.size()]));
            if (arm.dot(trocar[hand].position - ring(i).position) <= use) continue;
            use = arm.dot(trocar[hand].position - ring(i).position);
            best = ring(i).position + arm;
        }
        return best;
    }
    void grasp_ring(int hand, int i) {
        const Vector3 out = (trocar[hand].position - ring(i).position).normalized();
        go(hand, tube(hand, i) + 0.03 * out, 0.2);
        go(hand, tube(hand, i) + Vector3(0, 0, 0.001), 0.05);
        wish[hand].closed = true;
        steps(30);
    }
    void move(int hand, const Vector3& by, double speed = 0.05) { go(hand, wish[hand].tip + by, speed); }
    /// N, of a hand's last tick.
    double felt(int hand) const {
        const auto& force = outputs.back().sample.hand[hand].force;
        return sample_force_unit * Vector3(force[0], force[1], force[2]).norm();
    }
    void lift(int hand, int i) {
        grasp_ring(hand, i);
        move(hand, Vector3(0, 0, 0.03));
        steps(100);
    }
    void hand_over(int from, int to, int i) {
        lift(from, i);
        go(from, wish[from].tip + view().centre + Vector3(0, 0, 0.04) - ring(i).position, 0.05);
        steps(40);
        grasp_ring(to, i);
        wish[from].closed = false;
        steps(30);
        move(from, 0.03 * (trocar[from].position - wish[from].tip).normalized());
    }
};

TEST(Objects, LieStillAroundTheirPegsFromTheStart) {
    RingRig rig;
    rig.steps(200);
    ASSERT_EQ(rig.view().objects.size(), 6U);
    ASSERT_EQ(rig.view().pegs.size(), 12U);
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(rig.ring(i).peg, i);
        EXPECT_EQ(rig.view().pegs[static_cast<std::size_t>(i)].side, Hand::left);
        EXPECT_EQ(rig.view().pegs[static_cast<std::size_t>(i + 6)].side, Hand::right);
        EXPECT_LT(rig.ring(i).velocity.norm(), 1e-4);
        EXPECT_NEAR(rig.ring(i).height, 0, 2e-4);
    }
    EXPECT_EQ(rig.record.outcome, 0U);
}

TEST(Objects, AreTakenByTheNearestTubeLiftedAndFeltByTheirWeight) {
    RingRig rig;
    rig.lift(left, 3);
    ASSERT_TRUE(rig.grasp(left).held);
    EXPECT_EQ(rig.grasp(left).body, HeldBody::object);
    EXPECT_EQ(rig.grasp(left).patch, 3);
    EXPECT_FALSE(rig.grasp(right).held);
    EXPECT_GT(rig.ring(3).height, 0.02);
    EXPECT_EQ(rig.ring(3).peg, -1);
    // A ring that hangs still weighs in the hand what it weighs.
    EXPECT_NEAR(rig.felt(left), rig.weight(), 0.15 * rig.weight());
    for (int i = 0; i < 6; ++i) {
        if (i != 3) {
            EXPECT_EQ(rig.ring(i).peg, i);
        }
    }
}

TEST(Objects, GoFromHandToHandInTheAir) {
    RingRig rig;
    rig.hand_over(left, right, 3);
    EXPECT_FALSE(rig.grasp(left).held);
    ASSERT_TRUE(rig.grasp(right).held);
    EXPECT_EQ(rig.grasp(right).patch, 3);
    EXPECT_GT(rig.ring(3).height, 0.01);
    EXPECT_EQ(rig.count(EventKind::drop), 0);
    rig.steps(100);
    EXPECT_NEAR(rig.felt(right), rig.weight(), 0.2 * rig.weight());
}

TEST(Objects, HeldByBothHandsPullOnNeitherOnceTheyAreStill) {
    RingRig rig;
    rig.lift(left, 3);
    rig.grasp_ring(right, 3);
    rig.steps(100);
    ASSERT_TRUE(rig.grasp(left).held && rig.grasp(right).held);
    EXPECT_LT(rig.felt(left), 3);
    EXPECT_LT(rig.felt(right), 3);
    // Pulled apart: never more than the faces hold, then one of them slips.
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
        rig.wish[left].tip += Vector3(1e-4, 0, 0);
        rig.step();
        largest = std::max({largest, rig.grasp(left).reaction.norm(), rig.grasp(right).reaction.norm()});
    }
    EXPECT_LT(largest, 2 * 0.4 * 8.0 * 1.3);  // 2 mu N, and the ring's own jerk
    EXPECT_FALSE(rig.grasp(left).held && rig.grasp(right).held);
}

TEST(Objects, AreDroppedWhenLetGoInTheAirOnly) {
    RingRig rig;
    rig.lift(left, 3);
    rig.move(left, Vector3(-0.04, 0.012, 0.01));
    rig.wish[left].closed = false;
    rig.steps(30);
    ASSERT_EQ(rig.count(EventKind::drop), 1);
    for (const Event& event : rig.events) {
        if (event.kind != EventKind::drop) continue;
        EXPECT_EQ(event.hand, left);
        EXPECT_EQ(event.detail, 3);
        EXPECT_GT(event.value, 0.01);
    }
    rig.steps(300);
    EXPECT_LT(rig.ring(3).height, 3e-4);
    EXPECT_LT(rig.ring(3).velocity.norm(), 5e-3);
    // Put down on the tray, it is not dropped.
    rig.move(left, Vector3(0.01, 0, 0.02), 0.2);
    rig.grasp_ring(left, 3);
    ASSERT_TRUE(rig.grasp(left).held);
    rig.move(left, Vector3(0, 0, 0.02));
    rig.move(left, Vector3(0, 0, -0.0205));
    rig.wish[left].closed = false;
    rig.steps(30);
    EXPECT_FALSE(rig.grasp(left).held);
    EXPECT_EQ(rig.count(EventKind::drop), 1);
}

TEST(Objects, LetGoAroundAPegSlideDownItWithoutADrop) {
    RingRig rig;
    const Vector3 start = rig.ring(2).position;
    rig.lift(left, 2);
    const Vector3 above = rig.view().pegs[2].top + Vector3(0, 0, 0.004);
    rig.go(left, rig.wish[left].tip + above - rig.ring(2).position, 0.05);
    rig.steps(40);
    rig.move(left, Vector3(0, 0, -0.010));
    ASSERT_EQ(rig.ring(2).peg, 2);
    ASSERT_GT(rig.ring(2).height, ObjectsPart::drop_height);
    rig.wish[left].closed = false;
    rig.steps(200);
    EXPECT_EQ(rig.count(EventKind::drop), 0);
    EXPECT_EQ(rig.ring(2).peg, 2);
    EXPECT_LT((rig.ring(2).position - start).norm(), 0.01);
    EXPECT_LT(rig.ring(2).height, 0.003);
}

TEST(Objects, ClosedJawsPushARingAndOpenOnesPass) {
    for (const bool closed : {true, false}) {
        RingRig rig;
        rig.lift(left, 0);
        rig.move(left, Vector3(-0.015, 0.0, 0));
        rig.wish[left].closed = false;  // dropped between the groups, where no peg holds it
        rig.steps(300);
        const Vector3 before = rig.ring(0).position;
        const Vector3 target = before + Vector3(0.02, 0, 0.0015);
        rig.wish[left].closed = false;
        rig.go(left, target + Vector3(0, 0, 0.03), 0.2);
        rig.wish[left].closed = closed;
        rig.steps(20);
        rig.go(left, target, 0.1);
        rig.move(left, Vector3(-0.02, 0, 0), 0.05);
        const double way = (rig.ring(0).position - before).norm();
        if (closed) {
            EXPECT_GT(way, 0.004);
        } else {
            EXPECT_LT(way, 0.012);
        }
        EXPECT_EQ(rig.record.outcome, 0U);
    }
}

// The left hand holds a ring in the air; the right shaft pushes it from the side, 25 mm behind its tip.
TEST(Objects, PushedByAShaftPushBackWhereTheShaftIs) {
    RingRig rig;
    rig.lift(left, 3);
    rig.move(left, Vector3(0, 0, 0.03));
    rig.steps(40);
    rig.wish[right].closed = true;
    const Vector3 middle = rig.ring(3).position;
    const Vector3 along = (middle - rig.trocar[right].position).normalized();
    const Vector3 aside = along.cross(Vector3::UnitZ()).normalized();
    const Vector3 beyond = middle + 0.025 * along;
    rig.go(right, beyond + 0.035 * aside, 0.2);
    rig.steps(30);
    ASSERT_TRUE(rig.grasp(left).held);
    ASSERT_FALSE(rig.grasp(right).held);
    const auto push = [&] { return rig.world.local_models().hand[right].jaws; };
    for (int i = 0; i < 150 && push().force.norm() < 0.3; ++i) rig.move(right, -2.5e-4 * aside);
    const JawPushModel model = push();
    ASSERT_GT(model.force.norm(), 0.2);

    // Where the shaft is nearest to a tube.
    const ToolKinematics& tool = rig.outputs.back().contact[right].tool;
    const Vector3 tip = tool.tip, trocar = tool.trocar;
    const std::vector<Vector3>& corners = rig.view().corners;
    double nearest = 1, back = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto corner = [&](std::size_t c) {
            return Vector3(rig.ring(3).position + rig.ring(3).rotation * corners[c % corners.size()]);
        };
        const SegmentPair pair =
            closest_points_of_segments(corner(k), corner(k + 1), tip - 0.05 * tool.axis, tip);
        if ((pair.on_first - pair.on_second).norm() >= nearest) continue;
        nearest = (pair.on_first - pair.on_second).norm();
        back = (tip - pair.on_second).norm();
    }
    EXPECT_GT(back, 0.010);
    EXPECT_NEAR(model.back, back, 0.004);
    EXPECT_LT((model.place - (tip - model.back * tool.axis)).norm(), 1e-9);

    // The record's torque, in the next ticks with the hand still, is that of a force there.
    rig.step();
    const HandSample& record = rig.outputs.back().sample.hand[right];
    const Vector3 force = sample_force_unit * Vector3(record.force[0], record.force[1], record.force[2]);
    const Vector3 torque = sample_torque_unit * Vector3(record.torque[0], record.torque[1], record.torque[2]);
    EXPECT_LT((force - model.force).norm(), 0.02);
    const double by_tip = (tip - trocar).cross(force).norm(),
                 by_place = (model.place - trocar).cross(force).norm();
    EXPECT_LT((torque - (model.place - trocar).cross(force)).norm(), 0.1 * (by_tip - by_place) + 1e-4);
}

TEST(Objects, StayOutOfTheTrayWhateverTheHandsDo) {
    RingRig rig;
    rig.lift(left, 3);
    // Pressed into the tray by 20 mm, with the hand's whole strength.
    rig.move(left, Vector3(0, 0, -0.05), 0.1);
    rig.steps(50);
    for (int i = 0; i < 6; ++i) EXPECT_GT(rig.ring(i).height, -0.002);
    EXPECT_EQ(rig.record.outcome, 0U);
    EXPECT_TRUE(std::isfinite(rig.felt(left)));
    EXPECT_GT(rig.felt(left), 0.5);  // the tray is felt
}

TEST(Objects, TheTrayAndItsPegsStopAnInstrument) {
    RingRig rig;
    rig.wish[left].closed = true;
    const Vector3 free_place = rig.view().centre;
    rig.go(left, free_place + Vector3(0, 0, 0.03), 0.2);
    EXPECT_EQ(rig.felt(left), 0);
    rig.go(left, free_place, 0.05);
    EXPECT_GT(rig.felt(left), 0.8);
    const auto& record = rig.outputs.back().sample.hand[left];
    EXPECT_EQ(record.tissue, rig.scene.tissue_index("tray"));
    rig.go(left, free_place + Vector3(0, 0, 0.03), 0.2);
    // Against a peg's side, above the ring that lies around it.
    const PegView peg = rig.view().pegs[8];
    const Vector3 beside = 0.5 * (peg.foot + peg.top) + Vector3(0, 0, 0.003);
    rig.go(left, beside + Vector3(0.02, 0, 0), 0.2);
    EXPECT_EQ(rig.felt(left), 0);
    rig.go(left, beside + Vector3(0.002, 0, 0), 0.05);
    EXPECT_GT(rig.felt(left), 0.3);
}

TEST(Objects, AStepAllocatesNothing) {
    RingRig rig;
    rig.lift(left, 3);
    rig.grasp_ring(right, 3);
    const std::uint64_t before = test::allocation_count();
    for (int i = 0; i < 100; ++i) rig.world.step(rig.outputs.data(), rig.outputs.size());
    EXPECT_EQ(test::allocation_count() - before, 0U);
}

TEST(Objects, ASceneThatCannotBeIsRefusedWithPlaceAndHint) {
    const std::string text = [] {
        std::ifstream file(test::source_path("assets/scenes/a3_rings.json"));
        return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        changed.replace(changed.find(from), from.size(), to);
        try {
            parse_scene(changed, "rings.json");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string count = "\"count\": 6";
    EXPECT_EQ(refusal(count, count), "");
    EXPECT_NE(refusal(count, "\"count\": 7").find("/objects/count"), std::string::npos);
    EXPECT_NE(refusal(count, count + ", \"peg_radius\": 0.005").find("/objects/corner_radius"),
              std::string::npos);
    EXPECT_NE(refusal(count, count + ", \"spacing\": 0.015").find("/objects/spacing"), std::string::npos);
    EXPECT_NE(refusal(count, count + ", \"half_length\": 0.03").find("/objects/half_length"),
              std::string::npos);
    EXPECT_NE(refusal("\"tissue\": \"object\"", "\"tissue\": \"rubber\"").find("/objects"),
              std::string::npos);
    const std::string targets =
        R"("targets": {"per_hand": 1, "radius": 0.006, "centre": [0, 0, 0], "half_extent": [0.05, 0.04, 0.03],
            "minimum_distance": 0.02, "tissue": "object"}, )";
    EXPECT_NE(refusal("\"objects\"", targets + "\"objects\"").find("/objects"), std::string::npos);
}

TEST(Objects, AreNotPassedByAnInstrumentWhoseDeviceDidNotAnswer) {
    RingRig rig;
    rig.lift(left, 0);
    rig.move(left, Vector3(-0.015, 0.0, 0));
    rig.wish[left].closed = false;  // dropped between the groups, where no peg holds it
    rig.steps(300);
    const Vector3 target = rig.ring(0).position + Vector3(0.02, 0, 0.0015);
    rig.go(left, target + Vector3(0, 0, 0.03), 0.2);
    rig.wish[left].closed = true;
    rig.steps(20);
    rig.go(left, target, 0.1);
    const Vector3 before = rig.ring(0).position;
    for (int i = 0; i < 120 && (rig.ring(0).position - before).norm() < 0.001; ++i)
        rig.move(left, Vector3(-2.5e-4, 0, 0));
    rig.steps(20);
    const Vector3 pushed = rig.ring(0).position;
    ASSERT_LT(pushed.x(), before.x() - 0.0005) << "it is pushed";
    rig.wish[left].silent = true;
    rig.move(left, Vector3(-0.007, 0, 0), 0.2);
    EXPECT_LT((rig.ring(0).position - pushed).norm(), 0.001) << "the instrument stays where it was";
    rig.wish[left].silent = false;
    rig.steps(40);
    EXPECT_LT(rig.ring(0).position.x(), pushed.x() - 0.003) << "the tube is pushed along";
}

}  // namespace
}  // namespace fulcrum
