// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts, several scores of one attempt, void, reassign, comments, and the one query behind screens and
// exports.
#include <cmath>
#include <limits>
#include <set>

#include "assessment/metrics/statement_words.h"
#include "assessment/pathology/pathology.h"
#include "database/records/report_data.h"
#include "database/store/score_rows.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

TEST(Attempt, ComesBackAsItWasRecorded) {
    Programme programme;
    AttemptMeta meta = example_meta(programme.id("ann"));
    meta.utc_offset_min = -330;
    meta.started = noon + 5;
    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    Programme::append_second(recorder);
    AttemptResult result = example_result(false, 0);
    result.score->critical_errors.push_back({12.25, "perforation", "left", "bowel", "Force 14 N"});
    result.missed_ticks = 3;
    result.lost_samples = 1ULL << 40U;
    result.products.push_back({"damage", {1, 2, 3, 0, 255}});
    recorder.finish(result);
    const Session& ann = programme.session("ann");
    const AttemptSummary attempt = programme.attempts().read(ann, recorder.attempt_id());
    EXPECT_EQ(attempt.meta.seed, 0xfedcba9876543210ULL);
    EXPECT_EQ(attempt.meta.started, noon + 5);
    EXPECT_EQ(attempt.meta.utc_offset_min, -330);
    EXPECT_EQ(attempt.state, AttemptState::completed);
    EXPECT_EQ(attempt.passed, false);
    EXPECT_EQ(attempt.lost_samples, 1ULL << 40U);
    EXPECT_EQ(attempt.events, 4U);
    EXPECT_TRUE(attempt.provisional);
    EXPECT_TRUE(attempt.counting);
    const ScoreRow score = *programme.attempts().score(ann, recorder.attempt_id());
    ASSERT_EQ(score.gates.size(), 2U);
    EXPECT_EQ(score.gates[0].value, 812.5);
    EXPECT_EQ(score.gates[1].points, std::nullopt);
    ASSERT_EQ(score.metrics.size(), 2U);
    EXPECT_EQ(score.metrics[0].evidence, (std::vector<std::pair<double, double>>{{0.25, 31.5}}));
    EXPECT_EQ(score.metrics[1].value, std::nullopt);
    EXPECT_EQ(words_of(score.metrics[1].absent_because), "3 movements, fewer than 5");
    EXPECT_EQ(score.metrics[1].version, 2);
    ASSERT_EQ(score.critical_errors.size(), 1U);
    EXPECT_EQ(score.critical_errors[0].time_s, 12.25);
    EXPECT_EQ(programme.attempts().products(ann, recorder.attempt_id())[0].data,
              (std::vector<std::uint8_t>{1, 2, 3, 0, 255}));
}

// Chunks of its end, or all: what is left reads well by itself, but is not the attempt.
TEST(Attempt, IsNotReadAsAShorterOneWhereItsRecordLostItsEnd) {
    for (const char* lost : {"stream = 3", "1"}) {
        Programme programme;
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        recorder.finish(example_result(true, 60));
        const Session& ann = programme.session("ann");
        const std::string id = recorder.attempt_id();
        EXPECT_EQ(programme.attempts().read_trace(ann, id).events.size(), 4U);
        EXPECT_TRUE(programme.store->check(programme.store->station_session()).ok);
        programme.store->connection().execute(QString("DELETE FROM trace_chunk WHERE ") + lost);
        try {
            programme.attempts().read_trace(ann, id);
            ADD_FAILURE() << lost;
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::corrupt);
            EXPECT_NE(error.problem().find(id + " has 0 of its 4 events"), std::string::npos)
                << error.problem();
            EXPECT_EQ(error.hint(), "restore the newest backup");
        }
        EXPECT_EQ(error_kind([&] { programme.attempts().read_events(ann, id); }), StoreErrorKind::corrupt);
        const auto report = programme.store->check(programme.store->station_session());
        EXPECT_FALSE(report.ok);
    }
}

// The events are whole, but of what was written in pairs one side ends early.
TEST(Attempt, IsNotReadWhereItsSamplesOrInputsLostTheirEnd) {
    const std::pair<const char*, const char*> cases[] = {
        {"stream = 0", " has 1000 samples for 2000 inputs: a part of it is missing"},
        {"stream = 1",
         ": a part of the recording is damaged (the inputs that it was made with are missing)"}};
    for (const auto& [lost, reported] : cases) {
        Programme programme;
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        Programme::append_second(recorder, 1000);
        recorder.finish(example_result(true, 60));
        const Session& ann = programme.session("ann");
        const std::string id = recorder.attempt_id();
        EXPECT_EQ(programme.attempts().read_trace(ann, id).samples.size(), 2000U);
        programme.store->connection().execute(QString("DELETE FROM trace_chunk WHERE number = 1 AND ") +
                                              lost);
        try {
            programme.attempts().read_trace(ann, id);
            ADD_FAILURE() << lost;
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::corrupt);
            EXPECT_NE(error.problem().find(id + reported), std::string::npos) << error.problem();
        }
        EXPECT_EQ(error_kind([&] {
                      programme.attempts().read_overview(
                          ann, id, [](std::size_t) {}, [](std::size_t, const TraceOverview&) {});
                  }),
                  StoreErrorKind::corrupt);
        EXPECT_FALSE(programme.store->check(programme.store->station_session()).ok);
    }
}

TEST(Attempt, KeepsThePathologyReportWithItsScore) {
    SpecimenPlan plan{4, 0.06, 0.02, 0.003, 0.006, 0.018, 0.002, 0.01, Tumour{1, Sector::mid, 0.008, 0.012}};
    CutStroke stroke;
    for (const int level : {0, 1, 2, 3})
        stroke.elements.push_back({1, 2, 0.06 * level, 0.06 * (level + 1), 0.0005, 0.0005, 0.06, {}});
    const std::string report = pathology_json(pathology_report({stroke}, plan));
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    Programme::append_second(recorder, 0);
    AttemptResult result = example_result(true, 60);
    result.score->pathology = report;
    recorder.finish(result);
    const Session& ann = programme.session("ann");
    const AttemptReport read = Reports(*programme.store).attempt_report(ann, recorder.attempt_id());
    EXPECT_EQ(read.score->pathology, report);
    ASSERT_TRUE(read.pathology.has_value());
    EXPECT_EQ(pathology_json(*read.pathology), report);
    EXPECT_EQ(read.pathology->grade, 3);
    EXPECT_EQ(read.metric_versions, (std::vector<std::string>{"path_len@1", "sparc@2"}));
    // The screens' series holds the same one.
    const PersonProgress progress = Reports(*programme.store).person_progress(ann, programme.id("ann"), "A2");
    EXPECT_EQ(pathology_json(*progress.series.at(0).points.at(0).pathology), report);
    // The chain knows it: another report, or none, is another digest.
    ScoreRow score = *read.score;
    const std::string digest = score_digest(recorder.attempt_id(), score);
    score.pathology = pathology_json(pathology_report({}, plan));
    EXPECT_NE(score_digest(recorder.attempt_id(), score), digest);
    // Somebody else's attempt is not exported.
    EXPECT_THROW(
        Reports(*programme.store)
            .attempt_report(programme.session("eve"), recorder.attempt_id(), ReportPurpose::exported),
        AccessDenied);
    score.pathology.clear();
    EXPECT_NE(score_digest(recorder.attempt_id(), score), digest);
    EXPECT_FALSE(pathology_of(score).has_value());
}

TEST(Attempt, ItsOverviewIsThatOfItsTraceChunkByChunk) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    for (std::uint32_t second = 0; second < 5; ++second) {
        Programme::append_second(recorder, 1000 * second);
        recorder.flush();
    }
    recorder.finish(example_result(true, 60));
    const Trace trace = programme.attempts().read_trace(programme.session("ann"), recorder.attempt_id());
    std::vector<TraceOverview> parts;
    programme.attempts().read_overview(
        programme.session("ann"), recorder.attempt_id(), [&](std::size_t chunks) { parts.resize(chunks); },
        [&](std::size_t chunk, const TraceOverview& part) { parts[chunk] = part; });
    ASSERT_GE(parts.size(), 5U);
    std::size_t i = 0;
    for (const TraceOverview& part : parts) {
        for (std::size_t k = 0; k < part.tick.size(); ++k, ++i) {
            ASSERT_EQ(part.tick[k], trace.samples[i].tick);
            ASSERT_EQ(static_cast<std::int32_t>(part.hand[1].tip[2][k]), trace.samples[i].hand[1].tip[2]);
        }
    }
    EXPECT_EQ(i, trace.samples.size());
    EXPECT_THROW(programme.attempts().read_overview(
                     programme.session("eve"), recorder.attempt_id(), [](std::size_t) {},
                     [](std::size_t, const TraceOverview&) {}),
                 AccessDenied);
}

TEST(Attempt, TheDigestOfItsRecordChangesWithTheRecordAlone) {
    Programme programme;
    const std::string one = programme.record("ann"), other = programme.record("ann");
    const Attempts attempts = programme.attempts();
    const Session& ann = programme.session("ann");
    const std::string digest = attempts.record_digest(ann, one);
    EXPECT_EQ(digest.size(), 64U);
    attempts.add_score(programme.session("educator"), one, example_score(true, 10));
    EXPECT_EQ(attempts.record_digest(ann, one), digest) << "a further score is no other record";
    EXPECT_THROW(attempts.record_digest(programme.session("ben"), one), AccessDenied);
    std::set<std::string> digests = {digest};
    for (const char* change :
         {"UPDATE trace_chunk SET checksum = x'00' WHERE stream = 1 AND attempt_id = ?",
          "DELETE FROM trace_chunk WHERE stream = 3 AND attempt_id = ?",
          "UPDATE attempt SET seed = 5 WHERE id = ?", "UPDATE attempt SET scene_digest = 'x' WHERE id = ?",
          "UPDATE attempt SET state_hash = 'x' WHERE id = ?"}) {
        for (const char* trigger : {"trace_chunk_is_fixed", "attempt_is_fixed"})
            programme.store->connection().execute(QString("DROP TRIGGER IF EXISTS %1").arg(trigger));
        Query(programme.store->connection(), change).bind(one).run();
        EXPECT_TRUE(digests.insert(attempts.record_digest(ann, one)).second) << change;
    }
    EXPECT_EQ(attempts.record_digest(ann, other), digest) << "recorded with the same trace, and not changed";
}

TEST(Attempt, ARealPersonHasNoSyntheticAttempts) {
    Programme programme;
    AttemptMeta meta = example_meta(programme.id("ann"));
    meta.device_class = DeviceClass::synthetic;
    EXPECT_EQ(error_kind([&] {
                  const Recorder r(programme.path, programme.session("ann"), meta, programme.clock.options());
              }),
              StoreErrorKind::bad_value);
    EXPECT_TRUE(programme.attempts().list(programme.session("ann")).empty());
}

TEST(Attempt, NotANumberIsNeverStored) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    AttemptResult result = example_result(true, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(error_kind([&] { recorder.finish(result); }), StoreErrorKind::bad_value);
    EXPECT_FALSE(recorder.finished());
    result.score->points.reset();
    recorder.finish(result);
    EXPECT_EQ(programme.attempts().scores(programme.session("ann"), recorder.attempt_id()).size(), 1U);
}

TEST(Score, TheFirstStaysInForceAndOthersAreKept) {
    Programme programme;
    const std::string attempt = programme.record("ann", true, 70);
    const Session& educator = programme.session("educator");
    ScoreRow later = example_score(false, 20);
    later.limits = "A2-site@2";
    programme.clock.pass_s(60);
    programme.attempts().add_score(educator, attempt, later);
    EXPECT_EQ(programme.attempts().read(educator, attempt).points, 70);
    const auto scores = programme.attempts().scores(educator, attempt);
    ASSERT_EQ(scores.size(), 2U);
    EXPECT_TRUE(scores[0].in_force);
    EXPECT_FALSE(scores[1].in_force);
    EXPECT_EQ(scores[1].limits, "A2-site@2");
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
}

TEST(Score, IsStaleUntilOneRestsOnWhatIsInForce) {
    const Programme programme;
    const std::string first = programme.record("ann"), second = programme.record("ben"),
                      elsewhere = programme.record("eve");
    const Attempts attempts = programme.attempts();
    const Session& educator = programme.session("educator");
    ScoringInForce now;
    now.metric_versions = {{"path_len", 1}, {"sparc", 2}, {"time", 4}};
    std::string in_force = "A2-operators@1";
    now.limits = [&](const AttemptMeta& attempt) {
        return attempt.task_id == "A2" && attempt.device_class == DeviceClass::mouse_keyboard &&
                       attempt.variant == "standard" && attempt.fidelity == "standard"
                   ? in_force
                   : std::string();
    };
    EXPECT_TRUE(attempts.stale_scores(educator, now).empty());
    now.metric_versions["sparc"] = 3;
    auto stale = attempts.stale_scores(educator, now);
    ASSERT_EQ(stale.size(), 2U) << "of their cohort";
    EXPECT_EQ(stale[0].why, "sparc 2, now 3");
    EXPECT_EQ(stale[0].task_id, "A2");
    EXPECT_EQ(stale[0].passed, true);
    ASSERT_EQ(attempts.stale_scores(educator, now, programme.id("ben")).size(), 1U);
    EXPECT_THROW(attempts.stale_scores(educator, now, programme.id("eve")), AccessDenied);
    EXPECT_THROW(attempts.stale_scores(programme.session("ann"), now), AccessDenied);
    EXPECT_EQ(attempts.stale_scores(programme.session("other_educator"), now).size(), 0U);
    EXPECT_EQ(attempts.stale_scores(programme.session("station"), now).size(), 0U) << "real people";

    ScoreRow newer = example_score(false, 40);
    newer.metrics[1].version = 3;
    attempts.add_score(educator, first, newer);
    stale = attempts.stale_scores(educator, now);
    ASSERT_EQ(stale.size(), 1U);
    EXPECT_EQ(stale[0].attempt_id, second);
    in_force = "A2-site@1";
    now.metric_versions.erase("path_len");
    stale = attempts.stale_scores(educator, now);
    ASSERT_EQ(stale.size(), 2U);
    for (const StaleScore& score : stale) {
        EXPECT_NE(score.why.find("path_len 1, now none"), std::string::npos) << score.why;
        EXPECT_NE(score.why.find("limits A2-operators@1, now A2-site@1"), std::string::npos) << score.why;
    }
    attempts.void_attempt(educator, second, "wrong person");
    EXPECT_EQ(attempts.stale_scores(educator, now).size(), 1U) << "what is voided is left alone";
}

TEST(Void, KeepsTheAttemptVisibleAndOutOfTheCounts) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    const Session& educator = programme.session("educator");
    EXPECT_EQ(error_kind([&] { programme.attempts().void_attempt(educator, attempt, "  "); }),
              StoreErrorKind::bad_value);
    programme.attempts().void_attempt(educator, attempt, "Ben sat at the table");
    const AttemptSummary voided = programme.attempts().read(programme.session("ann"), attempt);
    EXPECT_EQ(voided.state, AttemptState::voided);
    EXPECT_EQ(voided.recorded_state, AttemptState::completed);
    EXPECT_EQ(voided.void_reason, "Ben sat at the table");
    EXPECT_EQ(voided.voided_by, "Edu Cator");
    EXPECT_FALSE(voided.counting);
    EXPECT_EQ(error_kind([&] { programme.attempts().void_attempt(educator, attempt, "again"); }),
              StoreErrorKind::conflict);
    CohortTableOptions options;
    options.tasks = {"A2"};
    for (const CohortRow& row :
         Reports(*programme.store).cohort_table(educator, programme.cohort, options).rows) {
        EXPECT_EQ(row.state, TaskState::open);
    }
    AttemptFilter filter;
    filter.state = AttemptState::voided;
    EXPECT_EQ(programme.attempts().list(educator, filter).size(), 1U);
    filter.state = AttemptState::completed;
    EXPECT_TRUE(programme.attempts().list(educator, filter).empty());
}

TEST(Reassign, VoidsAndCopiesEverythingToTheRightPerson) {
    Programme programme;
    const std::string attempt = programme.record("ann", true, 64);
    const Session& educator = programme.session("educator");
    EXPECT_THROW(programme.attempts().reassign(educator, attempt, programme.id("eve"), "wrong"),
                 AccessDenied);
    const std::string copy =
        programme.attempts().reassign(educator, attempt, programme.id("ben"), "Ben sat at the table");
    const AttemptSummary right = programme.attempts().read(programme.session("ben"), copy);
    EXPECT_EQ(right.reassigned_from, attempt);
    EXPECT_EQ(right.points, 64);
    EXPECT_TRUE(right.counting);
    const AttemptSummary wrong = programme.attempts().read(programme.session("ann"), attempt);
    EXPECT_EQ(wrong.state, AttemptState::voided);
    EXPECT_EQ(wrong.reassigned_to, copy);
    EXPECT_EQ(programme.attempts().read_trace(programme.session("ben"), copy).samples.size(), 1000U);
    EXPECT_EQ(programme.attempts().score(programme.session("ben"), copy)->metrics.size(), 2U);
    EXPECT_THROW(programme.attempts().read(programme.session("ann"), copy), AccessDenied);
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
}

// The force scale is shown in the debrief, and a replay needs all the values.
TEST(Attempt, KeepsTheDevicesThatRenderedForceAlsoForAnotherPerson) {
    Programme programme;
    AttemptMeta meta = example_meta(programme.id("ann"));
    ForceOutput device;
    device.damping = 0.1 + 0.2;
    device.peak = 3.3;
    device.continuous = 0.88;
    device.scale = 0.4;
    meta.force_devices[1] = device;
    meta.rig_use = RigUse();
    meta.rig_use->stated = 1000;
    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    Programme::append_second(recorder);
    AttemptResult result = example_result(true, 80);
    result.rig_use = meta.rig_use;
    result.rig_use->measured = 987.5;
    recorder.finish(result);
    const std::string copy = programme.attempts().reassign(
        programme.session("educator"), recorder.attempt_id(), programme.id("ben"), "Ben sat at the table");
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok) << "the digest covers the rate";
    for (const std::string& id : {recorder.attempt_id(), copy}) {
        const ForceDevices& kept =
            programme.attempts().read(programme.session("educator"), id).meta.force_devices;
        EXPECT_FALSE(kept[0].has_value());
        ASSERT_TRUE(kept[1].has_value());
        EXPECT_EQ(kept[1]->damping, device.damping);
        EXPECT_EQ(kept[1]->continuous, 0.88);
        EXPECT_EQ(kept[1]->scale, 0.4);
        const auto& use = programme.attempts().read(programme.session("educator"), id).meta.rig_use;
        ASSERT_TRUE(use.has_value());
        EXPECT_EQ(use->stated, 1000);
        EXPECT_EQ(use->measured, 987.5);
    }
}

TEST(Correction, ATraineeAsksAndTheEducatorSeesIt) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    programme.attempts().request_correction(programme.session("ann"), attempt, "this was Ben");
    EXPECT_TRUE(programme.attempts().correction_requests(programme.session("ben")).empty());
    EXPECT_TRUE(programme.attempts().correction_requests(programme.session("other_educator")).empty());
    auto requests = programme.attempts().correction_requests(programme.session("educator"));
    ASSERT_EQ(requests.size(), 1U);
    EXPECT_FALSE(requests[0].settled);
    programme.attempts().reassign(programme.session("educator"), attempt, programme.id("ben"),
                                  requests[0].text);
    EXPECT_TRUE(programme.attempts().correction_requests(programme.session("educator"))[0].settled);
}

TEST(Comments, DraftsAreTheAuthorsSentOnesAreReadByTheTrainee) {
    Programme programme;
    const std::string attempt = programme.record("ann");
    const Session &educator = programme.session("educator"), &ann = programme.session("ann");
    const Reviews reviews(*programme.store);
    const std::string draft = reviews.write(educator, attempt, 12.5, "Elbow", false);
    EXPECT_TRUE(reviews.comments(ann, attempt).empty());
    EXPECT_TRUE(reviews.comments(programme.session("director"), attempt).empty());
    EXPECT_EQ(reviews.drafts(educator).size(), 1U);
    reviews.edit_draft(educator, draft, 13, "Elbow in");
    reviews.send(educator, draft);
    EXPECT_EQ(error_kind([&] { reviews.edit_draft(educator, draft, 13, "No"); }), StoreErrorKind::conflict);
    const auto unread = reviews.unread(ann);
    ASSERT_EQ(unread.size(), 1U);
    EXPECT_EQ(unread[0].text, "Elbow in");
    EXPECT_EQ(unread[0].author_name, "Edu Cator");
    EXPECT_EQ(unread[0].time_s, 13);
    EXPECT_EQ(programme.attempts().read(ann, attempt).unread_comments, 1);
    EXPECT_THROW(reviews.mark_read(programme.session("ben"), draft), AccessDenied);
    reviews.mark_read(ann, draft);
    EXPECT_TRUE(reviews.unread(ann).empty());
    EXPECT_GT(reviews.comments(educator, attempt)[0].read, 0);
    EXPECT_EQ(programme.attempts().read(ann, attempt).comments, 1);
    EXPECT_EQ(error_kind([&] { reviews.write(educator, attempt, -1, "x", true); }),
              StoreErrorKind::bad_value);
    const std::string other = reviews.write(educator, attempt, 1, "drop me", false);
    reviews.delete_draft(educator, other);
    EXPECT_TRUE(reviews.drafts(educator).empty());
}

}  // namespace
// The schema refuses unknown words; a damaged or foreign store may hold them all the same.
TEST(Attempts, UnknownWordsInTheStoreAreErrorsWithPlaceAndHint) {
    const Programme programme;
    const std::string attempt = programme.record("ann");
    Connection& connection = programme.store->connection();
    connection.execute("PRAGMA ignore_check_constraints = ON");
    std::vector<std::string> triggers;
    {
        Query names(connection, "SELECT name FROM sqlite_master WHERE type = 'trigger'");
        while (names.next()) triggers.push_back(names.text(0));
    }
    for (const std::string& trigger : triggers)
        Query(connection, "DROP TRIGGER " + QString::fromStdString(trigger)).run();
    const auto problem_with = [&](const QString& change) {
        const Transaction undone(connection);
        Query(connection, change).run();
        try {
            programme.attempts().read(programme.session("ann"), attempt);
            programme.attempts().score(programme.session("ann"), attempt);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::corrupt);
            EXPECT_NE(error.hint().find("restore the newest backup"), std::string::npos);
            return error.problem();
        }
        return std::string();
    };
    EXPECT_EQ(problem_with("UPDATE attempt SET mode = 'exam'"),
              "mode of attempt " + attempt + ": 'exam' is unknown; known are practice, assessed");
    EXPECT_NE(problem_with("UPDATE attempt SET device_class = 'telepathy'")
                  .find("device class of attempt " + attempt),
              std::string::npos);
    EXPECT_NE(problem_with("UPDATE attempt SET state = 'lost'").find("'lost' is unknown"), std::string::npos);
    EXPECT_NE(problem_with("UPDATE gate SET kind = 'soft'").find("known are benchmark, absolute"),
              std::string::npos);
    EXPECT_NE(
        problem_with("UPDATE metric SET direction = 'sideways'").find("known are lower, higher, context"),
        std::string::npos);
    EXPECT_NE(problem_with("UPDATE person SET kind = 'robot'").find("known are real, synthetic, external"),
              std::string::npos);
    EXPECT_EQ(problem_with("UPDATE attempt SET mode = 'practice'"), "");
}

// Stores hold ids and parameters; those from before hold English sentences, which stay as they are.
TEST(Attempts, KeepStatementsAsCodesAndOldSentencesAsTheyAre) {
    const Programme programme;
    const std::string attempt = programme.record("ann");
    Connection& connection = programme.store->connection();
    const auto stored = [&](const char* sql) {
        Query row(connection, sql);
        row.bind(attempt);
        return row.next() ? row.text(0) : std::string();
    };
    EXPECT_EQ(stored("SELECT m.absent_because FROM metric m JOIN score s ON s.id = m.score_id "
                     "WHERE s.attempt_id = ? AND m.id = 'sparc'"),
              R"({"id":"metric.few_movements","count":3.0,"least":5.0})");
    EXPECT_EQ(stored("SELECT advice FROM score WHERE attempt_id = ?"),
              R"({"id":"advice.gate_missed","limit":4.0,"metric":"f_max","value":6.0})");
    const auto score = programme.attempts().score(programme.session("ann"), attempt);
    ASSERT_TRUE(score);
    EXPECT_EQ(score->advice, example_score(true, 70).advice);

    ScoreRow old = example_score(false, 20);
    old.advice = Statement::plain("Left hand: the force rose to 6.0 N; approach slowly.");
    old.metrics[1].absent_because = Statement::plain("fewer than 5 segments");
    programme.attempts().add_score(programme.session("educator"), attempt, old);
    const ScoreRow read = programme.attempts().scores(programme.session("ann"), attempt).at(1);
    EXPECT_EQ(words_of(read.advice), "Left hand: the force rose to 6.0 N; approach slowly.");
    EXPECT_EQ(words_of(read.metrics[1].absent_because), "fewer than 5 segments");
}

}  // namespace fulcrum::database::test
