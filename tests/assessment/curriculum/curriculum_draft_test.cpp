// SPDX-License-Identifier: Apache-2.0
// A curriculum that is edited: every problem at its place, and a file that says the same.
#include "assessment/curriculum/curriculum_draft.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

Curriculum draft_in_force() {
    return load_versions(asset_path("curricula"), "rectal", task_ids());
}
const std::vector<InstalledTask>& all_installed() {
    static std::vector<InstalledTask> tasks;
    if (!tasks.empty()) return tasks;
    for (const std::string& id : task_ids()) {
        InstalledTask one = installed_task(load_task(task_file(id)));
        one.variants.resize(3, "another");
        one.needs_limits = true;
        one.with_limits = {DeviceClass::haptic, DeviceClass::tracked};
        tasks.push_back(one);
    }
    return tasks;
}
const std::vector<ObserverForm>& forms() {
    static const std::vector<ObserverForm> read = load_forms(asset_path("forms"));
    return read;
}
/// What blocks, as "field index".
std::vector<std::pair<CurriculumField, std::size_t>> blocking(const Curriculum& draft) {
    std::vector<std::pair<CurriculumField, std::size_t>> found;
    for (const CurriculumProblem& one : check_draft(draft, all_installed(), forms()))
        if (one.blocks) found.emplace_back(one.field, one.index);
    return found;
}
std::size_t place_of(const Curriculum& draft, const char* task) {
    return static_cast<std::size_t>(draft.find(task) - draft.tasks.data());
}

TEST(CurriculumDraft, TheOneInForceHasNothingThatBlocksAndItsFileSaysTheSame) {
    const Curriculum draft = draft_in_force();
    EXPECT_TRUE(blocking(draft).empty());
    const auto before = nlohmann::json::parse(draft.text),
               after = nlohmann::json::parse(curriculum_text(draft));
    EXPECT_EQ(before, after);
    const Curriculum again = parse_curriculum(curriculum_text(draft), "draft", task_ids());
    EXPECT_EQ(curriculum_text(again).size(),
              nlohmann::ordered_json::parse(curriculum_text(again)).dump(2).size() + 1);
}

TEST(CurriculumDraft, EachProblemIsFoundAtItsPlace) {
    using Found = std::vector<std::pair<CurriculumField, std::size_t>>;
    const Curriculum good = draft_in_force();
    const std::size_t a2 = place_of(good, "A2"), a3 = place_of(good, "A3"), c4 = place_of(good, "C4");
    Curriculum draft = good;
    draft.tasks[a2].after = {"A3"};
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::after, a2}, {CurriculumField::after, a3}}))
        << "cycle";
    draft = good;
    draft.tasks[a3].task = "Z9";
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::task, a3}})) << "unknown task";
    draft = good;
    draft.tasks[a2].after = {"C4"};
    const Found later = blocking(draft);
    EXPECT_EQ(std::count(later.begin(), later.end(), std::pair(CurriculumField::after, a2)), 2)
        << "a later stage, and a cycle";
    draft = good;
    draft.tasks[c4].variants = 4;
    draft.tasks[c4].device_classes.clear();
    draft.tasks[c4].stage = "Q";
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::stage, c4},
                                      {CurriculumField::variants, c4},
                                      {CurriculumField::devices, c4}}));
    draft = good;
    draft.tasks[a2].device_classes = {DeviceClass::controller};
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::devices, a2}})) << "no benchmark at all";
    draft.tasks[a2].device_classes = {DeviceClass::haptic, DeviceClass::controller};
    EXPECT_TRUE(blocking(draft).empty()) << "one is enough; the other is said";
    EXPECT_FALSE(check_draft(draft, all_installed(), forms()).empty());
    draft = good;
    draft.tasks[c4].ratings = RatingRule{"gas", 2, 99, {}, false, false};
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::ratings, c4}})) << "outside the form's scale";
    draft.tasks[c4].ratings->form = "no such form";
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::ratings, c4}}));
    draft = good;
    draft.tasks[a2].remedies[0].unit = "m";
    draft.tasks[c4].remedies[0].metric = "plane_dve";
    draft.tasks[c4].remedies[1].goal = "no such goal";
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::remedies, a2},
                                      {CurriculumField::remedies, c4},
                                      {CurriculumField::remedies, c4}}));
    draft = good;
    draft.tasks[a2].remedies.resize(13, draft.tasks[a2].remedies[0]);
    EXPECT_EQ(blocking(draft), (Found{{CurriculumField::remedies, a2}})) << "more than a file may hold";
    draft = good;
    draft.title = "  ";
    draft.stages[1].id = draft.stages[0].id;
    draft.tasks.push_back(draft.tasks[0]);
    const Found many = blocking(draft);
    EXPECT_NE(std::find(many.begin(), many.end(), std::pair(CurriculumField::title, std::size_t{0})),
              many.end());
    EXPECT_NE(std::find(many.begin(), many.end(), std::pair(CurriculumField::stages, std::size_t{1})),
              many.end());
    EXPECT_NE(std::find(many.begin(), many.end(), std::pair(CurriculumField::task, draft.tasks.size() - 1)),
              many.end());
    EXPECT_FALSE(blocking(Curriculum{}).empty());
}

TEST(CurriculumDraft, ASavedDraftNamesTheVersionFromWhichItWasBegun) {
    Curriculum draft = draft_in_force();
    const std::string digest(64, 'a');
    draft.based_on = DraftOrigin{3, digest};
    const std::string text = curriculum_text(draft);
    const Curriculum again = parse_draft(text, "draft.json");
    ASSERT_TRUE(again.based_on.has_value());
    EXPECT_EQ(again.based_on->version, 3);
    EXPECT_EQ(again.based_on->sha256, digest);
    EXPECT_TRUE(same_contents(again, draft_in_force())) << "it says the same";
    EXPECT_NO_THROW(parse_curriculum(text, "draft.json", task_ids())) << "put into the folder as it is";
    std::string cut = text;
    cut.replace(cut.find(digest), digest.size(), "a");
    EXPECT_THROW(parse_draft(cut, "draft.json"), InputError);
}

// What check_draft() lets pass, parse_curriculum() accepts: whatever is changed, at one place or at two.
TEST(CurriculumDraft, WhatDoesNotBlockCanBeReadByTheProgram) {
    const Curriculum good = draft_in_force();
    std::vector<std::function<void(Curriculum&, std::size_t)>> changes = {
        [](Curriculum& d, std::size_t i) { d.tasks[i].after = {d.tasks[(i + 1) % d.tasks.size()].task}; },
        [](Curriculum& d, std::size_t i) { d.tasks[i].after.clear(); },
        [](Curriculum& d, std::size_t i) { d.tasks[i].stage = d.stages[i % d.stages.size()].id; },
        [](Curriculum& d, std::size_t i) { d.tasks.erase(d.tasks.begin() + static_cast<std::ptrdiff_t>(i)); },
        [](Curriculum& d, std::size_t i) { d.tasks[i].rule = {PassRuleKind::k_of_n, 5, 3, 0, 0, 0}; },
        [](Curriculum& d, std::size_t i) { d.tasks[i].rule.p0 = 0.9; },
        [](Curriculum& d, std::size_t i) { d.tasks[i].rule = parse_pass_rule("of:2,2"); },
        [](Curriculum& d, std::size_t i) { d.stages[i % d.stages.size()].title = std::string(61, 'x'); },
        [](Curriculum& d, std::size_t i) { d.tasks[i].variants = static_cast<int>(i); },
        [](Curriculum& d, std::size_t i) { d.tasks[i].remedies[0].unit = "ell"; },
        [](Curriculum& d, std::size_t i) { d.tasks[i].remedies.back().above = i % 2 == 0; },
        [](Curriculum& d, std::size_t i) { d.tasks[i].remedies[0].kind = RemedyKind::other_task; },
        [](Curriculum& d, std::size_t) { d.title = "Ωχι " + std::string(200, 'y'); }};
    const std::vector<std::string> installed = task_ids();
    int readable = 0;
    for (const auto& first : changes) {
        for (const auto& second : changes) {
            for (std::size_t i = 0; i + 1 < good.tasks.size(); i += 2) {
                Curriculum draft = good;
                first(draft, i);
                second(draft, i);
                const bool blocked = !blocking(draft).empty();
                bool read = true;
                try {
                    const Curriculum again = parse_curriculum(curriculum_text(draft), "draft", installed);
                    check_rules(again);
                    check_ratings(again, forms());
                    check_remedies(again, all_installed());
                } catch (const InputError& error) {
                    read = false;
                    EXPECT_TRUE(blocked) << error.what();
                }
                readable += read ? 1 : 0;
            }
        }
    }
    EXPECT_GT(readable, 30);
}

}  // namespace
}  // namespace fulcrum
