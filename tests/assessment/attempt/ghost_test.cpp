// SPDX-License-Identifier: Apache-2.0
// The ghost of an expert keeps the trainee's pace.
#include "assessment/attempt/ghost.h"

#include <gtest/gtest.h>

#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// One hand along x, 1 mm a point, for two goals of 200 points each; the other hand is outside.
std::shared_ptr<const GhostPath> straight_path() {
    auto path = std::make_shared<GhostPath>();
    for (int i = 0; i < 400; ++i) {
        GhostPoint point;
        point.tools[0].tip = Vector3(0.001 * i, 0, 0);
        point.tools[0].inside = true;
        point.tools[1].inside = false;
        point.goal = i < 200 ? 0 : 1;
        path->points.push_back(point);
    }
    return path;
}

struct Trainee {
    ToolPose tools[hand_count];
    explicit Trainee(double x, double y = 0) {
        tools[0].tip = Vector3(x, y, 0);
        tools[0].inside = true;
        tools[1].inside = false;
    }
};

double shown(GhostPace& pace, const Trainee& trainee, int goal = 0) {
    return pace.follow(trainee.tools, goal).tools[0].tip.x();
}

TEST(GhostPaceOnAPath, IsALittleAheadAndWaits) {
    GhostPace pace(straight_path());
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(shown(pace, Trainee(0.001 * i)), 0.001 * i + 0.03, 1e-9) << i;
    for (int i = 0; i < 1000; ++i) EXPECT_NEAR(shown(pace, Trainee(0.099)), 0.129, 1e-9) << "it waits";
    EXPECT_NEAR(shown(pace, Trainee(0.05)), 0.129, 1e-9) << "it does not go back";
    EXPECT_NEAR(shown(pace, Trainee(0.15, 0.05)), 0.129, 1e-9) << "5 cm off the path: it waits";
}

TEST(GhostPaceOnAPath, StaysWithinTheTraineesGoal) {
    GhostPace pace(straight_path());
    for (int i = 0; i < 200; ++i) shown(pace, Trainee(0.001 * i));
    EXPECT_NEAR(shown(pace, Trainee(0.199)), 0.199, 1e-9) << "the end of the goal's part";
    EXPECT_NEAR(shown(pace, Trainee(0.199), 1), 0.23, 2e-3) << "the next goal begins";
    GhostPace late(straight_path());
    EXPECT_GE(shown(late, Trainee(0.0), 1), 0.2) << "the trainee's goal counts, not the ghost's";
}

TEST(GhostPaceOnAPath, JoinsATraineeAfterAShortCut) {
    GhostPace pace(straight_path());
    EXPECT_NEAR(shown(pace, Trainee(0.15)), 0.18, 1e-9);
}

TEST(GhostOfAnExpert, HasEveryGoalAndStopsWhenAsked) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const auto path = make_ghost(scene, task, 7, [] { return true; });
    ASSERT_TRUE(path);
    ASSERT_GT(path->points.size(), 500U);
    EXPECT_EQ(path->points.front().goal, 0);
    EXPECT_EQ(path->points.back().goal, 1);
    for (std::size_t i = 1; i < path->points.size(); ++i)
        EXPECT_GE(path->points[i].goal, path->points[i - 1].goal);
    // An expert who follows the ghost takes it to its end.
    GhostPace pace(path);
    for (const GhostPoint& point : path->points) pace.follow(point.tools, point.goal);
    EXPECT_GT(pace.place() + GhostPace::window, path->points.size());
    int asked = 0;
    EXPECT_FALSE(make_ghost(scene, task, 7, [&] { return ++asked < 3; }));
}

TEST(GhostOfAnExpert, ChangesNothingOfTheAttemptThatShowsIt) {
    const TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    const Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    const auto path = make_ghost(scene, task, 7, [] { return true; });
    const auto run = [&](bool with_ghost) {
        AttemptEngine engine(scene, task, 7);
        GhostPace pace(path);
        RigSample input;
        std::vector<TickOutput> outputs;
        class Sink : public AttemptSink {
          public:
            void on_event(const Event& /*event*/) noexcept override {}
            void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
            void on_step(const StepRecord& /*step*/) noexcept override {}
        } sink;
        for (std::uint32_t tick = 1; tick <= 500; ++tick) {
            input.tick = tick;
            outputs.push_back(engine.tick(input));
            if (tick % 5 != 0) continue;
            engine.step(outputs.data(), outputs.size(), sink);
            engine.adopt(engine.world().local_models());
            if (with_ghost) pace.follow(engine.world().snapshot().tools, engine.display().goal);
            outputs.clear();
        }
        return engine.state_hash();
    };
    EXPECT_EQ(run(true), run(false));
}

}  // namespace
}  // namespace fulcrum
