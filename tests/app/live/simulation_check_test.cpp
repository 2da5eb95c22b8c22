// SPDX-License-Identifier: GPL-3.0-or-later
// What the holder of the station's key replaces and signs again passes every other part of the check.
#include "app/live/simulation_check.h"

#include <QTemporaryDir>

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "tests/app/live/kept_station.h"

namespace fulcrum::app {
namespace {

using database::RecordKind;

class SimulationCheck : public ::testing::Test {
  protected:
    SimulationCheck() {
        const LoadedTask loaded = load_task_and_scene("A2");
        for (const std::uint64_t seed : {11ULL, 12ULL}) {
            PerformRequest request;
            request.loaded = loaded;
            request.operator_level = OperatorLevel::expert;
            request.seed = seed;
            request.assessed = false;
            database::AttemptMeta meta = station.meta(loaded);
            meta.seed = seed;
            const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
            database::Recorder recorder(path, station.session, meta);
            perform(request, &recorder, limits);
            ids.push_back(recorder.attempt_id());
        }
    }
    database::CheckItem check(int attempts, std::uint64_t seed = 1, double most_s = 0) const {
        SimulationSample sample;
        sample.attempts = attempts;
        sample.seed = seed;
        sample.most_s = most_s;
        return check_by_simulation(station.store, station.session, sample);
    }
    static std::string words(const std::vector<Sentence>& sentences) {
        std::string all;
        for (const Sentence& one : sentences) all += one.words() + "\n";
        return all;
    }
    void execute(const QString& sql) const { station.store.connection().execute(sql); }
    /// Puts other data in place of a chunk, as whoever has the file can; the trigger is put back.
    void replace_chunk(const std::string& id, int stream, std::int64_t number,
                       const database::TraceChunk& chunk) const {
        std::string trigger;
        {
            database::Query row(station.store.connection(),
                                "SELECT sql FROM sqlite_master WHERE name = 'trace_chunk_is_fixed'");
            ASSERT_TRUE(row.next());
            trigger = row.text(0);
        }
        execute("DROP TRIGGER trace_chunk_is_fixed");
        database::Query(
            station.store.connection(),
            "UPDATE trace_chunk SET data = ?, checksum = ? WHERE attempt_id = ? AND stream = ? AND "
            "number = ?")
            .bind(chunk.data)
            .bind(chunk.checksum)
            .bind(id)
            .bind(stream)
            .bind(number)
            .run();
        execute(QString::fromStdString(trigger));
    }
    /// What the station's key signs says that the records are as they are now.
    void sign_again(const std::string& id) const {
        database::Audit(station.store)
            .append(station.session, id, "score.add", "{}",
                    {{RecordKind::attempt, id}, {RecordKind::trace, id}});
    }
    /// The forces of a second, all gone.
    void take_forces_away(const std::string& id) const {
        database::TraceCodec codec;
        const database::Trace trace = database::Attempts(station.store).read_trace(station.session, id);
        database::TraceChunk stored;
        {
            database::Query row(
                station.store.connection(),
                "SELECT first_tick, last_tick FROM trace_chunk WHERE attempt_id = ? AND stream = "
                "0 AND number = 2");
            row.bind(id);
            ASSERT_TRUE(row.next());
            stored.first_tick = static_cast<std::uint32_t>(row.integer(0));
            stored.last_tick = static_cast<std::uint32_t>(row.integer(1));
        }
        std::vector<TickSample> samples;
        std::vector<RigSample> inputs;
        for (std::size_t i = 0; i < trace.samples.size(); ++i) {
            if (trace.samples[i].tick < stored.first_tick || trace.samples[i].tick > stored.last_tick)
                continue;
            samples.push_back(trace.samples[i]);
            inputs.push_back(trace.inputs[i]);
        }
        for (TickSample& sample : samples) {
            sample.hand[0].force[0] = sample.hand[0].force[1] = sample.hand[0].force[2] = 0;
            sample.hand[1].tip[0] += 1;  // 0.1 um
        }
        replace_chunk(id, 0, 2, codec.encode(samples.data(), samples.size(), inputs.data()));
    }

    QTemporaryDir folder;
    const std::string path = folder.filePath("a.db").toStdString();
    KeptStation station{path};
    std::vector<std::string> ids;
};

TEST_F(SimulationCheck, RepeatsWhatWasRecordedAndNamesEachAttemptAndTheSeed) {
    const database::CheckItem item = check(10, 77);
    EXPECT_TRUE(item.ok) << words(item.problems);
    EXPECT_EQ(item.count, 2);
    EXPECT_NE(words(item.notes).find("2 attempts drawn of 2 with the seed 77"), std::string::npos)
        << words(item.notes);
    for (const std::string& id : ids) EXPECT_NE(words(item.notes).find(id), std::string::npos);
}

TEST_F(SimulationCheck, FindsSamplesThatWereReplacedAndSignedAgain) {
    take_forces_away(ids[0]);
    EXPECT_FALSE(station.store.check(station.session).ok) << "not signed again";
    sign_again(ids[0]);
    const database::CheckReport report = station.store.check(station.session);
    for (const database::CheckItem& one : report.items)
        EXPECT_TRUE(one.ok) << one.name << ": " << words(one.problems) << "only a simulation finds this";
    const database::CheckItem item = check(10);
    EXPECT_FALSE(item.ok);
    EXPECT_NE(words(item.problems).find("attempt " + ids[0] + ": its record is not what its inputs give"),
              std::string::npos)
        << words(item.problems);
    EXPECT_EQ(words(item.problems).find(ids[1]), std::string::npos) << "the other one is as it was";
}

TEST_F(SimulationCheck, FindsAnErrorEventThatWasTakenAway) {
    database::TraceCodec codec;
    const database::Trace trace = database::Attempts(station.store).read_trace(station.session, ids[1]);
    std::vector<Event> events;
    std::int64_t number = -1;
    {
        database::Query row(
            station.store.connection(),
            "SELECT number, first_tick, last_tick, records FROM trace_chunk WHERE attempt_id = ? "
            "AND stream = 3 AND records > 1 ORDER BY number LIMIT 1");
        row.bind(ids[1]);
        ASSERT_TRUE(row.next());
        number = row.integer(0);
        for (const Event& event : trace.events)
            if (event.tick >= row.integer(1) && event.tick <= row.integer(2)) events.push_back(event);
        ASSERT_EQ(static_cast<std::int64_t>(events.size()), row.integer(3));
    }
    // Another hand did it.
    const auto found = std::find_if(events.begin(), events.end(),
                                    [](const Event& one) { return one.kind == EventKind::first_movement; });
    Event& changed = found != events.end() ? *found : events.back();
    changed.hand = changed.hand == 0 ? 1 : 0;
    replace_chunk(ids[1], 3, number, codec.encode(events.data(), events.size()));
    sign_again(ids[1]);
    EXPECT_TRUE(station.store.check(station.session).ok);
    const database::CheckItem item = check(10);
    EXPECT_NE(words(item.problems).find("attempt " + ids[1] + ": its events"), std::string::npos)
        << words(item.problems);
}

TEST_F(SimulationCheck, DrawsTheSameSampleForTheSameSeedAndAnotherForOthers) {
    std::set<std::string> drawn;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const std::string notes = words(check(1, seed).notes);
        EXPECT_EQ(notes, words(check(1, seed).notes));
        drawn.insert(notes.find(ids[0]) != std::string::npos ? ids[0] : ids[1]);
        if (drawn.size() == 2) break;
    }
    EXPECT_EQ(drawn.size(), 2U);
}

TEST_F(SimulationCheck, SaysWhatItLeftOut) {
    EXPECT_EQ(check(0).count, 0);
    const database::CheckItem late = check(2, 1, 1e-9);
    EXPECT_TRUE(late.ok);
    EXPECT_EQ(late.count, 0);
    EXPECT_NE(words(late.notes).find("the time was over"), std::string::npos);
    execute(
        "PRAGMA foreign_keys = OFF; DROP TRIGGER attempt_is_fixed; UPDATE attempt SET program_version = "
        "'0.0.1'");
    const database::CheckItem old = check(2);
    EXPECT_TRUE(old.ok);
    EXPECT_NE(words(old.notes).find("2 attempts of other versions"), std::string::npos) << words(old.notes);
}

}  // namespace
}  // namespace fulcrum::app
