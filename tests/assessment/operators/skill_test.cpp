// SPDX-License-Identifier: Apache-2.0
// An operator that learns: at its levels it is what the levels are, between them it is between them.
#include "assessment/operators/skill.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum {
namespace {

Skill of_level(OperatorLevel level, std::uint64_t individual, std::uint64_t attempt) {
    Skill skill;
    draw_individual(level, individual, skill);
    draw_form(level, attempt, skill);
    return skill;
}

Skill of_mastery(double mastery, std::uint64_t individual, std::uint64_t attempt) {
    Skill skill;
    draw_learner(mastery, individual, attempt, skill);
    return skill;
}

std::vector<double> values(const Skill& s) {
    return {s.reaction_s,
            s.choice_s,
            s.duration_scale,
            s.dwell_s,
            s.gain,
            s.gain_spread,
            s.endpoint_noise,
            s.path_noise,
            s.depth_error,
            s.gap_s,
            s.gap_spread_s,
            s.tremor,
            s.drift,
            s.touch_force,
            s.grip_force,
            s.grip_spread,
            s.comfortable_force,
            s.tolerance,
            s.lift_speed,
            s.foresight,
            s.hesitation,
            s.target.standoff,
            s.bowel.stride,
            s.traction.error,
            s.traction.slack,
            s.traction.band,
            s.line.error,
            s.line.stroke,
            s.plane.recognition,
            s.plane.blur,
            s.plane.lean,
            s.plane.steadiness,
            s.plane.care,
            s.scope.post_error,
            s.scope.level_error,
            s.scope.together,
            s.scope.lead,
            s.object.ease};
}

TEST(LearnerSkill, AtTheLevelsIsTheIndividualOfThatLevel) {
    // All of Skill is doubles: a value that is added and not interpolated is found here.
    ASSERT_EQ(values({}).size() * sizeof(double), sizeof(Skill));
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EXPECT_EQ(values(of_mastery(0, seed, 9)), values(of_level(OperatorLevel::novice, seed, 9)));
        EXPECT_EQ(values(of_mastery(0.5, seed, 9)), values(of_level(OperatorLevel::intermediate, seed, 9)));
        const std::vector<double> learned = values(of_mastery(1, seed, 9)),
                                  expert = values(of_level(OperatorLevel::expert, seed, 9));
        for (std::size_t i = 0; i < expert.size(); ++i) EXPECT_NEAR(learned[i], expert[i], 1e-12) << i;
    }
}

TEST(LearnerSkill, OutsideTheScaleIsItsEnd) {
    EXPECT_EQ(values(of_mastery(-3, 4, 2)), values(of_mastery(0, 4, 2)));
    EXPECT_EQ(values(of_mastery(7, 4, 2)), values(of_mastery(1, 4, 2)));
}

TEST(LearnerSkill, GrowsFromEachLevelToTheNextWithoutAStep) {
    // The tempo of the day differs by level, so values are compared within the range of one level's form.
    for (const auto& [low, high] :
         {std::pair{0.0, 0.24}, std::pair{0.26, 0.5}, std::pair{0.5, 0.74}, std::pair{0.76, 1.0}}) {
        const std::vector<double> a = values(of_mastery(low, 11, 3)), b = values(of_mastery(high, 11, 3)),
                                  between = values(of_mastery(0.5 * (low + high), 11, 3));
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_GE(between[i], std::min(a[i], b[i]) - 1e-12) << i;
            EXPECT_LE(between[i], std::max(a[i], b[i]) + 1e-12) << i;
        }
    }
    EXPECT_LT(of_mastery(0.7, 11, 3).depth_error, of_mastery(0.4, 11, 3).depth_error);
    EXPECT_GT(of_mastery(0.7, 11, 3).scope.together, of_mastery(0.4, 11, 3).scope.together);
}

}  // namespace
}  // namespace fulcrum
