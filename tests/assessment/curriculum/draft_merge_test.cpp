// SPDX-License-Identifier: Apache-2.0
// A draft and a version that came into force since it was begun: changes of both stay, and nothing is taken
// back unless it is named.
#include "assessment/curriculum/draft_merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum_draft.h"

namespace fulcrum {
namespace {

using Differences = std::vector<DraftDifference>;
using DraftChange = std::function<void(Curriculum&)>;

Curriculum begun_from() {
    Curriculum base = load_versions(asset_path("curricula"), "rectal", task_ids());
    base.older.clear();
    return base;
}
Curriculum changed(const Curriculum& base, const DraftChange& change) {
    Curriculum other = base;
    change(other);
    return other;
}
CurriculumTask& task_of(Curriculum& curriculum, const char* id) {
    return *std::find_if(curriculum.tasks.begin(), curriculum.tasks.end(),
                         [&](const CurriculumTask& one) { return one.task == id; });
}
DraftChange rule(const char* task, const char* text) {
    return [=](Curriculum& one) { task_of(one, task).rule = parse_pass_rule(text); };
}
DraftChange removal(const char* task) {
    return [=](Curriculum& one) {
        one.tasks.erase(std::remove_if(one.tasks.begin(), one.tasks.end(),
                                       [&](const CurriculumTask& each) { return each.task == task; }),
                        one.tasks.end());
    };
}
std::string order_of(const Curriculum& curriculum) {
    std::string ids;
    for (const CurriculumTask& one : curriculum.tasks) ids += one.task + " ";
    return ids;
}
bool is_in(const Differences& list, const DraftDifference& one) {
    return std::find(list.begin(), list.end(), one) != list.end();
}
/// In which parts two of them differ.
Differences between(const Curriculum& a, const Curriculum& b) {
    return merge_draft(nullptr, a, b).collisions;
}

TEST(DraftMerging, ChangesOfBothAreKeptWhereTheyDoNotCollide) {
    const Curriculum base = begun_from();
    const Curriculum draft = changed(base, [](Curriculum& one) {
        rule("A2", "row:3")(one);
        task_of(one, "C4").variants = 1;
        one.title = "Of the draft";
    });
    const Curriculum in_force = changed(base, [](Curriculum& one) {
        rule("C4", "of:3,5")(one);
        task_of(one, "A2").after = {"A1"};
        one.stages[1].title = "Published";
    });
    const DraftMerge merged = merge_draft(&base, draft, in_force);
    EXPECT_TRUE(merged.collisions.empty());
    EXPECT_EQ(merged.draft.title, "Of the draft");
    EXPECT_EQ(pass_rule_text(merged.draft.find("A2")->rule), "row:3");
    EXPECT_EQ(merged.draft.find("A2")->after, std::vector<std::string>{"A1"});
    EXPECT_EQ(merged.draft.find("C4")->variants, 1);
    EXPECT_EQ(pass_rule_text(merged.draft.find("C4")->rule), "of:3,5");
    EXPECT_EQ(merged.draft.stages[1].title, "Published");
    EXPECT_EQ(merged.taken, (Differences{{DraftPart::stage_title, base.stages[1].id},
                                         {DraftPart::after, "A2"},
                                         {DraftPart::rule, "C4"}}));
    EXPECT_TRUE(same_contents(merge_draft(&base, base, in_force).draft, in_force)) << "nothing was changed";
    EXPECT_TRUE(same_contents(merge_draft(&base, draft, base).draft, draft)) << "nothing was published";
}

TEST(DraftMerging, AFieldThatBothChangedCollidesUntilItIsDecided) {
    const Curriculum base = begun_from();
    const Curriculum draft = changed(base, rule("A2", "row:3")),
                     in_force = changed(base, rule("A2", "row:5"));
    DraftMerge merged = merge_draft(&base, draft, in_force);
    const Differences collisions = {{DraftPart::rule, "A2"}};
    EXPECT_EQ(merged.collisions, collisions);
    EXPECT_EQ(pass_rule_text(merged.draft.find("A2")->rule), "row:3") << "its author's own, until then";
    EXPECT_EQ(collisions_left(collisions, merged.draft, in_force), collisions);
    take_part(merged.draft, in_force, collisions[0]);
    EXPECT_EQ(pass_rule_text(merged.draft.find("A2")->rule), "row:5");
    EXPECT_TRUE(collisions_left(collisions, merged.draft, in_force).empty());
    // Both in the same way.
    EXPECT_TRUE(merge_draft(&base, draft, draft).collisions.empty());
}

TEST(DraftMerging, WhatOneRemovedAndTheOtherChangedCollides) {
    const Curriculum base = begun_from();
    const Curriculum without = changed(base, removal("B2")), with = changed(base, rule("B2", "row:3"));
    const Differences collision = {{DraftPart::task, "B2"}};
    DraftMerge merged = merge_draft(&base, without, with);
    EXPECT_EQ(merged.collisions, collision);
    EXPECT_EQ(merged.draft.find("B2"), nullptr);
    take_part(merged.draft, with, collision[0]);
    EXPECT_EQ(order_of(merged.draft), order_of(base)) << "it comes back to its place";
    EXPECT_EQ(pass_rule_text(merged.draft.find("B2")->rule), "row:3");
    merged = merge_draft(&base, with, without);
    EXPECT_EQ(merged.collisions, collision);
    ASSERT_NE(merged.draft.find("B2"), nullptr);
    take_part(merged.draft, without, collision[0]);
    EXPECT_EQ(merged.draft.find("B2"), nullptr);
    // Removed by one, untouched by the other.
    EXPECT_TRUE(merge_draft(&base, base, without).collisions.empty());
    EXPECT_EQ(merge_draft(&base, base, without).draft.find("B2"), nullptr);
    EXPECT_EQ(merge_draft(&base, without, base).draft.find("B2"), nullptr);
}

TEST(DraftMerging, ATaskThatIsRemovedAndAddedAgainTakesNothingBackUnnamed) {
    const Curriculum base = begun_from();
    const Curriculum in_force = changed(base, rule("A2", "row:5"));
    DraftMerge merged = merge_draft(&base, changed(base, rule("A2", "row:3")), in_force);
    removal("A2")(merged.draft);
    Differences left = collisions_left(merged.collisions, merged.draft, in_force);
    EXPECT_EQ(left, (Differences{{DraftPart::task, "A2"}}));
    CurriculumTask again = *base.find("A2");
    again.variants = 2;
    merged.draft.tasks.push_back(again);
    left = collisions_left(left, merged.draft, in_force);
    EXPECT_EQ(left, (Differences{{DraftPart::rule, "A2"}, {DraftPart::variants, "A2"}}));
}

TEST(DraftMerging, TasksOfBothAreAddedAndTheOrderOfOneIsKept) {
    Curriculum base = begun_from();
    removal("B1")(base);
    removal("A3")(base);
    const Curriculum whole = begun_from();
    const auto added = [&](const char* id, std::size_t at) {
        return changed(base, [&](Curriculum& one) {
            one.tasks.insert(one.tasks.begin() + static_cast<std::ptrdiff_t>(at), *whole.find(id));
        });
    };
    Curriculum draft = added("A3", 2);
    const Curriculum in_force = added("B1", 2);
    DraftMerge merged = merge_draft(&base, draft, in_force);
    EXPECT_TRUE(merged.collisions.empty());
    EXPECT_NE(merged.draft.find("A3"), nullptr);
    EXPECT_NE(merged.draft.find("B1"), nullptr);
    std::swap(draft.tasks[0], draft.tasks[1]);
    EXPECT_EQ(order_of(merge_draft(&base, draft, in_force).draft).substr(0, 8), "A2 B1 A1")
        << "the draft's order, and B1 behind the task that it was added behind";
    Curriculum turned = in_force;
    std::reverse(turned.tasks.begin(), turned.tasks.end());
    merged = merge_draft(&base, draft, turned);
    const Differences order = {{DraftPart::task_order, ""}};
    EXPECT_EQ(merged.collisions, order) << "both moved them";
    take_part(merged.draft, turned, order[0]);
    EXPECT_TRUE(collisions_left(order, merged.draft, turned).empty());
    EXPECT_NE(merged.draft.find("A3"), nullptr) << "the draft's own stays";
}

TEST(DraftMerging, WithoutABaseEveryDifferenceIsACollision) {
    const Curriculum base = begun_from();
    const Curriculum draft = changed(base, [](Curriculum& one) {
        rule("A2", "row:3")(one);
        removal("C4")(one);
    });
    const Curriculum in_force = changed(base, [](Curriculum& one) { one.title = "Published"; });
    DraftMerge merged = merge_draft(nullptr, draft, in_force);
    EXPECT_TRUE(merged.taken.empty());
    EXPECT_TRUE(same_contents(merged.draft, draft));
    EXPECT_EQ(merged.collisions,
              (Differences{{DraftPart::title, ""}, {DraftPart::rule, "A2"}, {DraftPart::task, "C4"}}));
    for (const DraftDifference& one : merged.collisions) take_part(merged.draft, in_force, one);
    EXPECT_TRUE(same_contents(merged.draft, in_force));
    EXPECT_TRUE(merge_draft(nullptr, in_force, in_force).collisions.empty());
}

TEST(DraftMerging, TheOrderOfChecksAndARemarkAreNoChanges) {
    const Curriculum base = begun_from();
    const Curriculum in_force = changed(base, [](Curriculum& one) {
        std::reverse(task_of(one, "C4").after.begin(), task_of(one, "C4").after.end());
        std::reverse(task_of(one, "A2").device_classes.begin(), task_of(one, "A2").device_classes.end());
        one.text = R"({"$comment": "another remark"})";
    });
    const DraftMerge merged = merge_draft(&base, changed(base, rule("C4", "of:3,5")), in_force);
    EXPECT_TRUE(merged.taken.empty());
    EXPECT_TRUE(merged.collisions.empty());
    EXPECT_NE(curriculum_text(merged.draft).find("another remark"), std::string::npos);
}

// Whatever two authors do: what the merged draft lacks of the version in force is a change of the draft's
// author, and where the version in force had changed it too, it is named.
TEST(DraftMerging, NothingThatWasPublishedIsTakenBackUnnamed) {
    const Curriculum base = begun_from();
    const std::vector<DraftChange> changes = {
        [](Curriculum&) {},
        rule("A2", "row:3"),
        rule("A2", "row:5"),
        removal("A2"),
        removal("C4"),
        [](Curriculum& one) { one.title += " x"; },
        [](Curriculum& one) { one.stages[0].title += " x"; },
        [](Curriculum& one) { one.stages.erase(one.stages.begin()); },
        [](Curriculum& one) {
            one.stages[0].id = "G";
            for (CurriculumTask& task : one.tasks)
                if (task.stage == "A") task.stage = "G";
        },
        [](Curriculum& one) {
            one.stages.push_back({"N", "New"});
        },
        [](Curriculum& one) { std::reverse(one.stages.begin(), one.stages.end()); },
        [](Curriculum& one) { std::swap(one.tasks.front(), one.tasks.back()); },
        [](Curriculum& one) { std::rotate(one.tasks.begin(), one.tasks.begin() + 1, one.tasks.end()); },
        [](Curriculum& one) {
            CurriculumTask added = one.tasks.back();
            added.task = "N1";
            one.tasks.insert(one.tasks.begin(), added);
        },
        [](Curriculum& one) { one.tasks.push_back(one.tasks.front()); },
        [](Curriculum& one) { one.tasks.back().ratings = RatingRule{"gas", 2, 5, {}, false, false}; },
        [](Curriculum& one) { one.tasks.back().remedies.clear(); },
        [](Curriculum& one) { one.tasks.back().device_classes = {DeviceClass::haptic}; },
        [](Curriculum& one) { one.tasks.clear(); }};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        for (std::size_t k = 0; k < changes.size(); ++k) {
            SCOPED_TRACE(std::to_string(i) + " against " + std::to_string(k));
            const Curriculum draft = changed(base, changes[i]), in_force = changed(base, changes[k]);
            const DraftMerge merged = merge_draft(&base, draft, in_force);
            const Differences own = between(base, draft), other = between(base, in_force);
            for (const DraftDifference& one : between(merged.draft, in_force)) {
                const bool named = is_in(merged.collisions, one);
                EXPECT_TRUE(named || is_in(own, one)) << static_cast<int>(one.part) << one.of;
                EXPECT_TRUE(named || !is_in(other, one)) << static_cast<int>(one.part) << one.of;
                const bool touched =
                    std::any_of(other.begin(), other.end(), [&](const DraftDifference& each) {
                        return one.part == DraftPart::task && each.of == one.of &&
                               each.part > DraftPart::task;
                    });
                EXPECT_TRUE(named || !touched) << one.of;
            }
            // The draft's author loses nothing unnamed either.
            for (const DraftDifference& one : between(merged.draft, draft))
                EXPECT_TRUE(is_in(merged.taken, one) || is_in(merged.collisions, one))
                    << static_cast<int>(one.part) << one.of;
            Curriculum decided = merged.draft;
            for (const DraftDifference& one : merged.collisions) take_part(decided, in_force, one);
            EXPECT_TRUE(collisions_left(merged.collisions, decided, in_force).empty());
        }
    }
}

}  // namespace
}  // namespace fulcrum
