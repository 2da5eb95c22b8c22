// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/plane_sense.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fulcrum {
namespace {

constexpr int plane_levels = 4, strokes_on_plane = 5, plane_attempts = 400;

PlaneSkill plane_skill(OperatorLevel preset) {
    Skill skill;
    draw_individual(preset, 1, skill);
    return skill.plane;
}

/// Mean over many attempts of the size of the distance at the last stroke of each level, m.
double mean_off_plane(const PlaneSkill& skill, double opened, int last_level) {
    double sum = 0;
    for (std::uint64_t attempt = 0; attempt < plane_attempts; ++attempt) {
        PlaneSense sense(skill, attempt);
        double distance = 0;
        for (int level = 0; level <= last_level; ++level) {
            sense.next_level(opened);
            for (int stroke = 0; stroke < strokes_on_plane; ++stroke) distance = sense.stroke(opened);
        }
        sum += std::abs(distance);
    }
    return sum / plane_attempts;
}

TEST(PlaneSense, ExpertsKnowThePlaneUnderAnyTraction) {
    for (const double opened : {0.0, 0.3, 1.0, 2.0})
        EXPECT_EQ(mean_off_plane(plane_skill(OperatorLevel::expert), opened, plane_levels - 1), 0.0)
            << opened;
}

TEST(PlaneSense, NovicesAreFurtherOffThanIntermediates) {
    for (const double opened : {0.2, 1.0}) {
        const double novice = mean_off_plane(plane_skill(OperatorLevel::novice), opened, plane_levels - 1);
        const double intermediate =
            mean_off_plane(plane_skill(OperatorLevel::intermediate), opened, plane_levels - 1);
        EXPECT_GT(intermediate, 0.0) << opened;
        EXPECT_GT(novice, 1.5 * intermediate) << opened;
    }
    // Under good traction an intermediate sees the plane; under weak traction it is guessed.
    EXPECT_GT(mean_off_plane(plane_skill(OperatorLevel::intermediate), 0.2, plane_levels - 1), 0.0002);
}

TEST(PlaneSense, WeakTractionHidesThePlane) {
    const PlaneSkill skill = plane_skill(OperatorLevel::intermediate);
    EXPECT_GT(mean_off_plane(skill, 0.2, plane_levels - 1), 1.2 * mean_off_plane(skill, 1, plane_levels - 1));
}

TEST(PlaneSense, AWrongPlaneIsFollowedFromLevelToLevel) {
    const PlaneSkill skill = plane_skill(OperatorLevel::novice);
    EXPECT_GT(mean_off_plane(skill, 1, plane_levels - 1), 1.2 * mean_off_plane(skill, 1, 0));
}

TEST(PlaneSense, SameAttemptGivesTheSameDistancesAndAnotherDoesNot) {
    PlaneSense a(plane_skill(OperatorLevel::novice), 7), b(plane_skill(OperatorLevel::novice), 7),
        c(plane_skill(OperatorLevel::novice), 8);
    for (PlaneSense* sense : {&a, &b, &c}) sense->next_level(1);
    const double first = a.stroke(1);
    EXPECT_EQ(first, b.stroke(1));
    EXPECT_NE(first, c.stroke(1));
}

}  // namespace
}  // namespace fulcrum
