// SPDX-License-Identifier: Apache-2.0
// A regrasp takes again what was let go of within 2 s: the same patch, or the same place of a sheet.
#include <gtest/gtest.h>

#include "tests/assessment/task/monitor_bench.h"

namespace fulcrum {
namespace {

using monitor_bench::Bench;

/// The left hand on a sheet, which has no patches.
struct SheetBench : Bench {
    explicit SheetBench(const std::string& task_file = "B2.json") : Bench(task_file) {
        ticks(scene.ticks_per_step);
    }
    /// Takes a place, m at rest, and holds it.
    void take(const Vector3& rest, HeldBody body = HeldBody::sheet) {
        GraspState& state = world.grasps[static_cast<int>(Hand::left)];
        state.body = body;
        state.offset = rest;
        grasp(Hand::left, 0, -1);
    }
    int regrasps() const { return events.count(EventKind::regrasp); }
};

TEST(Regrasp, OnASheetIsAPlaceNearerThanTheJawsAreLong) {
    SheetBench bench;
    const double jaws = bench.scene.instrument(Hand::left)->jaw_length;
    ASSERT_GT(jaws, 0.005);
    bench.take(Vector3::Zero());
    bench.let_go(Hand::left);
    bench.take(Vector3(1.01 * jaws, 0, 0));
    EXPECT_EQ(bench.regrasps(), 0) << "further along";
    bench.let_go(Hand::left);
    bench.take(Vector3(1.01 * jaws, 0.99 * jaws, 0));
    EXPECT_EQ(bench.regrasps(), 1);
}

TEST(Regrasp, IsNotAGraspOfTheNextSeptum) {
    SheetBench bench("C4.json");
    const double width = bench.scene.septa.value().width,
                 jaws = bench.scene.instrument(Hand::left)->jaw_length;
    ASSERT_GT(jaws, 0.006);
    bench.take(Vector3(width - 0.001, 0.003, 0));
    bench.let_go(Hand::left);
    bench.take(Vector3(width + 0.002, 0.003, 0));
    EXPECT_EQ(bench.regrasps(), 0) << "the other end of the next level";
    bench.let_go(Hand::left);
    bench.take(Vector3(width + 0.005, 0.003, 0));
    EXPECT_EQ(bench.regrasps(), 1) << "the same level";
}

TEST(Regrasp, IsNotAGraspOfAnotherBodyNorOfAMembrane) {
    SheetBench bench;
    bench.take(Vector3::Zero());
    bench.let_go(Hand::left);
    bench.take(Vector3::Zero(), HeldBody::membrane);
    EXPECT_EQ(bench.regrasps(), 0) << "a membrane after a sheet";
    bench.let_go(Hand::left);
    bench.take(Vector3::Zero(), HeldBody::membrane);
    EXPECT_EQ(bench.regrasps(), 0) << "nobody knows where on the membrane";
}

TEST(Regrasp, WindowOfTwoSecondsExcludesPauses) {
    for (const double seconds : {1.9, 2.1}) {
        Bench bench("B1.json");
        bench.ticks(bench.scene.ticks_per_step);
        bench.grasp(Hand::right, 0.3, 12);
        bench.let_go(Hand::right);
        bench.sample.rig_flags = rig_paused;
        bench.ticks(10000);
        bench.sample.rig_flags = 0;
        bench.ticks(static_cast<int>(std::lround(seconds * 1000)));
        bench.grasp(Hand::right, 0.3, 12);
        EXPECT_EQ(bench.events.count(EventKind::regrasp), seconds < 2 ? 1 : 0) << seconds;
    }
}

TEST(Regrasp, DoesNotReachIntoAnAttemptThatContinuesThisOne) {
    Bench bench("B1.json");
    bench.ticks(1000);
    bench.grasp(Hand::right, 0.3, 12);
    bench.let_go(Hand::right);
    bench.monitor.begin_again();
    bench.grasp(Hand::right, 0.3, 12);
    EXPECT_EQ(bench.events.count(EventKind::regrasp), 0) << "it was let go of in the attempt before";
    bench.let_go(Hand::right);
    bench.grasp(Hand::right, 0.3, 12);
    EXPECT_EQ(bench.events.count(EventKind::regrasp), 1);
}

}  // namespace
}  // namespace fulcrum
