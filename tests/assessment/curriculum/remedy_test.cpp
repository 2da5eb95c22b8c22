// SPDX-License-Identifier: Apache-2.0
// Remedies of a curriculum: what a file may not say, with place and hint; which one is recommended on a
// plateau, and when none is.
#include "assessment/curriculum/remedy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "assessment/curriculum/recommendation.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

using nlohmann::json;

constexpr std::int64_t remedy_day = 86'400'000;
constexpr double remedy_mark = 60;

const std::vector<InstalledTask>& remedy_tasks() {
    static const std::vector<InstalledTask> tasks = [] {
        std::vector<InstalledTask> read;
        for (const std::string& id : task_ids()) read.push_back(installed_task(load_task(task_file(id))));
        return read;
    }();
    return tasks;
}

/// What is said of the curriculum with this as the only remedy of `task` (0: A1, 1: A2); "" where it is
/// accepted.
std::string said_of(int task, const json& remedy) {
    static const std::string shipped = read_text_file(asset_path("curricula/rectal.json"), 1U << 20U);
    json document = json::parse(shipped);
    document["tasks"][static_cast<std::size_t>(task)]["remedies"] = json::array({remedy});
    try {
        check_remedies(parse_curriculum(document.dump(1), "test.json", task_ids()), remedy_tasks());
        return {};
    } catch (const InputError& error) {
        return error.place() + " " + error.problem() + "; " + error.hint();
    }
}

json good_remedy() {
    return {{"metric", "path_len"}, {"above", 880}, {"unit", "mm"}, {"feedback", "ghost"}};
}
std::string said_with(const char* key, const json& value, const char* without = nullptr, int task = 1) {
    json remedy = good_remedy();
    if (without != nullptr) remedy.erase(without);
    remedy[key] = value;
    return said_of(task, remedy);
}

void expect_said(const std::string& said, const std::string& place, const std::string& problem,
                 const std::string& hint) {
    EXPECT_NE(said.find("/tasks/"), std::string::npos) << said;
    const bool at_place =
        said.find(place + ")") != std::string::npos || said.find(place + " ") != std::string::npos;
    EXPECT_TRUE(at_place) << place << ", not " << said;
    EXPECT_NE(said.find(problem), std::string::npos) << said;
    EXPECT_NE(said.find(hint), std::string::npos) << said;
}

TEST(Remedies, TheDeliveredOnesFitTheInstalledTasksAndOlderVersionsHaveNone) {
    const Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    EXPECT_NO_THROW(check_remedies(newest, remedy_tasks()));
    for (const CurriculumTask& task : newest.tasks) EXPECT_GE(task.remedies.size(), 2U) << task.task;
    for (const Curriculum& older : newest.older)
        for (const CurriculumTask& task : older.tasks) EXPECT_TRUE(task.remedies.empty()) << older.name();
}

TEST(Remedies, AnUnknownMetricAndAWrongUnitAreRefusedWithTheNearestName) {
    EXPECT_EQ(said_of(1, good_remedy()), "");
    expect_said(said_with("metric", "path_length"), "/tasks/1/remedies/0/metric",
                "there is no metric path_length", "did you mean path_len?");
    expect_said(said_with("metric", "wobble"), "/metric", "there is no metric wobble", "docs/METRICS.md");
    expect_said(said_with("unit", "m"), "/tasks/1/remedies/0/unit", "path_len is not measured in 'm'",
                "write its unit, \"mm\"");
    expect_said(said_with("unit", ""), "/unit", "too short", "unit of the bound");
    expect_said(said_with("below", 880, "above"), "/below", "on the good side", "write \"above\"");
    expect_said(said_with("metric", "bleed_ml"), "/unit", "bleed_ml is not measured in 'mm'", "mL");
    json blood = good_remedy();
    blood["metric"] = "bleed_ml";
    blood["unit"] = "mL";
    expect_said(said_of(1, blood), "/metric", "A2 does not show the metric bleed_ml", "path_len");
}

TEST(Remedies, EachAsksForOneThingThatIsThere) {
    expect_said(said_with("below", 3), "/tasks/1/remedies/0", "has both above and below", "one bound");
    expect_said(said_with("practise_from", "right_targets"), "/remedies/0",
                "has both practise_from and feedback", "say what to do");
    expect_said(said_with("task", "A3"), "/remedies/0", "has both task and feedback", "say what to do");
    json nothing = good_remedy();
    nothing.erase("feedback");
    expect_said(said_of(1, nothing), "/remedies/0", "something is missing", "say what to do");
    json no_bound = good_remedy();
    no_bound.erase("above");
    expect_said(said_of(1, no_bound), "/remedies/0", "something is missing", "one bound");
    EXPECT_EQ(said_with("practise_from", "right_targets", "feedback"), "");
    expect_said(said_with("practise_from", "right_target", "feedback"), "/practise_from",
                "A2 has no goal right_target", "did you mean right_targets?");
    expect_said(said_with("practise_from", "left_targets", "feedback"), "/practise_from", "first goal",
                "a later goal");
    EXPECT_EQ(said_with("task", "B0", "feedback"), "") << "need not belong to the curriculum";
    expect_said(said_with("task", "A2", "feedback"), "/task", "not a remedy for itself", "another task");
    expect_said(said_with("task", "Z9", "feedback"), "/task", "no task Z9 is installed", "name one of these");
    EXPECT_EQ(said_with("variant", "deep", "feedback"), "");
    expect_said(said_with("variant", "deeep", "feedback"), "/variant", "A2 has no variant deeep",
                "did you mean deep?");
    json elsewhere = good_remedy();
    elsewhere.erase("feedback");
    elsewhere["task"] = "B1";
    elsewhere["variant"] = "slim";
    EXPECT_EQ(said_of(1, elsewhere), "");
    elsewhere["variant"] = "deep";
    expect_said(said_of(1, elsewhere), "/variant", "B1 has no variant deep", "slim");
    json scope = {{"metric", "horizon_err"}, {"above", 5}, {"unit", "deg"}, {"feedback", "ghost"}};
    expect_said(said_of(0, scope), "/tasks/0/remedies/0/feedback", "A1 has no ghost", "demonstration");
    EXPECT_NE(said_with("feedback", "telepathy"), "");
    EXPECT_NE(said_with("above", "much"), "");
    EXPECT_NE(said_with("because", "x"), "");
}

/// Points that level off at `level`, and a path that stays as it is.
TaskHistory history_at(double level, std::map<std::string, double> values, std::size_t attempts = 16) {
    TaskHistory history;
    for (std::size_t i = 0; i < attempts; ++i)
        history.points.push_back(level + (20 - level) * std::exp(-0.5 * static_cast<double>(i)) +
                                 (i % 2 == 0 ? 0.8 : -0.8));
    history.values.assign(attempts, std::move(values));
    history.last_variant = "standard";
    history.last = 100 * remedy_day;
    return history;
}

CurriculumTask task_with(std::vector<Remedy> remedies) {
    CurriculumTask task;
    task.task = "A2";
    task.stage = "A";
    task.remedies = std::move(remedies);
    return task;
}
const Remedy path_ghost{"path_len", true, 880, "mm", RemedyKind::ghost};
const Remedy force_replay{"f_max", true, 4, "N", RemedyKind::replay};
const Remedy smooth_task{"ldlj", false, -6, "-", RemedyKind::other_task, "", "A3"};

TEST(Remedies, TheMetricThatIsFurthestBeyondItsBoundNamesTheRemedy) {
    const CurriculumTask task = task_with({path_ghost, force_replay, smooth_task});
    const auto chosen = [&](std::map<std::string, double> values, double level = 48,
                            std::size_t attempts = 16) {
        const auto found = choose_remedy(task, history_at(level, std::move(values), attempts), remedy_mark);
        return found ? found->remedy.metric : std::string("none");
    };
    EXPECT_EQ(chosen({{"path_len", 968}, {"f_max", 4.2}, {"ldlj", -6.1}}), "path_len") << "10 %, 5 %, 2 %";
    EXPECT_EQ(chosen({{"path_len", 968}, {"f_max", 5}, {"ldlj", -6.1}}), "f_max");
    EXPECT_EQ(chosen({{"path_len", 968}, {"f_max", 5}, {"ldlj", -12}}), "ldlj");
    EXPECT_EQ(chosen({{"path_len", 1100}, {"f_max", 5}}), "path_len") << "the first of equals";
    EXPECT_EQ(chosen({{"path_len", 880}, {"f_max", 3}, {"ldlj", -5}}), "none")
        << "a bound is not beyond itself";
    EXPECT_EQ(chosen({}), "none");
    EXPECT_EQ(chosen({{"path_len", 968}}, 75), "none") << "above the pass mark";
    EXPECT_EQ(chosen({{"path_len", 968}}, 48, 7), "none") << "too few attempts to tell";
    const Remedy drops{"drop", true, 0, "-", RemedyKind::ghost};
    const auto zero = choose_remedy(task_with({path_ghost, drops}),
                                    history_at(48, {{"path_len", 8800}, {"drop", 1}}), remedy_mark);
    ASSERT_TRUE(zero.has_value());
    EXPECT_EQ(zero->remedy, drops) << "nothing is small compared with zero";
}

TEST(Remedies, TheLatestFiveAttemptsCount) {
    TaskHistory history = history_at(48, {{"path_len", 2000}});
    for (std::size_t i = history.values.size() - 5; i < history.values.size(); ++i)
        history.values[i]["path_len"] = 900 + static_cast<double>(i);
    history.values.back().clear();  // it was not measured
    const auto chosen = choose_remedy(task_with({path_ghost}), history, remedy_mark);
    ASSERT_TRUE(chosen.has_value());
    EXPECT_EQ(chosen->attempts, 5);
    EXPECT_EQ(chosen->value, 913) << "of 911 to 914 and the one before, 2000";
}

TEST(Remedies, ARemedyThatWasTakenGivesWayToTheTaskItself) {
    Curriculum curriculum;
    curriculum.tasks = {task_with({path_ghost})};
    Recommendation next;
    next.reason = RecommendationReason::longest_ago;
    next.task = "A2";
    TaskHistory history = history_at(48, {{"path_len", 968}, {"ldlj", -12}});
    std::map<std::string, std::int64_t> last{{"A2", history.last}};
    const auto reason = [&] { return with_remedy(next, curriculum, history, last, remedy_mark).reason; };
    EXPECT_EQ(reason(), RecommendationReason::remedy);
    EXPECT_EQ(reason(), RecommendationReason::remedy) << "the same every time";
    last["A2"] = history.last + 1;  // practised since
    EXPECT_EQ(reason(), RecommendationReason::longest_ago);
    last["A2"] = history.last;
    curriculum.tasks = {task_with({smooth_task})};
    EXPECT_EQ(reason(), RecommendationReason::remedy);
    last["A3"] = history.last + 1;
    EXPECT_EQ(reason(), RecommendationReason::longest_ago);
    Remedy deep = path_ghost;
    deep.kind = RemedyKind::other_variant;
    deep.variant = "deep";
    curriculum.tasks = {task_with({deep})};
    EXPECT_EQ(reason(), RecommendationReason::remedy);
    history.last_variant = "deep";
    EXPECT_EQ(reason(), RecommendationReason::longest_ago);
    history.last_variant = "standard";
    for (const RecommendationReason other :
         {RecommendationReason::check_due, RecommendationReason::relapsed, RecommendationReason::not_tried,
          RecommendationReason::all_done}) {
        next.reason = other;
        EXPECT_EQ(reason(), other);
    }
    next.reason = RecommendationReason::longest_ago;
    next.task = "B9";
    EXPECT_EQ(reason(), RecommendationReason::longest_ago) << "not in the curriculum";
}

}  // namespace
}  // namespace fulcrum
