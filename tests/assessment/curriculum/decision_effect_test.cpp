// SPDX-License-Identifier: Apache-2.0
// What each decision of an educator changed, and what one more would change.
#include <gtest/gtest.h>

#include "assessment/curriculum/standing.h"

namespace fulcrum {
namespace {

using DecisionKind = StandingOverride::Kind;

constexpr std::int64_t effect_day = 86'400'000, effect_begin = 20'000 * effect_day;

/// B follows A.
Curriculum curriculum_of_effects() {
    Curriculum curriculum{"test", 1, "Test", {{"1", "First"}}, {}};
    curriculum.tasks.push_back({"A", "1", {}, parse_pass_rule("row:2"), {DeviceClass::haptic}});
    curriculum.tasks.push_back({"B", "1", {"A"}, parse_pass_rule("row:2"), {DeviceClass::haptic}});
    return curriculum;
}

TEST(DecisionEffects, SayOfEachDecisionWhatItChanged) {
    const Curriculum curriculum = curriculum_of_effects();
    PersonRecord record;
    record.assignments.push_back({0, &curriculum});
    record.overrides = {{"unlocks", "B", DecisionKind::unlocked, effect_begin},
                        {"again", "B", DecisionKind::unlocked, effect_begin + 1},
                        {"declares", "B", DecisionKind::proficient, effect_begin + 2},
                        {"early", "B", DecisionKind::proficient, effect_begin + effect_day},
                        {"on_time", "B", DecisionKind::proficient, effect_begin + 15 * effect_day},
                        {"later", "A", DecisionKind::unlocked, effect_begin + 40 * effect_day}};
    const auto effects = effects_of(record, effect_begin + 20 * effect_day);
    ASSERT_EQ(effects.size(), 5U) << "one has not come into force yet";
    EXPECT_EQ(effects.at("unlocks"), DecisionEffect::unlocked);
    EXPECT_EQ(effects.at("again"), DecisionEffect::none);
    EXPECT_EQ(effects.at("declares"), DecisionEffect::declared);
    EXPECT_EQ(effects.at("early"), DecisionEffect::none) << "no check was due";
    EXPECT_EQ(effects.at("on_time"), DecisionEffect::check_passed);
}

TEST(DecisionEffects, OfOneMoreComeAfterEverythingOfItsTime) {
    const Curriculum curriculum = curriculum_of_effects();
    PersonRecord record;
    record.assignments.push_back({0, &curriculum});
    EXPECT_EQ(effect_of(record, {"a", "A", DecisionKind::unlocked, effect_begin}), DecisionEffect::none)
        << "A is open from the beginning";
    EXPECT_EQ(effect_of(record, {"a", "B", DecisionKind::unlocked, effect_begin}), DecisionEffect::unlocked);
    record.overrides.push_back({"b", "B", DecisionKind::unlocked, effect_begin});
    EXPECT_EQ(effect_of(record, {"a", "B", DecisionKind::unlocked, effect_begin}), DecisionEffect::none)
        << "of the same millisecond, whatever its id";
    EXPECT_EQ(effect_of(record, {"a", "B", DecisionKind::proficient, effect_begin}),
              DecisionEffect::declared);
}

}  // namespace
}  // namespace fulcrum
