// SPDX-License-Identifier: Apache-2.0
// A rule that nobody can meet is refused before it comes into force; every other one can be met.
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/curriculum_draft.h"
#include "assessment/curriculum/standing.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr std::int64_t rule_day = 86'400'000, rule_begin = 20'000 * rule_day + rule_day / 2;

/// One task with that rule.
Curriculum with_rule(const std::string& rule, int variants) {
    Curriculum curriculum{"test", 1, "Test", {{"1", "First"}}, {}};
    curriculum.tasks.push_back({"A", "1", {}, parse_pass_rule(rule), {DeviceClass::haptic}, variants});
    return curriculum;
}

/// After 200 passes on 200 days, over all variants in turn.
TaskStanding after_many_passes(const Curriculum& curriculum) {
    PersonRecord record;
    record.assignments.push_back({0, &curriculum});
    for (int i = 0; i < 200; ++i) {
        CountedAttempt one;
        one.id = "attempt-" + std::to_string(i);
        one.task = "A";
        one.time = rule_begin + i * rule_day;
        one.passed = true;
        one.variant = std::to_string(i % curriculum.tasks[0].variants);
        record.attempts.push_back(one);
    }
    return standing_of(record, rule_begin + 200 * rule_day).front();
}

bool is_refused(const Curriculum& curriculum) {
    try {
        check_rules(curriculum);
        return false;
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "/tasks/0/rule");
        EXPECT_NE(error.problem().find("nobody can meet the rule"), std::string::npos) << error.what();
        EXPECT_FALSE(error.hint().empty());
        return true;
    }
}

TEST(CurriculumRules, WhateverIsNotRefusedIsMetByWhoeverPassesOnAllDaysAndVariants) {
    std::vector<std::string> rules = {"lc-cusum:0.1,0.3,2.5", "lc-cusum:0.05,0.2,6"};
    for (int k = 1; k <= 10; ++k) rules.push_back("row:" + std::to_string(k));
    for (int n = 1; n <= 16; ++n)
        for (const int k : {1, (n + 1) / 2, n})
            rules.push_back("of:" + std::to_string(k) + "," + std::to_string(n));
    int refused = 0;
    for (const std::string& rule : rules) {
        for (int variants = 1; variants <= 12; ++variants) {
            const Curriculum curriculum = with_rule(rule, variants);
            const TaskStanding standing = after_many_passes(curriculum);
            const bool met = standing.declared_at != 0, no = is_refused(curriculum);
            EXPECT_NE(met, no) << rule << " on " << variants << " variants";
            EXPECT_EQ(standing.never_met, no) << rule << " on " << variants << " variants";
            refused += no ? 1 : 0;
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_TRUE(is_refused(with_rule("row:1", 1)));
    EXPECT_TRUE(is_refused(with_rule("of:2,2", 3)));
}

TEST(CurriculumRules, AreRefusedInADraftAndReadInAVersionInForce) {
    Curriculum draft = load_versions(asset_path("curricula"), "rectal", task_ids());
    EXPECT_NO_THROW(check_rules(draft));
    for (const Curriculum& older : draft.older) EXPECT_NO_THROW(check_rules(older)) << older.name();
    std::vector<InstalledTask> installed;
    for (const std::string& id : task_ids()) installed.push_back(installed_task(load_task(task_file(id))));
    const auto blocks_rule = [&] {
        const auto problems = check_draft(draft, installed, load_forms(asset_path("forms")));
        return std::any_of(problems.begin(), problems.end(), [](const CurriculumProblem& one) {
            return one.blocks && one.field == CurriculumField::rule && one.index == 1;
        });
    };
    EXPECT_FALSE(blocks_rule());
    draft.tasks[1].rule = parse_pass_rule("of:1,1");
    EXPECT_TRUE(blocks_rule());
    EXPECT_THROW(check_rules(draft), InputError);
    EXPECT_NO_THROW(parse_curriculum(curriculum_text(draft), "in force.json", task_ids()))
        << "people may follow it already";
}

}  // namespace
}  // namespace fulcrum
