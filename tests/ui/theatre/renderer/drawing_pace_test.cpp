// SPDX-License-Identifier: GPL-3.0-or-later
// DrawingPace with durations of a simulated machine: a fixed part plus a part per pixel, in ms.
#include "ui/theatre/renderer/drawing_pace.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum::ui {
namespace {

constexpr int coarsest = DrawingPace::levels - 1;
constexpr int half_minute = 1000;  // pictures

struct Machine {
    double fixed, pixels;  // ms, at the full resolution
    double picture_ms(double share) const { return fixed + pixels * share * share; }
};

/// The step after this many pictures.
int run(DrawingPace& pace, const Machine& machine, int pictures) {
    int steps = 0;
    for (int i = 0; i < pictures; ++i) steps += pace.drawn(machine.picture_ms(pace.share())) ? 1 : 0;
    return steps;
}

TEST(DrawingPace, LevelsGetCoarserFromFullResolution) {
    EXPECT_EQ(DrawingPace::share_at(0), 1);
    for (int level = 1; level < DrawingPace::levels; ++level)
        EXPECT_LT(DrawingPace::share_at(level), DrawingPace::share_at(level - 1));
    EXPECT_GT(DrawingPace::share_at(coarsest), 0.6);
    EXPECT_EQ(DrawingPace::share_at(-7), 1);
    EXPECT_EQ(DrawingPace::share_at(99), DrawingPace::share_at(coarsest));
}

TEST(DrawingPace, AFastMachineKeepsTheFullResolution) {
    DrawingPace pace;
    EXPECT_EQ(run(pace, {4, 11}, half_minute), 0);
    EXPECT_EQ(pace.level(), 0);
}

TEST(DrawingPace, SlowMachineReachesTheGoalWithinASecondAndKeepsIt) {
    DrawingPace pace;
    EXPECT_GE(run(pace, {5, 20}, 45), 1);
    EXPECT_LE(Machine({5, 20}).picture_ms(pace.share()), DrawingPace::goal_ms);
    EXPECT_LT(pace.level(), coarsest + 1);
    EXPECT_EQ(run(pace, {5, 20}, half_minute), 0);
}

TEST(DrawingPace, MachineTooSlowForEveryLevelUsesTheCoarsestAtOnce) {
    DrawingPace pace;
    EXPECT_EQ(run(pace, {20, 80}, 15), 1);
    EXPECT_EQ(pace.level(), coarsest);
    EXPECT_EQ(run(pace, {20, 80}, half_minute), 0);
}

TEST(DrawingPace, OccasionalSlowPicturesChangeNothing) {
    DrawingPace pace;
    for (int i = 0; i < half_minute; ++i) EXPECT_FALSE(pace.drawn(i % 3 == 0 ? 90 : 12)) << i;
}

TEST(DrawingPace, ItReturnsStepByStepWhenThereIsTimeAgain) {
    DrawingPace pace;
    run(pace, {10, 60}, 60);
    ASSERT_EQ(pace.level(), coarsest);
    // Not in the first seconds: a short pause does not mean a faster machine.
    EXPECT_EQ(run(pace, {3, 10}, 75), 0);
    EXPECT_EQ(run(pace, {3, 10}, half_minute), coarsest);
    EXPECT_EQ(pace.level(), 0);
}

TEST(DrawingPace, FollowsAVaryingLoadLessAndLessOften) {
    DrawingPace pace;
    const auto come_and_go = [&pace](int times) {
        int steps = 0;
        for (int i = 0; i < times; ++i) {
            steps += run(pace, {4, 20}, 45);
            steps += run(pace, {3, 8}, 150);
        }
        return steps;
    };
    const int first = come_and_go(10);
    EXPECT_GT(first, 0);
    EXPECT_LT(come_and_go(10), first);
}

TEST(DrawingPace, RestartResetsEverything) {
    DrawingPace pace, fresh;
    run(pace, {10, 60}, 67);
    pace.restart();
    EXPECT_EQ(pace.level(), 0);
    for (int i = 0; i < 40; ++i) {
        EXPECT_EQ(pace.drawn(24), fresh.drawn(24)) << i;
        EXPECT_EQ(pace.level(), fresh.level());
    }
}

TEST(DrawingPace, IgnoresInvalidDurations) {
    DrawingPace pace;
    for (int i = 0; i < 100; ++i) {
        for (const double ms : {std::nan(""), -1.0, std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()})
            EXPECT_FALSE(pace.drawn(ms));
    }
    for (int i = 0; i < 14; ++i) EXPECT_FALSE(pace.drawn(1000));
    EXPECT_TRUE(pace.drawn(1000));
}

RC_GTEST_PROP(DrawingPace, EveryEvenLoadSettlesWithinTheGoalOrAtTheCoarsestLevel, ()) {
    const Machine machine{0.01 * *rc::gen::inRange(0, 3000), 0.01 * *rc::gen::inRange(0, 10000)};
    DrawingPace pace;
    run(pace, {10, 60}, *rc::gen::inRange(0, 60));  // from anywhere
    run(pace, machine, 2 * half_minute);
    const double settled = machine.picture_ms(pace.share());
    RC_ASSERT(settled <= DrawingPace::goal_ms || pace.level() == coarsest);
    RC_ASSERT(run(pace, machine, half_minute) == 0);
    // No coarser than necessary, except for the margin required before a step up.
    if (pace.level() > 0) {
        const double finer = machine.picture_ms(DrawingPace::share_at(pace.level() - 1));
        RC_ASSERT(finer > 0.75 * DrawingPace::goal_ms);
    }
}

RC_GTEST_PROP(DrawingPace, NoiseAboutAnEvenLoadSeldomMovesIt, ()) {
    const Machine machine{5, 0.1 * *rc::gen::inRange(0, 400)};
    const auto noise = *rc::gen::container<std::vector<int>>(97, rc::gen::inRange(-15, 40));
    DrawingPace pace;
    run(pace, machine, 100);
    int steps = 0;
    for (std::size_t i = 0; i < 2 * half_minute; ++i) {
        const double ms = machine.picture_ms(pace.share()) * (1 + 0.01 * noise[i % noise.size()]);
        steps += pace.drawn(ms) ? 1 : 0;
    }
    RC_ASSERT(steps <= 12);  // in a minute
}

RC_GTEST_PROP(DrawingPace, WhateverItIsGivenItStaysWithinItsLevels, ()) {
    const auto told = *rc::gen::container<std::vector<double>>(rc::gen::oneOf(
        rc::gen::arbitrary<double>(), rc::gen::element(0.0, 5e-324, 1e300, 1.7e308, std::nan(""), -1.0, 16.0,
                                                       40.0, std::numeric_limits<double>::infinity())));
    DrawingPace pace;
    for (int round = 0; round < 20; ++round) {
        for (const double ms : told) {
            const int before = pace.level();
            const bool changed = pace.drawn(ms);
            RC_ASSERT(pace.level() >= 0 && pace.level() <= coarsest);
            RC_ASSERT(changed == (pace.level() != before));
            RC_ASSERT(pace.level() >= before - 1);
            RC_ASSERT(std::isfinite(pace.share()) && pace.share() <= 1);
            RC_ASSERT(pace.share() >= DrawingPace::share_at(coarsest));
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui
