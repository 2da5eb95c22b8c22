// SPDX-License-Identifier: GPL-3.0-or-later
// What the holder of the station's key replaces and signs again passes every other part of the check.
#include "app/live/simulation_check.h"

#include <QTemporaryDir>
#include <iostream>
#include <sstream>

#include "app/services/program.h"
#include "database/rows/connection.h"
#include "tests/app/live/forged_record.h"

namespace fulcrum::app {
namespace {

class SimulationCheck : public ::testing::Test {
  protected:
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
    /// What `fulcrum replay ID` says, with its exit status.
    std::pair<int, std::string> replay(const std::string& id, const std::vector<std::string>& more) const {
        std::vector<std::string> command{"replay", id, "--db", path};
        command.insert(command.end(), more.begin(), more.end());
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        const int status = run_command(command);
        std::cout.rdbuf(before);
        return {status, output.str()};
    }

    QTemporaryDir folder;
    const std::string path = folder.filePath("a.db").toStdString();
    const std::vector<std::string> ids = place_two_attempts(path);
    KeptStation station{path};
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
    take_forces_away(station, ids[0]);
    EXPECT_FALSE(station.store.check(station.session).ok) << "not signed again";
    sign_again(station, ids[0]);
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

TEST_F(SimulationCheck, FindsAnEndThatWasReplacedAndSignedAgainAsReplayDoes) {
    EXPECT_EQ(replay(ids[0], {"--verify"}).first, 0);
    replace_end(station, ids[0]);
    sign_again(station, ids[0]);
    EXPECT_TRUE(station.store.check(station.session).ok) << "only a simulation finds this";
    const database::CheckItem item = check(10);
    EXPECT_FALSE(item.ok);
    EXPECT_EQ(words(item.problems),
              "attempt " + ids[0] + ": it ends in another state than the store has of it\n");
    const auto [status, said] = replay(ids[0], {"--verify"});
    EXPECT_EQ(status, 1);
    EXPECT_NE(said.find("but the store has 00c0ffee00c0ffee"), std::string::npos) << said;
    EXPECT_EQ(replay(ids[0], {}).first, 0) << "it was not asked";
    EXPECT_EQ(replay(ids[1], {"--verify"}).first, 0) << "the other one is as it was";
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
    replace_chunk(station, ids[1], 3, number, codec.encode(events.data(), events.size()));
    sign_again(station, ids[1]);
    EXPECT_TRUE(station.store.check(station.session).ok);
    const database::CheckItem item = check(10);
    EXPECT_NE(words(item.problems).find("attempt " + ids[1] + ": its events"), std::string::npos)
        << words(item.problems);
}

TEST_F(SimulationCheck, IsTheLastPartOfTheWholeCheckAndOfASoundStoreOnly) {
    const auto whole = [&](const database::StoreProgress& progress) {
        SimulationSample sample;
        sample.seed = 5;
        return check_store_and_sample(station.store, station.session, sample, progress);
    };
    double reached = 0;
    const database::CheckReport sound = whole([&](double done, const std::string&) {
        EXPECT_GE(done, reached) << "progress never goes back";
        EXPECT_LE(done, 1);
        reached = done;
        return true;
    });
    EXPECT_TRUE(sound.ok && sound.complete);
    EXPECT_EQ(sound.items.back().id, database::CheckId::simulation);
    EXPECT_EQ(sound.items.back().count, 2);
    EXPECT_GT(reached, 0.5);
    // Stopped in each half: no longer complete, and nothing is said to be wrong.
    for (const double at : {0.2, 0.5}) {
        const database::CheckReport cut = whole([&](double done, const std::string&) { return done < at; });
        EXPECT_FALSE(cut.complete) << at;
        EXPECT_TRUE(cut.ok) << at;
    }
    take_forces_away(station, ids[0]);  // not signed again
    const database::CheckReport damaged = whole({});
    EXPECT_FALSE(damaged.ok);
    EXPECT_NE(damaged.items.back().id, database::CheckId::simulation);
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
