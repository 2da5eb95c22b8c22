// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts whose trace was not kept: the record says so, and nobody can make it say so later.
#include <gtest/gtest.h>

#include <QFile>

#include "database/rows/connection.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

std::string record_without_trace(Programme& programme, bool keep) {
    AttemptMeta meta = example_meta(programme.session("ann").person_id());
    meta.keep_trace = keep;
    Recorder recorder(programme.path, programme.session("ann"), meta, programme.clock.options());
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 80));
    EXPECT_EQ(recorder.bytes_written() == 0, !keep);
    return recorder.attempt_id();
}

Sentence problem_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const StoreError& error) {
        return error.problem_sentence();
    }
    return {};
}

TEST(TraceNotKept, ScoreIsStoredAndTheRecordSaysThatTheTraceIsNot) {
    Programme programme;
    const std::string id = record_without_trace(programme, false);
    const Session ann = programme.session("ann");
    const AttemptSummary summary = programme.attempts().read(ann, id);
    EXPECT_FALSE(summary.meta.keep_trace);
    EXPECT_EQ(summary.events, 0U);
    EXPECT_EQ(summary.points, 80);
    EXPECT_TRUE(summary.counting);
    for (const Sentence& problem : {problem_of([&] { programme.attempts().read_trace(ann, id); }),
                                    problem_of([&] { programme.attempts().read_events(ann, id); })})
        EXPECT_NE(problem.words().find("was not kept"), std::string::npos) << problem.words();
    EXPECT_TRUE(programme.attempts().read(ann, record_without_trace(programme, true)).meta.keep_trace);
    const CheckReport report = programme.store->check(programme.session("station"));
    for (const CheckItem& item : report.items)
        EXPECT_TRUE(item.ok) << item.name << ": " << (item.problems.empty() ? "" : item.problems[0].words());
    // A score cannot be made again without the trace, so nobody is asked to.
    ScoringInForce now;
    now.limits = [](const AttemptMeta&) { return std::string("other@9"); };
    const std::vector<StaleScore> stale =
        programme.attempts().stale_scores(programme.session("educator"), now);
    EXPECT_EQ(std::count_if(stale.begin(), stale.end(),
                            [&](const StaleScore& one) { return one.attempt_id == id; }),
              0);
    EXPECT_FALSE(stale.empty());
}

TEST(TraceNotKept, DeletedTraceIsNotTakenForOneThatWasNotKept) {
    Programme programme;
    const std::string id = record_without_trace(programme, true);
    Connection& connection = programme.store->connection();
    connection.execute("DROP TRIGGER attempt_is_fixed");
    connection.execute(QString::fromStdString("DELETE FROM trace_chunk WHERE attempt_id = '" + id + "'"));
    connection.execute(QString::fromStdString("UPDATE attempt SET events = -1 WHERE id = '" + id + "'"));
    const CheckReport report = programme.store->check(programme.session("station"));
    EXPECT_FALSE(report.ok);
    std::string found;
    for (const CheckItem& item : report.items)
        for (const Sentence& problem : item.problems) found += problem.words() + "\n";
    EXPECT_NE(found.find("attempt " + id + ": changed"), std::string::npos) << found;
    EXPECT_NE(found.find("trace " + id), std::string::npos) << found;
}

TEST(TraceNotKept, ChunksOfSuchAnAttemptAreAFinding) {
    Programme programme;
    const std::string without = record_without_trace(programme, false),
                      with = record_without_trace(programme, true);
    Connection& connection = programme.store->connection();
    connection.execute("DROP TRIGGER trace_chunk_of_running");
    connection.execute(QString::fromStdString("INSERT INTO trace_chunk SELECT '" + without +
                                              "', stream, number, first_tick, last_tick, records, checksum, "
                                              "data FROM trace_chunk WHERE attempt_id = '" +
                                              with + "'"));
    EXPECT_FALSE(programme.store->check(programme.session("station")).ok);
}

TEST(DemonstrationClock, ResumesWhenTheRecordEnds) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("demo.db").toStdString();
    constexpr UtcMilliseconds then = noon - 400LL * 86'400'000;
    StoreOptions options;
    options.clock = [] { return then; };
    {
        Store store = Store::create(path, true, options);
        EXPECT_EQ(store.now(), then);
        // Until it is sealed time is the machine's.
        EXPECT_GT(Store::open(path).now(), then + 86'400'000);
        store.seal_demo(store.station_session());
    }
    const Store first = Store::open(path), second = Store::open(path);
    for (const Store* store : {&first, &second}) {
        EXPECT_GE(store->now(), then);
        EXPECT_LT(store->now(), then + 60'000);
    }
    EXPECT_TRUE(first.check(first.station_session()).ok);
    Query payload(
        first.connection(),
        "SELECT p.payload FROM audit_entry e JOIN audit_payload p USING (station_id, sequence) WHERE "
        "e.operation = 'demo.seal'");
    ASSERT_TRUE(payload.next());
    EXPECT_NE(payload.text(0).find("\"sealed\": \"20"), std::string::npos) << payload.text(0);
}

}  // namespace
}  // namespace fulcrum::database::test
