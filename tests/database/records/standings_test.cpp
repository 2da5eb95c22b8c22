// SPDX-License-Identifier: GPL-3.0-or-later
// What the store gives the function of standings: attempts that count, voids at their own time, decisions.
#include "database/records/standings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "assessment/assets/assets.h"
#include "database/records/curricula.h"
#include "database/store/accepted_assets.h"
#include "tests/database/programme_fixture.h"
#include "tests/database/records/standing_of_ann.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;
using test::standing_of_ann;

Curriculum rectal() {
    return load_curriculum(asset_path("curricula/rectal.json"), task_ids());
}

TEST(Standings, AttemptsCountUntilTheyAreVoided) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const std::int64_t begin = programme.store->now();
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin).standing, Standing::open);
    const std::string passed = programme.record("ann");
    programme.clock.pass_s(100);
    programme.attempts().void_attempt(programme.session("educator"), passed, "wrong person");
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin + 99'000).standing, Standing::passed);
    EXPECT_TRUE(standing_of_ann(programme, curriculum, "A2", begin + 99'000).provisional);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin + 100'000).standing, Standing::open);
    programme.record("ann", false, 0);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin + 100'000).standing, Standing::attempted);
    programme.record_broken("ann");  // interrupted without a verdict
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin + 200'000).attempts, 1);
    programme.record("ann", true, 90, "B1");  // locked
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B1", begin + 200'000).standing, Standing::locked);
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

TEST(Standings, ACheckCountsByTheLimitsThatAreInForceNow) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const Session& educator = programme.session("educator");
    Standings(*programme.store)
        .decide(educator, programme.id("ann"), "A2", StandingOverride::Kind::proficient, "instructor");
    programme.clock.pass_s(15 * 86400.0);
    programme.record("ann");
    const auto now = [&] { return standing_of_ann(programme, curriculum, "A2", programme.store->now()); };
    EXPECT_EQ(now().standing, Standing::due);
    EXPECT_TRUE(now().provisional);
    const auto put_in_force = [&](char digest, int version, bool provisional, const char* variant) {
        programme.clock.pass_s(60);
        const std::string text = R"({"task": "A2", "device_class": "mouse-keyboard", "fidelity": "standard")"
                                 R"(, "variant_family": ")" +
                                 std::string(variant) + R"(", "version": )" + std::to_string(version) +
                                 R"(, "provisional": )" + (provisional ? "true}" : "false}");
        AcceptedAssets(*programme.store)
            .accept(educator, {"benchmarks/A2-mouse-keyboard.json", std::string(64, digest)}, "ours", text);
    };
    put_in_force('a', 1, false, "narrow");
    EXPECT_TRUE(now().provisional) << "of another variant";
    const std::int64_t before = programme.store->now();
    put_in_force('b', 4, false, "standard");
    EXPECT_FALSE(now().provisional);
    EXPECT_EQ(now().firm_with, std::vector<DeviceClass>{DeviceClass::mouse_keyboard});
    EXPECT_TRUE(standing_of_ann(programme, curriculum, "A2", before).provisional);
    put_in_force('c', 3, true, "standard");
    EXPECT_FALSE(now().provisional) << "older than the one in force";
    // So the cohort's educator is not asked to build what there is.
    programme.clock.pass_s(15 * 86400.0);
    const auto concern = [&] {
        CohortTableOptions options;
        options.curriculum = &curriculum;
        const CohortTable table = Reports(*programme.store).cohort_table(educator, programme.cohort, options);
        for (const PersonStandings& one : table.standings)
            for (const Concern& each : one.concerns)
                if (each.kind == ConcernKind::check_overdue) return each;
        ADD_FAILURE() << "no check is overdue";
        return Concern();
    };
    EXPECT_FALSE(concern().provisional);
    put_in_force('d', 5, true, "standard");
    EXPECT_TRUE(now().provisional);
    EXPECT_TRUE(concern().provisional);
}

TEST(Standings, DecisionsOfEducatorsAreKeptWithReasonAndAudited) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const Standings standings(*programme.store);
    const Session& educator = programme.session("educator");
    const std::int64_t begin = programme.store->now();
    standings.decide(educator, programme.id("ann"), "B1", StandingOverride::Kind::unlocked,
                     "has done this course elsewhere");
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B1", begin - 1).standing, Standing::locked);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B1", begin).standing, Standing::open);
    programme.clock.pass_s(10);
    standings.decide(educator, programme.id("ann"), "A2", StandingOverride::Kind::proficient, "instructor");
    EXPECT_EQ(standing_of_ann(programme, curriculum, "A2", begin + 10'000).standing, Standing::proficient);
    EXPECT_EQ(standing_of_ann(programme, curriculum, "B2", begin + 10'000).standing, Standing::open);
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

TEST(Standings, ADecisionThatChangesNothingIsRefusedAndNotAudited) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    const Standings standings(*programme.store);
    const std::string& ann = programme.id("ann");
    const auto decide = [&](const std::string& task, StandingOverride::Kind kind) {
        standings.decide(programme.session("educator"), ann, task, kind, "seen", &curriculum);
    };
    const auto problem_of = [&](const std::string& task, StandingOverride::Kind kind) {
        try {
            decide(task, kind);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::bad_value);
            EXPECT_FALSE(error.hint().empty());
            return error.problem();
        }
        return std::string("nothing was refused");
    };
    const auto kept = [&] { return standings.overrides(programme.session("educator"), ann).size(); };
    const auto audited = [&] {
        const auto entries = Audit(*programme.store).entries(programme.session("administrator"));
        return std::count_if(entries.begin(), entries.end(),
                             [](const auto& entry) { return entry.operation == "standing.decide"; });
    };
    EXPECT_EQ(problem_of("A2", StandingOverride::Kind::unlocked),
              "the decision would change nothing: A2 is not locked");
    EXPECT_EQ(problem_of("A9", StandingOverride::Kind::proficient),
              "A9 is not a task of the curriculum " + curriculum.name() + ", which the person follows");
    EXPECT_EQ(kept(), 0U);
    EXPECT_EQ(Curricula(*programme.store).followed(programme.session("educator"), ann, curriculum).size(), 1U)
        << "no version was kept by what was refused";
    decide("A2", StandingOverride::Kind::proficient);
    programme.clock.pass_s(10);
    EXPECT_EQ(problem_of("A2", StandingOverride::Kind::proficient),
              "the decision would change nothing: the person is proficient in A2, and no check is due");
    EXPECT_EQ(kept(), 1U);
    EXPECT_EQ(audited(), 1);
    programme.clock.pass_s(15 * 86'400);
    decide("A2", StandingOverride::Kind::proficient);  // a check is due
    EXPECT_EQ(kept(), 2U);
    EXPECT_EQ(audited(), 2);
}

TEST(Standings, ADecisionOnAPersonWhoseVersionIsNotHereIsRefused) {
    const Programme programme;
    const Curriculum curriculum = rectal();
    AttemptMeta meta = test::example_meta(programme.id("ann"));
    meta.curriculum = "rectal@77";
    Recorder(programme.path, programme.session("ann"), meta, programme.clock.options())
        .finish(test::example_result(true, 70));
    EXPECT_EQ(error_kind([&] {
                  Standings(*programme.store)
                      .decide(programme.session("educator"), programme.id("ann"), "B1",
                              StandingOverride::Kind::unlocked, "seen", &curriculum);
              }),
              StoreErrorKind::bad_value);
    EXPECT_TRUE(
        Standings(*programme.store).overrides(programme.session("educator"), programme.id("ann")).empty());
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
