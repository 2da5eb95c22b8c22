// SPDX-License-Identifier: GPL-3.0-or-later
// Which reports are written when: who may say so, the names of days and weeks, what is remembered.
#include "database/schedules/schedules.h"

#include <gtest/gtest.h>

#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database {
namespace {

using test::error_kind;
using test::Programme;

TEST(Schedules, NameDaysAndWeeksAsTheIsoCalendarDoes) {
    constexpr UtcMilliseconds day_ms = 86'400'000;
    const UtcMilliseconds sunday = test::noon - test::noon % day_ms;
    EXPECT_EQ(period_of(ScheduleEvery::day, test::noon), iso_utc(test::noon).substr(0, 10));
    EXPECT_EQ(period_of(ScheduleEvery::day, sunday + day_ms - 1), period_of(ScheduleEvery::day, sunday));
    EXPECT_NE(period_of(ScheduleEvery::day, sunday + day_ms), period_of(ScheduleEvery::day, sunday));
    EXPECT_EQ(period_of(ScheduleEvery::week, 1609459200000), "2020-W53") << "1 January 2021";
    EXPECT_EQ(period_of(ScheduleEvery::week, 1609718400000), "2021-W01") << "Monday, 4 January 2021";
}

TEST(Schedules, AreTheDirectorsAuditedAndRemembered) {
    const Programme programme;
    const Schedules schedules(*programme.store);
    const Session& director = programme.session("director");
    ReportSchedule wish;
    wish.cohort_id = programme.cohort;
    wish.format = "csv";
    wish.folder = "/srv/reports";
    for (const char* login : {"ann", "educator", "administrator"}) {
        const Session& session = programme.session(login);
        EXPECT_THROW(schedules.add(session, wish), AccessDenied) << login;
        EXPECT_THROW(schedules.list(session), AccessDenied) << login;
        EXPECT_THROW(schedules.note(session, "x", "2026-W48", ""), AccessDenied) << login;
        EXPECT_THROW(schedules.remove(session, "x"), AccessDenied) << login;
    }
    const std::string id = schedules.add(director, wish);
    EXPECT_EQ(error_kind([&] { schedules.add(director, wish); }), StoreErrorKind::conflict);
    wish.folder = "reports";
    EXPECT_EQ(error_kind([&] { schedules.add(director, wish); }), StoreErrorKind::bad_value);
    schedules.note(director, id, "2026-W48", "the disk is full");
    EXPECT_EQ(schedules.list(director).at(0).problem.words(), "the disk is full");
    EXPECT_EQ(schedules.list(director).at(0).last_period, "");
    schedules.note(director, id, "2026-W48", "");
    const ReportSchedule now = schedules.list(director).at(0);
    EXPECT_EQ(now.last_period, "2026-W48");
    EXPECT_TRUE(now.problem.empty());
    EXPECT_EQ(now.cohort_name, "Year 1");
    EXPECT_EQ(Audit(*programme.store).entries(programme.session("administrator")).front().operation,
              "schedule.write");
    schedules.remove(director, id);
    EXPECT_TRUE(schedules.list(director).empty());
    EXPECT_EQ(error_kind([&] { schedules.remove(director, id); }), StoreErrorKind::not_found);
    for (const char* problem : {"", "the disk is full"}) schedules.note(director, id, "2026-W49", problem);
    EXPECT_TRUE(schedules.list(director).empty()) << "a run that was writing it does not bring it back";
    EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
}

TEST(Schedules, KeepWhyAReportFailedAsASentenceWithItsParts) {
    const Programme programme;
    const Schedules schedules(*programme.store);
    const Session& director = programme.session("director");
    ReportSchedule wish;
    wish.cohort_id = programme.cohort;
    wish.format = "csv";
    wish.folder = "/srv/reports";
    const std::string id = schedules.add(director, wish);
    // A part may be anything: quotation marks, the cohort's own id, another sentence.
    const Sentence problem("%1; %2",
                           Sentence("%1: cannot be created (%2)", std::string("\"a\"\nb"), programme.cohort),
                           Sentence("list the schedules"));
    schedules.note(director, id, "2026-W48", problem);
    ASSERT_EQ(schedules.list(director).size(), 1U);
    const Sentence kept = schedules.list(director)[0].problem;
    EXPECT_EQ(kept.words(), problem.words());
    const Translate marked = [](const char*, const char* source) { return "<" + std::string(source) + ">"; };
    EXPECT_EQ(kept.words(marked), problem.words(marked)) << "what can be translated can be translated still";
    // What an older program wrote, or changed without knowing the sentence, is read as it is.
    programme.store->connection().execute(
        "UPDATE setting SET value = replace(value, '\"problem\": \"', '\"problem\": \"older: ') "
        "WHERE key LIKE 'report_schedule %'");
    EXPECT_EQ(schedules.list(director)[0].problem.words(marked).rfind("older: ", 0), 0U);
}

TEST(Schedules, AreLockedForOneRunAtATime) {
    const Programme programme;
    {
        const ScheduleLock first(*programme.store);
        EXPECT_TRUE(first.held());
        const ScheduleLock second(*programme.store);
        EXPECT_FALSE(second.held());
    }
    EXPECT_TRUE(ScheduleLock(*programme.store).held()) << "released";
}

}  // namespace
}  // namespace fulcrum::database
