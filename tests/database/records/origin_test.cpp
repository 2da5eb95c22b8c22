// SPDX-License-Identifier: GPL-3.0-or-later
// Practice that began with a state of another attempt: what the store keeps of it, and that it is never
// scored.
#include <algorithm>

#include "database/rows/packed_bytes.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

const std::vector<std::uint8_t> some_state = [] {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 100000; ++i) bytes.push_back(static_cast<std::uint8_t>(i * i >> 7));
    return bytes;
}();

AttemptMeta taken_over(const std::string& person_id, const std::string& source) {
    AttemptMeta meta = example_meta(person_id);
    meta.mode = AttemptMode::practice;
    meta.origin.emplace();
    meta.origin->source_id = source;
    meta.origin->tick = 4200;
    meta.origin->goal = 1;
    meta.origin->build = "0.1.0 physics 2 x86-64-v3";
    meta.origin->state = pack_bytes(some_state);
    return meta;
}

AttemptResult unscored() {
    AttemptResult result = example_result(true, 70);
    result.score.reset();
    return result;
}

std::string record_from(const Programme& programme, const std::string& source) {
    Recorder recorder(programme.path, programme.session("ann"), taken_over(programme.id("ann"), source),
                      programme.clock.options());
    Programme::append_second(recorder, 4201);
    recorder.finish(unscored());
    return recorder.attempt_id();
}

TEST(AttemptOrigin, IsReadBackWithItsState) {
    const Programme programme;
    const std::string source = programme.record("ann");
    const std::string attempt = record_from(programme, source);
    const AttemptSummary read = programme.attempts().read(programme.session("ann"), attempt);
    ASSERT_TRUE(read.meta.origin);
    EXPECT_EQ(read.meta.origin->source_id, source);
    EXPECT_EQ(read.meta.origin->tick, 4200U);
    EXPECT_EQ(read.meta.origin->goal, 1);
    EXPECT_EQ(read.meta.origin->build, "0.1.0 physics 2 x86-64-v3");
    EXPECT_FALSE(read.counting);
    EXPECT_EQ(programme.attempts().start_state(programme.session("ann"), attempt), some_state);
    EXPECT_FALSE(programme.attempts().read(programme.session("ann"), source).meta.origin);
    EXPECT_TRUE(programme.attempts().start_state(programme.session("ann"), source).empty());
    EXPECT_THROW(programme.attempts().start_state(programme.session("ben"), attempt), AccessDenied);
}

TEST(AttemptOrigin, OfADemonstrationNamesNoAttempt) {
    const Programme programme;
    const AttemptSummary read =
        programme.attempts().read(programme.session("ann"), record_from(programme, ""));
    ASSERT_TRUE(read.meta.origin);
    EXPECT_TRUE(read.meta.origin->source_id.empty());
}

TEST(AttemptOrigin, IsPracticeAndNeverScored) {
    Programme programme;
    AttemptMeta assessed = taken_over(programme.id("ann"), "");
    assessed.mode = AttemptMode::assessed;
    EXPECT_EQ(error_kind([&] {
                  Recorder(programme.path, programme.session("ann"), assessed, programme.clock.options());
              }),
              StoreErrorKind::bad_value);
    {
        Recorder recorder(programme.path, programme.session("ann"), taken_over(programme.id("ann"), ""),
                          programme.clock.options());
        Programme::append_second(recorder, 4201);
        EXPECT_EQ(error_kind([&] { recorder.finish(example_result(true, 70)); }), StoreErrorKind::bad_value);
        recorder.finish(unscored());
        EXPECT_EQ(error_kind([&] {
                      programme.attempts().add_score(programme.session("educator"), recorder.attempt_id(),
                                                     example_score(true, 70));
                  }),
                  StoreErrorKind::conflict);
    }
    std::string broken;
    {
        Recorder recorder(programme.path, programme.session("ann"), taken_over(programme.id("ann"), ""),
                          programme.clock.options());
        Programme::append_second(recorder, 4201);
        recorder.flush();
        broken = recorder.attempt_id();
    }
    programme.open();
    const AttemptSummary closed = programme.attempts().read(programme.session("ann"), broken);
    EXPECT_EQ(closed.state, AttemptState::interrupted);
    EXPECT_DOUBLE_EQ(closed.duration_s, 1.0) << "without what came before its first tick";
    EXPECT_TRUE(programme.attempts().interrupted_without_score(programme.session("ann")).empty());
}

TEST(AttemptOrigin, IsKnownToReports) {
    const Programme programme;
    programme.record("ann");
    programme.clock.pass_s(60);
    record_from(programme, "");
    const Reports reports(*programme.store);
    const Session& director = programme.session("director");
    const auto expect_second = [](const PersonProgress& progress) {
        ASSERT_EQ(progress.series.size(), 1U);
        const std::vector<ProgressPoint>& points = progress.series[0].points;
        ASSERT_EQ(points.size(), 2U);
        EXPECT_FALSE(points[0].continues);
        EXPECT_TRUE(points[1].continues);
        EXPECT_EQ(points[1].state, AttemptState::completed);
        EXPECT_FALSE(points[1].passed);
    };
    expect_second(reports.person_progress(director, programme.id("ann"), "A2"));
    PersonDataOptions options;
    options.tasks = {"A2"};
    int people = 0;
    EXPECT_TRUE(reports.each_of_cohort(director, programme.cohort, options, [&](PersonData&& person, double) {
        if (person.login == "ann") {
            ++people;
            EXPECT_EQ(person.progress.size(), 1U);
            if (!person.progress.empty()) expect_second(person.progress[0]);
        }
        return true;
    }));
    EXPECT_EQ(people, 1);
}

TEST(AttemptOrigin, GoesWithTheCopyOfAReassignedAttempt) {
    const Programme programme;
    const std::string attempt = record_from(programme, "");
    const std::string copy = programme.attempts().reassign(programme.session("educator"), attempt,
                                                           programme.id("ben"), "Ben sat here");
    EXPECT_TRUE(programme.attempts().read(programme.session("ben"), copy).meta.origin);
    EXPECT_EQ(programme.attempts().start_state(programme.session("ben"), copy), some_state);
}

TEST(AttemptOrigin, ADamagedStateIsFound) {
    Programme programme;
    const std::string attempt = record_from(programme, "");
    programme.store->connection().execute("DROP TRIGGER attempt_origin_is_fixed");
    programme.store->connection().execute("UPDATE attempt_origin SET state = substr(state, 1, 100)");
    EXPECT_EQ(error_kind([&] { programme.attempts().start_state(programme.session("ann"), attempt); }),
              StoreErrorKind::corrupt);
    const CheckReport report = programme.store->check(programme.session("administrator"));
    EXPECT_TRUE(std::any_of(report.items.begin(), report.items.end(), [&](const CheckItem& item) {
        return std::any_of(item.problems.begin(), item.problems.end(), [&](const Sentence& problem) {
            return problem.words().find(attempt) != std::string::npos &&
                   problem.words().find("began with") != std::string::npos;
        });
    }));
}

TEST(PackedBytes, AreTheSameAgainAndDamageIsRefused) {
    EXPECT_EQ(unpack_bytes(pack_bytes(some_state)), some_state);
    EXPECT_TRUE(unpack_bytes(pack_bytes({})).empty());
    std::vector<std::uint8_t> cut = pack_bytes(some_state);
    cut.resize(cut.size() / 2);
    EXPECT_EQ(error_kind([&] { unpack_bytes(cut); }), StoreErrorKind::corrupt);
    EXPECT_EQ(error_kind([] { unpack_bytes({1, 2, 3}); }), StoreErrorKind::corrupt);
}

}  // namespace
}  // namespace fulcrum::database::test
