// SPDX-License-Identifier: GPL-3.0-or-later
// What the store gives the function of standings: attempts that count, voids at their own time, decisions.
#include "database/records/standings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "assessment/assets/assets.h"
#include "database/records/person_merge.h"
#include "database/records/ratings.h"
#include "database/store/accepted_assets.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

Curriculum rectal() {
    return load_curriculum(asset_path("curricula/rectal.json"), task_ids());
}

TaskStanding standing(const Programme& programme, const Curriculum& curriculum, const std::string& task,
                      std::int64_t at) {
    const PersonRecord record =
        Standings(*programme.store).record(programme.session("educator"), programme.id("ann"), curriculum);
    for (const TaskStanding& one : standing_of(record, at))
        if (one.task == task) return one;
    ADD_FAILURE() << task;
    return {};
}

TEST(Standings, AttemptsCountUntilTheyAreVoided) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const std::int64_t begin = programme.store->now();
    EXPECT_EQ(standing(programme, curriculum, "A2", begin).standing, Standing::open);
    const std::string passed = programme.record("ann");
    programme.clock.pass_s(100);
    programme.attempts().void_attempt(programme.session("educator"), passed, "wrong person");
    EXPECT_EQ(standing(programme, curriculum, "A2", begin + 99'000).standing, Standing::passed);
    EXPECT_TRUE(standing(programme, curriculum, "A2", begin + 99'000).provisional);
    EXPECT_EQ(standing(programme, curriculum, "A2", begin + 100'000).standing, Standing::open);
    programme.record("ann", false, 0);
    EXPECT_EQ(standing(programme, curriculum, "A2", begin + 100'000).standing, Standing::attempted);
    programme.record_broken("ann");  // interrupted without a verdict
    EXPECT_EQ(standing(programme, curriculum, "A2", begin + 200'000).attempts, 1);
    programme.record("ann", true, 90, "B1");  // locked
    EXPECT_EQ(standing(programme, curriculum, "B1", begin + 200'000).standing, Standing::locked);
}

TEST(Standings, OfACohortMarkADeactivatedPersonWhoHasNoConcernAndIsNotInN) {
    Programme programme;
    programme.record("ann", true, 71.5);
    programme.record("ben", true, 80);
    programme.clock.pass_s(30 * 86400.0);
    const Curriculum curriculum = rectal();
    CohortTableOptions options;
    options.tasks = {"A2"};
    options.curriculum = &curriculum;
    const auto read = [&] {
        return Reports(*programme.store)
            .cohort_table(programme.session("director"), programme.cohort, options);
    };
    CohortTable table = read();
    EXPECT_EQ(table.people, 2);
    ASSERT_EQ(table.standings.size(), 2U);
    for (const PersonStandings& one : table.standings) EXPECT_EQ(one.concerns.size(), 1U) << "stopped";
    programme.people().set_active(programme.session("administrator"), programme.id("ann"), false);
    table = read();
    EXPECT_EQ(table.people, 1);
    EXPECT_EQ(table.deactivated, 1);
    ASSERT_EQ(table.standings.size(), 2U);
    for (const PersonStandings& one : table.standings) {
        EXPECT_EQ(one.active, one.login != "ann");
        EXPECT_EQ(one.concerns.empty(), one.login == "ann");
    }
    for (const CohortRow& row : table.rows) EXPECT_EQ(row.active, row.login != "ann");
}

TEST(Standings, AreTheSameNumberOfAttemptsAsRowsAndProgress) {
    const Programme programme;
    programme.record("ann", true, 60);
    programme.record("ann", true, 90, "B1");  // locked
    programme.record("ann", false, 20);
    const Curriculum curriculum = rectal();
    const Reports reports(*programme.store);
    const Session& director = programme.session("director");
    CohortTableOptions options;
    options.tasks = {"A2", "B1"};
    options.curriculum = &curriculum;
    const CohortTable table = reports.cohort_table(director, programme.cohort, options);
    const PersonData data = reports.person_data(director, programme.id("ann"), {options.tasks, &curriculum});
    const std::vector<CohortRow> personal = reports.person_table(director, programme.id("ann"), options.tasks,
                                                                 ReportPurpose::screen, &curriculum);
    for (const std::string& task : options.tasks) {
        int counted = -1;
        for (const PersonStandings& person : table.standings)
            for (const PersonTask& one : person.tasks)
                if (person.login == "ann" && one.standing.task == task) counted = one.standing.attempts;
        EXPECT_EQ(counted, task == "A2" ? 2 : 0);
        for (const std::vector<CohortRow>* rows : {&table.rows, &data.rows, &personal}) {
            int attempts = 0, others = 0;
            for (const CohortRow& row : *rows)
                if (row.login == "ann" && row.task_id == task) {
                    attempts += row.attempts;
                    others += row.not_counting;
                }
            EXPECT_EQ(attempts, counted) << task;
            EXPECT_EQ(others, task == "A2" ? 0 : 1) << task;
        }
        const PersonProgress shown =
            reports.person_progress(director, programme.id("ann"), task, ReportPurpose::screen, &curriculum);
        int points = 0, left_out = 0;
        for (const ProgressSeries& series : shown.series)
            for (const ProgressPoint& point : series.points) {
                points += point.counting ? 1 : 0;
                left_out += point.left_out ? 1 : 0;
            }
        EXPECT_EQ(points, counted) << task;
        EXPECT_EQ(left_out, task == "A2" ? 0 : 1) << task;
    }
}

TEST(Standings, AFailureWithoutASetOfLimitsIsMarked) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const std::int64_t begin = programme.store->now();
    // As in the tasks that are delivered, whose absolute gates are provisional until a set takes them over.
    const auto record = [&](std::optional<double> limit, const std::string& source, bool own = false) {
        AttemptResult result = test::example_result(false, 0);
        GateRow& gate = result.score->gates.front();
        ASSERT_EQ(gate.kind, GateKind::benchmark);
        gate.limit = limit;
        gate.limit_source = source;
        gate.z = gate.points = std::nullopt;
        gate.provisional = false;
        ASSERT_EQ(result.score->gates.back().kind, GateKind::absolute);
        result.score->gates.back().provisional = own;
        Recorder(programme.path, programme.session("ann"), test::example_meta(programme.id("ann")),
                 programme.clock.options())
            .finish(result);
        programme.clock.pass_s(60);
    };
    record(std::nullopt, "");
    record(900.0, "A2-site@1");
    const std::int64_t second = programme.store->now();
    record(std::nullopt, "", true);
    record(900.0, "A2-site@1", true);
    const PersonRecord counted =
        Standings(*programme.store).record(programme.session("educator"), programme.id("ann"), curriculum);
    ASSERT_EQ(counted.attempts.size(), 4U);
    for (const CountedAttempt& one : counted.attempts) {
        EXPECT_EQ(one.provisional, one.time > second);
        EXPECT_EQ(one.without_limits, one.time == begin || one.time == second);
    }
}

/// A failure that was scored after its set had been replaced; `known`: the score has that it was provisional.
/// Its name says nothing.
std::string record_replaced(const Programme& programme, const std::string& digest, bool known = false) {
    AttemptResult result = test::example_result(false, 0);
    for (GateRow& gate : result.score->gates) {
        if (gate.kind != GateKind::benchmark) continue;
        gate.limit = gate.z = gate.points = std::nullopt;
        gate.limit_source.clear();
        gate.passed = false;
        gate.provisional = known;
        gate.not_passed_because = Statement(StatementId::limits_replaced);
    }
    AttemptMeta meta = test::example_meta(programme.id("ann"));
    meta.limits = "A2-site@1";
    if (!digest.empty()) meta.assets.push_back({"benchmarks/A2.json", digest});
    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    recorder.finish(result);
    programme.clock.pass_s(60);
    return recorder.attempt_id();
}

TEST(Standings, AFailureScoredAfterItsLimitsWereReplacedCountsByTheSetOfItsStart) {
    const Programme programme;
    const AcceptedAssets accepted(*programme.store);
    const auto digest = [](char of) { return std::string(64, of); };
    accepted.accept(programme.session("educator"), {"benchmarks/A2.json", digest('a')}, "ours",
                    R"({"provisional": false})");
    accepted.accept(programme.session("educator"), {"benchmarks/A2.json", digest('b')}, "for now",
                    R"({"provisional": true})");
    for (const char of : {'c', 'd'})
        accepted.accept(programme.session("educator"), {"benchmarks/A2.json", digest(of)}, "not passed on");
    // Of ben, by a set that nobody keeps.
    AttemptMeta judged = test::example_meta(programme.id("ben"));
    judged.limits = "A2-site@1";
    judged.assets.push_back({"benchmarks/A2.json", digest('c')});
    AttemptResult result = test::example_result(true, 70);
    for (GateRow& gate : result.score->gates) gate.provisional = gate.kind == GateKind::benchmark;
    Recorder(programme.path, programme.session("ben"), judged, programme.clock.options()).finish(result);

    enum class By { firm, provisional, none };
    const std::map<std::string, By> expected = {
        {record_replaced(programme, digest('a')), By::firm},
        {record_replaced(programme, digest('b')), By::provisional},
        {record_replaced(programme, digest('c')), By::provisional},
        {record_replaced(programme, digest('d')), By::none},
        {record_replaced(programme, digest('d'), true), By::provisional}};
    const auto check = [&](const AttemptSummary& one) {
        const By by = expected.at(one.meta.id);
        EXPECT_EQ(one.provisional, by == By::provisional) << static_cast<int>(by);
        EXPECT_EQ(one.without_limits, by == By::none) << static_cast<int>(by);
    };
    AttemptFilter filter;
    filter.person_id = programme.id("ann");
    const Attempts attempts = programme.attempts();
    const std::vector<AttemptSummary> listed = attempts.list(programme.session("educator"), filter);
    ASSERT_EQ(listed.size(), expected.size());
    EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end(), [](const auto& a, const auto& b) {
        return a.meta.started > b.meta.started;
    })) << "newest first";
    for (const AttemptSummary& one : listed) check(one);
    for (const auto& [id, by] : expected) check(attempts.read(programme.session("educator"), id));
    const PersonRecord counted =
        Standings(*programme.store).record(programme.session("educator"), programme.id("ann"), rectal());
    ASSERT_EQ(counted.attempts.size(), expected.size());
    EXPECT_EQ(std::count_if(counted.attempts.begin(), counted.attempts.end(),
                            [](const CountedAttempt& one) { return one.provisional; }),
              3);
}

TEST(Standings, AFailureByAReplacedSetFromBeforeFilesWereKeptCountsAsAnAttemptThatItJudged) {
    const Programme programme;
    const std::string unknown = record_replaced(programme, "");
    EXPECT_TRUE(programme.attempts().read(programme.session("educator"), unknown).without_limits);
    AttemptMeta judged = test::example_meta(programme.id("ben"));
    judged.limits = "A2-site@1";
    AttemptResult result = test::example_result(true, 70);
    result.score->limits = judged.limits;
    for (GateRow& gate : result.score->gates) gate.provisional = false;
    Recorder(programme.path, programme.session("ben"), judged, programme.clock.options()).finish(result);
    const AttemptSummary known = programme.attempts().read(programme.session("educator"), unknown);
    EXPECT_FALSE(known.without_limits);
    EXPECT_FALSE(known.provisional);
}

TEST(Standings, DecisionsOfEducatorsAreKeptWithReasonAndAudited) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const Standings standings(*programme.store);
    const Session& educator = programme.session("educator");
    const std::int64_t begin = programme.store->now();
    standings.decide(educator, programme.id("ann"), "B1", StandingOverride::Kind::unlocked,
                     "has done this course elsewhere");
    EXPECT_EQ(standing(programme, curriculum, "B1", begin - 1).standing, Standing::locked);
    EXPECT_EQ(standing(programme, curriculum, "B1", begin).standing, Standing::open);
    programme.clock.pass_s(10);
    standings.decide(educator, programme.id("ann"), "A2", StandingOverride::Kind::proficient, "instructor");
    EXPECT_EQ(standing(programme, curriculum, "A2", begin + 10'000).standing, Standing::proficient);
    EXPECT_EQ(standing(programme, curriculum, "B2", begin + 10'000).standing, Standing::open);
    const std::vector<OverrideRow> rows = standings.overrides(programme.session("ann"), programme.id("ann"));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1].reason, "has done this course elsewhere");
    EXPECT_EQ(rows[1].author_name, "Edu Cator");
    EXPECT_EQ(rows[0].decision.kind, StandingOverride::Kind::proficient);
    const auto entries = Audit(*programme.store).entries(programme.session("administrator"));
    EXPECT_EQ(std::count_if(entries.begin(), entries.end(),
                            [](const auto& entry) { return entry.operation == "standing.decide"; }),
              2);
    for (const char* reason : {"", " \n"})
        EXPECT_EQ(error_kind([&] {
                      standings.decide(educator, programme.id("ann"), "B1", StandingOverride::Kind::unlocked,
                                       reason);
                  }),
                  StoreErrorKind::bad_value);
    EXPECT_THROW(standings.decide(programme.session("other_educator"), programme.id("ann"), "B1",
                                  StandingOverride::Kind::unlocked, "not my trainee"),
                 AccessDenied);
}

TEST(Standings, CheckFindsADecisionThatNobodyMade) {
    const Programme programme;
    Standings(*programme.store)
        .decide(programme.session("educator"), programme.id("ann"), "B1", StandingOverride::Kind::unlocked,
                "x");
    const auto decisions = [&] {
        for (const CheckItem& item : programme.store->check(programme.session("administrator")).items)
            if (item.name == "decisions") return item;
        ADD_FAILURE();
        return CheckItem();
    };
    EXPECT_TRUE(decisions().ok);
    EXPECT_EQ(decisions().count, 1);
    Connection& connection = programme.store->connection();
    EXPECT_THROW(connection.execute("UPDATE standing_override SET kind = 'proficient'"), StoreError);
    EXPECT_THROW(connection.execute("DELETE FROM standing_override"), StoreError);
    connection.execute("DROP TRIGGER standing_override_is_fixed");
    connection.execute("UPDATE standing_override SET kind = 'proficient'");
    EXPECT_FALSE(decisions().ok);
    connection.execute("UPDATE standing_override SET kind = 'unlocked'");
    EXPECT_TRUE(decisions().ok);
    connection.execute(
        "INSERT INTO standing_override SELECT 'forged', person_id, 'C4', kind, author_id, time, reason FROM "
        "standing_override");
    EXPECT_EQ(decisions().problems.size(), 1U);
}

/// A2 asks for two passes in a row and for two ratings.
Curriculum rated_a2() {
    Curriculum curriculum = rectal();
    for (CurriculumTask& task : curriculum.tasks)
        if (task.task == "A2") {
            task.rule = parse_pass_rule("row:2");
            task.ratings = RatingRule{"goals", 2, 4, {}, false, false};
        }
    return curriculum;
}

TEST(Standings, ReleasedRatingsOfTheAttemptThatMeetsTheRuleCount) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    programme.people().set_educators(programme.session("director"), programme.cohort,
                                     {programme.id("educator"), programme.id("other_educator")});
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    const Ratings ratings(*programme.store);
    const auto rate = [&](const char* login, const std::string& attempt, int value) {
        const Session& rater = programme.session(login);
        const std::string id = ratings.begin(rater, attempt, goals);
        ratings.answer(rater, id, FormAnswers(goals.items.size(), value),
                       std::vector<bool>(goals.items.size(), true), "");
        ratings.hand_in(rater, id);
    };
    programme.record("ann");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("ann");
    const std::int64_t waits = programme.store->now();
    EXPECT_EQ(standing(programme, curriculum, "A2", waits).standing, Standing::awaiting_rating);
    EXPECT_EQ(standing(programme, curriculum, "A2", waits).rated_attempt, rated);
    // Raters see it first, though others are newer; without the curriculum in the order of time.
    programme.clock.pass_s(60);
    programme.record("ben");
    for (const char* login : {"educator", "director"}) {
        const std::vector<RatableAttempt> listed = ratings.to_rate(programme.session(login), &curriculum);
        EXPECT_EQ(listed.at(0).attempt_id, rated) << login;
        EXPECT_EQ(std::count_if(listed.begin(), listed.end(),
                                [](const RatableAttempt& one) { return one.awaited; }),
                  1);
    }
    EXPECT_EQ(ratings.to_rate(programme.session("educator"), &curriculum, 1).at(0).attempt_id, rated);
    EXPECT_NE(ratings.to_rate(programme.session("educator")).at(0).attempt_id, rated);
    EXPECT_NE(ratings.to_rate(programme.session("educator"), &curriculum).at(1).attempt_id, rated);
    rate("educator", rated, 5);
    rate("other_educator", rated, 3);
    EXPECT_EQ(standing(programme, curriculum, "A2", programme.store->now()).raters, 0) << "not released";
    programme.clock.pass_s(60);
    ASSERT_EQ(ratings.release(programme.session("educator"), rated), 2);
    EXPECT_FALSE(ratings.to_rate(programme.session("educator"), &curriculum).at(0).awaited) << "met";
    const std::int64_t released = programme.store->now();
    EXPECT_EQ(standing(programme, curriculum, "A2", released - 1).standing, Standing::awaiting_rating);
    EXPECT_TRUE(standing(programme, curriculum, "A2", released).met_provisionally) << "mean 4";
    EXPECT_EQ(standing(programme, curriculum, "B1", released).standing, Standing::open);
    EXPECT_EQ(standing(programme, curriculum, "B1", released - 1).standing, Standing::locked);
    // The cohort table, from which screens and exports are made, says the same.
    CohortTableOptions options;
    options.curriculum = &curriculum;
    const auto of_a2 = [&] {
        const CohortTable table =
            Reports(*programme.store).cohort_table(programme.session("director"), programme.cohort, options);
        for (const PersonStandings& person : table.standings)
            for (const PersonTask& task : person.tasks)
                if (person.login == "ann" && task.standing.task == "A2") return task.standing;
        return TaskStanding();
    };
    EXPECT_TRUE(of_a2().met_provisionally);
    programme.attempts().void_attempt(programme.session("educator"), rated, "wrong person");
    EXPECT_FALSE(of_a2().met_provisionally);
    const std::string again = programme.record("ann");
    EXPECT_EQ(of_a2().standing, Standing::awaiting_rating);
    EXPECT_EQ(of_a2().rated_attempt, again);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(Standings, ARaterWhoHasSeenTheAttemptReadsThatBlindRatingsAreAskedFor) {
    const Programme programme;
    Curriculum curriculum = rated_a2();
    programme.record("ann");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("ann");
    const Session& educator = programme.session("educator");
    const Ratings ratings(*programme.store);
    EXPECT_FALSE(ratings.to_rate(educator, &curriculum).at(0).wants_blind);
    for (CurriculumTask& task : curriculum.tasks)
        if (task.ratings) task.ratings->blind = true;
    for (const bool seen : {false, true}) {
        if (seen) ratings.note_seen(educator, rated);
        const RatableAttempt first = ratings.to_rate(educator, &curriculum).at(0);
        EXPECT_EQ(first.attempt_id, rated);
        EXPECT_TRUE(first.awaited);
        EXPECT_TRUE(first.wants_blind);
        EXPECT_EQ(first.blind, !seen);
    }
    EXPECT_FALSE(ratings.to_rate(educator, &curriculum).at(1).wants_blind) << "nobody waits for it";
}

TEST(Standings, WhatOneAccountDecidedAboutAnotherOfThePersonDoesNotCountAfterAMerge) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    // The educator is a trainee too, and was entered twice: ann is the other account.
    const Session& administrator = programme.session("administrator");
    const Session& educator = programme.session("educator");
    programme.people().set_roles(administrator, programme.id("educator"), {Role::educator, Role::trainee});
    const Standings standings(*programme.store);
    standings.decide(educator, programme.id("ann"), "A1", StandingOverride::Kind::proficient, "as I saw");
    const std::string attempt = programme.record("ann");
    const ObserverForm goals = load_form(asset_path("forms/goals.json"));
    const Ratings ratings(*programme.store);
    const std::string form = ratings.begin(educator, attempt, goals);
    ratings.answer(educator, form, FormAnswers(goals.items.size(), 5),
                   std::vector<bool>(goals.items.size(), true), "");
    ratings.hand_in(educator, form);
    ASSERT_EQ(ratings.release(educator, attempt), 1);
    EXPECT_EQ(standing(programme, curriculum, "A1", programme.store->now()).standing, Standing::proficient);
    const Session& director = programme.session("director");
    ASSERT_EQ(standings.record(director, programme.id("ann"), curriculum).ratings.size(), 1U);

    const PersonMerge merge(*programme.store);
    const MergePlan plan = merge.plan(administrator, programme.id("ann"), programme.id("educator"));
    EXPECT_EQ(plan.counts.back().what.words(),
              "decisions and forms of one account about the other, which then do not count");
    EXPECT_EQ(plan.counts.back().count, 2);
    merge.merge(administrator, programme.id("ann"), programme.id("educator"), "the same person");
    const PersonRecord record = standings.record(director, programme.id("educator"), curriculum);
    EXPECT_EQ(record.attempts.size(), 1U);
    EXPECT_TRUE(record.overrides.empty());
    EXPECT_TRUE(record.ratings.empty());
    const std::vector<OverrideRow> listed = standings.overrides(director, programme.id("educator"));
    ASSERT_EQ(listed.size(), 1U) << "it is still shown";
    EXPECT_TRUE(listed[0].own);
    CohortTableOptions options;
    options.curriculum = &curriculum;
    const CohortTable table = Reports(*programme.store).cohort_table(director, programme.cohort, options);
    for (const PersonStandings& person : table.standings)
        for (const PersonTask& task : person.tasks)
            if (task.standing.task == "A1") {
                EXPECT_EQ(task.standing.declared_at, 0) << person.login;
            }
    merge.undo(administrator, programme.id("ann"), "two people after all");
    EXPECT_EQ(standings.record(director, programme.id("ann"), curriculum).overrides.size(), 1U);
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(Standings, RatersSeeTheAwaitedAttemptOfAMergedAccountFirst) {
    const Programme programme;
    const Curriculum curriculum = rated_a2();
    programme.record("eve");
    programme.clock.pass_s(86'400);
    const std::string rated = programme.record("eve");
    PersonMerge(*programme.store)
        .merge(programme.session("administrator"), programme.id("eve"), programme.id("ann"), "entered twice");
    programme.clock.pass_s(60);
    programme.record("ben");
    EXPECT_EQ(standing(programme, curriculum, "A2", programme.store->now()).rated_attempt, rated);
    for (const char* login : {"educator", "director"}) {
        const std::vector<RatableAttempt> listed =
            Ratings(*programme.store).to_rate(programme.session(login), &curriculum);
        ASSERT_EQ(listed.size(), 3U) << login;
        EXPECT_EQ(listed[0].attempt_id, rated) << login;
        EXPECT_TRUE(listed[0].awaited) << login;
    }
}

TEST(Standings, TheCohortTableCarriesThemWithTheLatestAttempts) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    for (int i = 0; i < 15; ++i) {
        programme.record("ann", i > 12, 30 + 3 * i);
        programme.clock.pass_s(0.25 * 86'400);
    }
    const std::string voided = programme.record("ann", true, 99);
    programme.attempts().void_attempt(programme.session("educator"), voided, "wrong person");
    programme.clock.pass_s(30 * 86'400);
    CohortTableOptions options;
    options.tasks = {"A2", "B1"};
    options.curriculum = &curriculum;
    const CohortTable table =
        Reports(*programme.store).cohort_table(programme.session("director"), programme.cohort, options);
    EXPECT_EQ(table.curriculum, curriculum.name());
    ASSERT_EQ(table.standings.size(), static_cast<std::size_t>(table.people));
    const auto ann = std::find_if(table.standings.begin(), table.standings.end(),
                                  [](const PersonStandings& one) { return one.login == "ann"; });
    ASSERT_NE(ann, table.standings.end());
    const std::vector<TaskStanding> asked = standing_of(
        Standings(*programme.store).record(programme.session("educator"), programme.id("ann"), curriculum),
        programme.store->now());
    ASSERT_EQ(ann->tasks.size(), asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        EXPECT_EQ(ann->tasks[i].standing.task, asked[i].task);
        EXPECT_EQ(ann->tasks[i].standing.standing, asked[i].standing) << asked[i].task;
        EXPECT_EQ(ann->tasks[i].standing.attempts, asked[i].attempts) << asked[i].task;
        EXPECT_EQ(ann->tasks[i].standing.progress, asked[i].progress) << asked[i].task;
    }
    const auto a2 = std::find_if(ann->tasks.begin(), ann->tasks.end(),
                                 [](const PersonTask& one) { return one.standing.task == "A2"; });
    ASSERT_EQ(a2->recent.size(), most_recent) << "the newest of 15, without the voided one";
    EXPECT_EQ(a2->recent.front().points, 30 + 3 * 3);
    EXPECT_EQ(a2->recent.back().points, 30 + 3 * 14);
    EXPECT_TRUE(a2->recent.back().passed);
    EXPECT_EQ(a2->device_class, DeviceClass::mouse_keyboard);
    int attempts = 0;
    for (const PracticeDay& day : ann->days) attempts += day.attempts;
    EXPECT_EQ(attempts, 15);
    EXPECT_GE(ann->days.size(), 4U);
    ASSERT_EQ(ann->concerns.size(), 1U);
    EXPECT_EQ(ann->concerns[0].kind, ConcernKind::stopped);
    const std::vector<TaskOverview> overview = overview_of(table.standings, table.as_of);
    const auto of_a2 = std::find_if(overview.begin(), overview.end(),
                                    [](const TaskOverview& one) { return one.task == "A2"; });
    ASSERT_NE(of_a2, overview.end());
    EXPECT_EQ(of_a2->attempted, 1);
    EXPECT_EQ(of_a2->passed, 1);
    EXPECT_EQ(of_a2->people.at(Standing::passed), 1);
    EXPECT_EQ(of_a2->provisional, 1);
    ASSERT_TRUE(of_a2->days_to_pass.median);
    EXPECT_NEAR(*of_a2->days_to_pass.median, 13 * 0.25, 1e-9) << "the 14th attempt, four a day";
    EXPECT_FALSE(of_a2->days_to_proficiency.median) << "by provisional limits nobody is proficient";
    options.curriculum = nullptr;
    EXPECT_TRUE(Reports(*programme.store)
                    .cohort_table(programme.session("director"), programme.cohort, options)
                    .standings.empty());
}

}  // namespace
}  // namespace fulcrum::database
