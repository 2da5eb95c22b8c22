// SPDX-License-Identifier: GPL-3.0-or-later
// The one query behind the cohort's screens and exports, and progress.
#include <cmath>
#include <limits>

#include "assessment/metrics/statement_words.h"
#include "assessment/pathology/pathology.h"
#include "database/records/report_data.h"
#include "database/store/score_rows.h"
#include "database/sync/erasure.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

const CohortRow* row_of(const CohortTable& table, const std::string& login, const std::string& task,
                        const std::optional<DeviceClass>& device_class) {
    for (const CohortRow& row : table.rows) {
        if (row.login == login && row.task_id == task && row.device_class == device_class) return &row;
    }
    return nullptr;
}

TEST(CohortTable, CountsWhatCountsAndPoolsNothing) {
    Programme programme;
    programme.record("ann", false, 40);
    programme.record("ann", true, 71.5);
    programme.record("ann", false, 80);
    AttemptMeta practice = example_meta(programme.id("ann"));
    practice.mode = AttemptMode::practice;
    Recorder(programme.path, programme.session("ann"), practice, programme.clock.options())
        .finish(example_result(true, 99));
    AttemptMeta tracked = example_meta(programme.id("ann"));
    tracked.device_class = DeviceClass::tracked;
    Recorder(programme.path, programme.session("ann"), tracked, programme.clock.options())
        .finish(example_result(false, 12));
    programme.record("ben", false, 5, "B1");
    programme.record("eve", true, 90);
    const Session& director = programme.session("director");
    CohortTableOptions options;
    options.tasks = {"A2", "B1"};
    const CohortTable table = Reports(*programme.store).cohort_table(director, programme.cohort, options);
    EXPECT_EQ(table.people, 2);
    EXPECT_EQ(table.rows.size(), 5U);
    const CohortRow* ann = row_of(table, "ann", "A2", DeviceClass::mouse_keyboard);
    ASSERT_NE(ann, nullptr);
    EXPECT_EQ(ann->state, TaskState::passed);
    EXPECT_TRUE(ann->provisional);
    EXPECT_EQ(ann->attempts, 3);
    EXPECT_EQ(ann->passes, 1);
    EXPECT_EQ(ann->not_counting, 1);
    EXPECT_EQ(ann->best_points, 80);
    const CohortRow* with_tracked = row_of(table, "ann", "A2", DeviceClass::tracked);
    ASSERT_NE(with_tracked, nullptr);
    EXPECT_EQ(with_tracked->state, TaskState::attempted);
    EXPECT_EQ(with_tracked->best_points, 12);
    ASSERT_NE(row_of(table, "ann", "B1", std::nullopt), nullptr);
    EXPECT_EQ(row_of(table, "ann", "B1", std::nullopt)->state, TaskState::open);
    ASSERT_NE(row_of(table, "ben", "B1", DeviceClass::mouse_keyboard), nullptr);
    EXPECT_EQ(row_of(table, "ben", "B1", DeviceClass::mouse_keyboard)->state, TaskState::attempted);
    EXPECT_EQ(row_of(table, "eve", "A2", DeviceClass::mouse_keyboard), nullptr);
    EXPECT_EQ(table.benchmark_sets, std::vector<std::string>{"A2-operators@1"});
    EXPECT_EQ(table.metric_versions, (std::vector<std::string>{"path_len@1", "sparc@2"}));
    EXPECT_EQ(table.audit_head, Audit(*programme.store).head());
    EXPECT_EQ(Reports(*programme.store).cohort_table(director, programme.cohort).tasks,
              (std::vector<std::string>{"A2", "B1"}));
    const auto personal =
        Reports(*programme.store).person_table(programme.session("ann"), programme.id("ann"), {"A2", "B1"});
    ASSERT_EQ(personal.size(), 3U);
    EXPECT_EQ(personal[0].best_points, 80);
}

/// An attempt with this version of `path_len`, a minute before the next one.
std::string record_with_version(const Programme& programme, const std::string& login, int version,
                                AttemptState state = AttemptState::completed) {
    AttemptResult result = example_result(state == AttemptState::completed, 70);
    result.state = state;
    result.score->metrics[0].version = version;
    Recorder recorder(programme.path, programme.session(login), example_meta(programme.id(login)),
                      programme.clock.options());
    Programme::append_second(recorder);
    recorder.finish(result);
    programme.clock.pass_s(60);
    return recorder.attempt_id();
}

/// Of the pages of people in a cohort's PDF, by login.
std::map<std::string, std::vector<std::string>> versions_on_pages(const Programme& programme) {
    PersonDataOptions pages;
    pages.tasks = {"A2"};
    pages.detail = PointDetail::none;
    CohortTableOptions options;
    options.tasks = pages.tasks;
    std::map<std::string, std::vector<std::string>> versions;
    EXPECT_TRUE(Reports(*programme.store)
                    .table_with_people(programme.session("director"), programme.cohort, options, pages,
                                       [&](const CohortTable&, PersonData&& person, double) {
                                           versions[person.login] = person.metric_versions;
                                           return true;
                                       }));
    return versions;
}

TEST(CohortTable, NamesEachVersionOfAMetricThatItsValuesHave) {
    Programme programme;
    const auto record = [&](const std::string& login, int version) {
        record_with_version(programme, login, version);
    };
    record("ben", 2);
    record("ann", 2);
    record("ann", 4);
    record("ann", 3);
    record("ann", 3);
    const std::vector<std::string> all = {"path_len@2", "path_len@3", "path_len@4", "sparc@2"};
    const Reports reports(*programme.store);
    const Session& director = programme.session("director");
    EXPECT_EQ(reports.cohort_table(director, programme.cohort).metric_versions, all);
    EXPECT_EQ(reports.person_progress(director, programme.id("ann"), "A2").metric_versions, all);
    EXPECT_EQ(reports.person_data(director, programme.id("ann"), {{"A2"}, nullptr}).metric_versions, all);
    std::map<std::string, std::vector<std::string>> of_person = versions_on_pages(programme);
    EXPECT_EQ(of_person["ann"], all);
    EXPECT_EQ(of_person["ben"], (std::vector<std::string>{"path_len@2", "sparc@2"}));
}

TEST(CohortTable, NamesAVersionOfAnotherStationBetweenTwoAttemptsOfOneStation) {
    Programme programme;
    record_with_version(programme, "ann", 2);
    const std::string between = record_with_version(programme, "ben", 3);
    record_with_version(programme, "ann", 2);
    programme.store->connection().execute(QString::fromStdString(
        "DROP TRIGGER IF EXISTS attempt_is_fixed; INSERT INTO station VALUES ('elsewhere', 'Room 2', 1); "
        "UPDATE attempt SET station_id = 'elsewhere' WHERE id = '" +
        between + "'"));
    EXPECT_EQ(Reports(*programme.store)
                  .cohort_table(programme.session("director"), programme.cohort)
                  .metric_versions,
              (std::vector<std::string>{"path_len@2", "path_len@3", "sparc@2"}));
}

TEST(CohortTable, NamesTheVersionOfAReassignedAttemptAlsoOnceTheOriginalIsGone) {
    Programme programme;
    record_with_version(programme, "ann", 2);
    const std::string original = record_with_version(programme, "ben", 3);
    record_with_version(programme, "ann", 2);
    programme.attempts().reassign(programme.session("educator"), original, programme.id("ann"),
                                  "Ann sat there");
    const std::vector<std::string> all = {"path_len@2", "path_len@3", "sparc@2"};
    const auto versions = [&] {
        return Reports(*programme.store)
            .cohort_table(programme.session("director"), programme.cohort)
            .metric_versions;
    };
    EXPECT_EQ(versions(), all);
    EXPECT_EQ(versions_on_pages(programme)["ann"], all);
    ASSERT_TRUE(erase_at_station(*programme.store, programme.id("ben"), programme.store->station_session(),
                                 "asked for it"));
    EXPECT_EQ(versions(), all);
}

TEST(CohortTable, NamesTheVersionOfACutOffAttemptThatWasScoredLater) {
    Programme programme;
    record_with_version(programme, "ann", 2);
    record_with_version(programme, "ann", 3, AttemptState::interrupted);
    record_with_version(programme, "ann", 2);
    const std::vector<std::string> all = {"path_len@2", "path_len@3", "sparc@2"};
    EXPECT_EQ(Reports(*programme.store)
                  .cohort_table(programme.session("director"), programme.cohort)
                  .metric_versions,
              all);
    EXPECT_EQ(versions_on_pages(programme)["ann"], all);
}

TEST(CohortTable, PagesOfPeopleNameThePersonsOwnVersionsOfAMetric) {
    // As where Ann trains at a station that was updated and Ben at one that was not.
    Programme programme;
    record_with_version(programme, "ben", 2);
    record_with_version(programme, "ann", 3);
    record_with_version(programme, "ann", 3);
    record_with_version(programme, "ben", 2);
    record_with_version(programme, "ann", 3);
    record_with_version(programme, "ben", 2);
    std::map<std::string, std::vector<std::string>> of_person = versions_on_pages(programme);
    EXPECT_EQ(of_person["ann"], (std::vector<std::string>{"path_len@3", "sparc@2"}));
    EXPECT_EQ(of_person["ben"], (std::vector<std::string>{"path_len@2", "sparc@2"}));
}

TEST(CohortTable, OfTwoEqualAttemptsTheLaterIsTheBestOneEverywhere) {
    Programme programme;
    std::string later;
    for (int i = 0; i < 2; ++i) {
        later = programme.record("ann", true, 80);
        programme.clock.pass_s(600);
    }
    const Reports reports(*programme.store);
    const Session& director = programme.session("director");
    CohortTableOptions options;
    options.tasks = {"A2"};
    EXPECT_EQ(row_of(reports.cohort_table(director, programme.cohort, options), "ann", "A2",
                     DeviceClass::mouse_keyboard)
                  ->best_attempt_id,
              later);
    EXPECT_EQ(reports.person_data(director, programme.id("ann"), {{"A2"}, nullptr}).rows[0].best_attempt_id,
              later);
    EXPECT_EQ(reports.person_table(director, programme.id("ann"), {"A2"})[0].best_attempt_id, later);
}

TEST(CohortTable, WithItsPeopleFromOneReadingIsTheSameTable) {
    Programme programme;
    programme.record("ann", true, 71.5);
    programme.clock.pass_s(60);
    const std::string voided = programme.record("ann", true, 95);
    programme.record("ben", false, 5);
    const Session& director = programme.session("director");
    Attempts(*programme.store).void_attempt(programme.session("educator"), voided, "wrong hand");
    const Reports reports(*programme.store);
    CohortTableOptions options;
    options.tasks = {"A2"};
    PersonDataOptions pages;
    pages.tasks = options.tasks;
    const CohortTable alone =
        reports.cohort_table(director, programme.cohort, options, ReportPurpose::exported);
    std::vector<PersonData> people;
    const auto table = reports.table_with_people(director, programme.cohort, options, pages,
                                                 [&](const CohortTable& whole, PersonData&& person, double) {
                                                     EXPECT_EQ(whole.rows.size(), alone.rows.size())
                                                         << "the table is whole before the first person";
                                                     people.push_back(std::move(person));
                                                     return true;
                                                 });
    ASSERT_TRUE(table.has_value());
    ASSERT_EQ(people.size(), 2U);
    ASSERT_EQ(table->rows.size(), alone.rows.size());
    for (std::size_t i = 0; i < alone.rows.size(); ++i) {
        EXPECT_EQ(table->rows[i].best_attempt_id, alone.rows[i].best_attempt_id);
        EXPECT_EQ(table->rows[i].attempts, alone.rows[i].attempts);
        EXPECT_EQ(table->rows[i].best_points, people[i].rows[0].best_points);
    }
    EXPECT_EQ(table->assets.size(), alone.assets.size());
    EXPECT_EQ(people[0].rows[0].best_points, 71.5) << "what was voided is in no figure";
    ASSERT_EQ(people[0].progress[0].voided.size(), 1U);
    EXPECT_EQ(people[0].progress[0].voided[0].attempt_id, voided);
    int visited = 0;
    EXPECT_FALSE(reports
                     .table_with_people(director, programme.cohort, options, pages,
                                        [&](const CohortTable&, PersonData&&, double) {
                                            ++visited;
                                            return false;
                                        })
                     .has_value());
    EXPECT_EQ(visited, 1);
    EXPECT_THROW(reports.table_with_people(programme.session("educator"), programme.cohort, options, pages,
                                           [](const CohortTable&, PersonData&&, double) { return true; }),
                 AccessDenied);
}

TEST(CohortTable, AWordWithAControlCharacterIsRefusedWithItsTable) {
    Programme programme;
    programme.record("ann", true, 80);
    programme.store->connection().execute(
        "DROP TRIGGER IF EXISTS attempt_is_fixed; UPDATE attempt SET variant = 'a' || char(31) || 'b'");
    try {
        Reports(*programme.store).cohort_table(programme.session("director"), programme.cohort);
        FAIL() << "it was read";
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::corrupt) << error.what();
    }
}

TEST(Progress, AnAttemptWithoutAScoreHidesNoVersions) {
    Programme programme;
    programme.record_broken("ann");
    programme.open();
    programme.clock.pass_s(60);
    programme.record("ann");
    const PersonProgress progress =
        Reports(*programme.store).person_progress(programme.session("ann"), programme.id("ann"), "A2");
    EXPECT_EQ(progress.metric_versions, (std::vector<std::string>{"path_len@1", "sparc@2"}));
    ASSERT_EQ(progress.series[0].points.size(), 2U);
    EXPECT_EQ(progress.series[0].points[0].state, AttemptState::interrupted);
    EXPECT_FALSE(progress.series[0].points[0].counting);
}

TEST(Progress, OrdersAttemptsByTimeWithinADeviceClass) {
    Programme programme;
    std::vector<std::string> recorded;
    for (const double points : {10.0, 30.0, 20.0}) {
        recorded.push_back(programme.record("ann", points > 25, points));
        programme.clock.pass_s(600);
    }
    const PersonProgress progress =
        Reports(*programme.store).person_progress(programme.session("ann"), programme.id("ann"), "A2");
    ASSERT_EQ(progress.series.size(), 1U);
    ASSERT_EQ(progress.series[0].points.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(progress.series[0].points[i].attempt_id, recorded[i]);
        EXPECT_EQ(progress.series[0].points[i].number, static_cast<int>(i) + 1);
        EXPECT_EQ(progress.series[0].points[i].metrics.size(), 2U);
    }
    EXPECT_EQ(progress.state, TaskState::passed);
    EXPECT_EQ(progress.series[0].device_class, DeviceClass::mouse_keyboard);
}

}  // namespace
}  // namespace fulcrum::database::test
