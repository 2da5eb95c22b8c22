// SPDX-License-Identifier: GPL-3.0-or-later
// Recording across threads, and what is left when the program is killed. FULCRUM_KILLS sets the number of
// kills.
#include <fcntl.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <thread>

#include "sim_core/lab/result_page.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

TEST(Recorder, AnotherThreadFeedsIt) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    std::thread feeder([&] {
        for (std::uint32_t second = 0; second < 4; ++second)
            Programme::append_second(recorder, second * 1000);
        recorder.append(Event{4000, EventKind::completed});
        recorder.finish(example_result(true, 42));
    });
    feeder.join();
    EXPECT_EQ(recorder.records_waiting(), 0U);
    const Trace trace = programme.attempts().read_trace(programme.session("ann"), recorder.attempt_id());
    const Trace packed =
        programme.attempts().read_packed_trace(programme.session("ann"), recorder.attempt_id());
    ASSERT_NE(packed.ticks, nullptr);
    EXPECT_TRUE(packed.samples.empty() && packed.inputs.empty());
    ASSERT_EQ(packed.tick_count(), trace.samples.size());
    const auto reader = packed.ticks->reader();
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
        ASSERT_EQ(std::memcmp(&reader->sample(i), &trace.samples[i], sizeof(TickSample)), 0) << i;
        ASSERT_EQ(std::memcmp(&reader->input(i), &trace.inputs[i], sizeof(RigSample)), 0) << i;
    }
    EXPECT_EQ(packed.steps.size(), trace.steps.size());
    EXPECT_EQ(packed.events.size(), trace.events.size());
    ASSERT_EQ(trace.samples.size(), 4000U);
    ASSERT_EQ(trace.inputs.size(), 4000U);
    EXPECT_EQ(trace.steps.size(), 800U);
    EXPECT_EQ(trace.events.size(), 17U);
    for (std::uint32_t tick = 0; tick < 4000; ++tick) {
        ASSERT_EQ(trace.samples[tick].tick, tick);
        ASSERT_EQ(trace.inputs[tick].hand[0].handle[0], static_cast<std::int32_t>(tick * 3));
    }
    EXPECT_EQ(trace.events.back().kind, EventKind::completed);
}

TEST(Recorder, StoresEventsAsTheyAreFoundAndTheCheckOfTheStoreAccepts) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    Programme::append_second(recorder);
    recorder.append(Event{970, EventKind::wall_contact, 1});
    recorder.append(Event{943, EventKind::first_movement, 1});
    recorder.flush();
    Programme::append_second(recorder, 1000);
    recorder.append(Event{940, EventKind::first_movement, 0});
    recorder.finish(example_result(true, 42));
    const Trace trace = programme.attempts().read_trace(programme.session("ann"), recorder.attempt_id());
    EXPECT_EQ(trace.events.back().tick, 940U);
    const CheckReport report = programme.store->check(programme.store->station_session());
    for (const CheckItem& item : report.items)
        for (const Sentence& problem : item.problems) ADD_FAILURE() << item.name << ": " << problem.words();
}

TEST(Recorder, AnAttemptInProgressIsNotTakenForInterrupted) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    programme.open();
    EXPECT_TRUE(programme.store->interrupted_at_open().empty());
    EXPECT_EQ(programme.attempts().read(programme.session("ann"), recorder.attempt_id()).state,
              AttemptState::running);
    recorder.finish(example_result(true, 42));
    EXPECT_FALSE(std::filesystem::exists(programme.path + ".recording-" + recorder.attempt_id()));
}

TEST(Recorder, NobodyClosesARunningAttemptThroughAnotherNameOfTheStore) {
    namespace files = std::filesystem;
    Programme programme;
    const QTemporaryDir elsewhere;
    const std::string link = elsewhere.filePath("link.db").toStdString();
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    files::create_symlink(programme.path, link);
    EXPECT_TRUE(Store::open(link, programme.clock.options()).interrupted_at_open().empty());
    programme.store.reset();
    files::remove(link);
    // A second name of the same file in another folder, without the lock's file next to it.
    files::create_hard_link(programme.path, link);
    EXPECT_TRUE(Store::open(link, programme.clock.options()).interrupted_at_open().empty());
    // A lock that cannot be asked counts as held.
    const std::string lock = programme.path + ".recording-" + recorder.attempt_id();
    ASSERT_TRUE(files::exists(lock));
    files::rename(lock, lock + "-away");
    files::create_directory(lock);
    programme.open();
    EXPECT_TRUE(programme.store->interrupted_at_open().empty());
    files::remove(lock);
    std::ofstream(lock) << "another file of that name";
    programme.open();
    EXPECT_TRUE(programme.store->interrupted_at_open().empty());
    // After a restart of the machine nobody holds it any more.
    programme.clock.restart();
    programme.open();
    EXPECT_EQ(programme.store->interrupted_at_open().size(), 1U);
    // What the recorder still has is not added to an attempt that has ended.
    EXPECT_EQ(error_kind([&] { Programme::append_second(recorder); }), StoreErrorKind::conflict);
    EXPECT_TRUE(programme.store->check(programme.session("station")).ok);
}

TEST(Recorder, OneThatNeverFinishedIsListedWithWhatItHolds) {
    Programme programme;
    const std::string attempt = programme.record_broken("ann");
    programme.open();
    ASSERT_EQ(programme.store->interrupted_at_open().size(), 1U);
    const InterruptedAttempt& found = programme.store->interrupted_at_open()[0];
    EXPECT_EQ(found.attempt_id, attempt);
    EXPECT_EQ(found.task_id, "A2");
    EXPECT_DOUBLE_EQ(found.recorded_s, 1.0);
    const AttemptSummary read = programme.attempts().read(programme.session("ann"), attempt);
    EXPECT_EQ(read.state, AttemptState::interrupted);
    EXPECT_EQ(read.events, 4U);
    EXPECT_FALSE(read.counting);
    programme.open();
    EXPECT_TRUE(programme.store->interrupted_at_open().empty());
    // What was recorded failed already: the trainee's own session scores it, and then it counts.
    ASSERT_EQ(programme.attempts().interrupted_without_score(programme.session("ann")).size(), 1U);
    EXPECT_TRUE(programme.attempts().interrupted_without_score(programme.session("ben")).empty());
    programme.attempts().add_score(programme.session("ann"), attempt, example_score(false, 0));
    EXPECT_TRUE(programme.attempts().interrupted_without_score(programme.session("ann")).empty());
    EXPECT_TRUE(programme.attempts().read(programme.session("ann"), attempt).counting);
    EXPECT_THROW(programme.attempts().add_score(programme.session("ann"), attempt, example_score(true, 100)),
                 AccessDenied);
}

TEST(Recorder, ALockedStoreSaysSoAndLosesNothing) {
    Programme programme;
    Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                      programme.clock.options());
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open(programme.path.c_str(), &other), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
    Programme::append_second(recorder);
    Programme::append_second(recorder, 1000);
    EXPECT_EQ(recorder.bytes_written(), 0U);
    EXPECT_EQ(error_kind([&] { recorder.flush(); }), StoreErrorKind::locked);
    EXPECT_EQ(error_kind([&] { recorder.finish(example_result(true, 1)); }), StoreErrorKind::locked);
    EXPECT_FALSE(recorder.finished());
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    recorder.finish(example_result(true, 1));
    const Trace trace = programme.attempts().read_trace(programme.session("ann"), recorder.attempt_id());
    EXPECT_EQ(trace.samples.size(), 2000U);
    EXPECT_EQ(trace.inputs.size(), 2000U);
    EXPECT_EQ(trace.samples.back().tick, 1999U);
}

/// What the child reports: shared memory survives a kill.
struct Progress {
    std::atomic<std::uint64_t> appended;    ///< samples of the attempt that runs
    std::atomic<std::uint64_t> flushed_at;  ///< samples when the last append() came back
    std::atomic<int> started, acknowledged;
    char current[64];
};

struct CrashToll {
    int kills = 0, interrupted = 0, with_trace = 0;
    int acknowledged = 0, scores = 0;  ///< that the child had reported; that are in the store
    std::uint64_t most_lost = 0;       ///< samples of a running attempt
};

class Crash : public ::testing::Test {
  protected:
    Crash() {
        programme.store.reset();
        progress = static_cast<Progress*>(
            ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
        EXPECT_NE(progress, MAP_FAILED);
    }
    ~Crash() override { ::munmap(progress, sizeof(Progress)); }
    /// The child: one attempt of 20 seconds after the other, as fast as they are written.
    void write_until_killed() const {
        for (;;) {
            progress->appended = 0;
            progress->flushed_at = 0;
            Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                              programme.clock.options());
            std::strncpy(progress->current, recorder.attempt_id().c_str(), sizeof progress->current - 1);
            ++progress->started;
            for (std::uint32_t tick = 0; tick < 20'000; ++tick) {
                RigSample input;
                input.tick = tick;
                recorder.append(input);
                TickSample sample;
                sample.tick = tick;
                sample.hand[0].tip[0] = static_cast<std::int32_t>(tick * 7);
                progress->appended = tick + 1;
                recorder.append(sample);
                progress->flushed_at = tick + 1;
            }
            recorder.finish(example_result(true, 50));
            ++progress->acknowledged;
        }
    }
    void kill_once() {
        progress->appended = 0;
        progress->flushed_at = 0;
        progress->started = 0;
        progress->acknowledged = 0;
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            try {
                write_until_killed();
            } catch (...) {
            }
            ::_exit(3);
        }
        while (progress->started == 0) std::this_thread::yield();
        const timespec pause{0, static_cast<long>(random() % 250000000ULL)};
        ::nanosleep(&pause, nullptr);
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";
        ++toll.kills;
    }
    /// What the next start finds.
    void look() {
        programme.open();
        const Attempts attempts = programme.attempts();
        AttemptFilter completed;
        completed.state = AttemptState::completed;
        completed.limit = -1;
        const auto finished = attempts.list(programme.session("ann"), completed);
        // One more may have been committed before it could say so.
        const int expected = toll.scores + progress->acknowledged;
        toll.acknowledged += progress->acknowledged;
        ASSERT_GE(static_cast<int>(finished.size()), expected);
        ASSERT_LE(static_cast<int>(finished.size()), expected + 1);
        toll.scores = static_cast<int>(finished.size());
        for (const AttemptSummary& attempt : finished) ASSERT_EQ(attempt.points, 50);

        ASSERT_LE(programme.store->interrupted_at_open().size(), 1U);
        for (const InterruptedAttempt& attempt : programme.store->interrupted_at_open()) {
            ++toll.interrupted;
            const Trace trace = attempts.read_trace(programme.session("ann"), attempt.attempt_id);
            EXPECT_EQ(trace.samples.size(), trace.inputs.size());
            if (attempt.attempt_id == progress->current) {
                const std::uint64_t lost =
                    progress->flushed_at -
                    std::min<std::uint64_t>(progress->flushed_at, trace.samples.size());
                EXPECT_LE(lost, 1000U);
                toll.most_lost = std::max(toll.most_lost, lost);
            }
            for (std::size_t i = 0; i < trace.samples.size(); ++i) ASSERT_EQ(trace.samples[i].tick, i);
            if (!trace.samples.empty()) ++toll.with_trace;
        }
        programme.store.reset();
    }

    Programme programme;
    Progress* progress = nullptr;
    std::mt19937_64 random{20261121};
    CrashToll toll;
};

void write_crash_page(const std::string& folder, const CrashToll& toll) {
    lab::ResultTable table;
    table.name = "kills_writing";
    table.columns = {"what", "value"};
    table.rows = {{"kills", std::to_string(toll.kills)},
                  {"attempts that ran when the program was killed", std::to_string(toll.interrupted)},
                  {"of these with a part of their trace", std::to_string(toll.with_trace)},
                  {"samples of a trace lost: worst", std::to_string(toll.most_lost)},
                  {"scores that were acknowledged", std::to_string(toll.acknowledged)},
                  {"of these not in the store", "0"},
                  {"time", fulcrum::test::time_of_test()}};
    lab::ResultPage page("kills_writing",
                         "Killed " + std::to_string(toll.kills) + " times while an attempt is written",
                         "FULCRUM_KILLS=" + std::to_string(toll.kills) + " FULCRUM_KILLS_PAGE=" + folder +
                             " test_database --gtest_filter=Crash.*");
    page.paragraph(
        "A program writes attempts of 20 s with the recorder, one after the other and as fast as it can, and "
        "a "
        "`kill -9` ends it up to 250 ms after it has begun one. A score is *acknowledged* when the call that "
        "stores it has returned. The next start lists what ran as interrupted; its trace has to be whole up "
        "to the last second. At the end the whole store is checked. This page is written only where every "
        "check passed.");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

// A recorder that writes in a child process, killed at a random moment: no acknowledged score is lost, at
// most a second of trace, and what ran is listed as interrupted.
TEST_F(Crash, KilledAtAnyMomentLosesAtMostASecondAndNoScore) {
    const int rounds = std::max(1, kills_asked(20));
    for (int round = 0; round < rounds && !HasFatalFailure(); ++round) {
        kill_once();
        if (!HasFatalFailure()) look();
    }
    programme.open();
    const CheckReport report = programme.store->check(programme.session("station"));
    for (const CheckItem& item : report.items)
        EXPECT_TRUE(item.ok) << item.name << ": " << (item.ok ? "" : item.problems.front().words());
    EXPECT_GT(toll.interrupted, rounds / 2);
    std::printf("%d kills while writing: %d attempts interrupted, %d scores acknowledged\n", toll.kills,
                toll.interrupted, toll.acknowledged);
    if (const char* page = fulcrum::test::kill_pages()) write_crash_page(page, toll);
    fulcrum::test::enter_kills(
        {fulcrum::test::Killed::writing, static_cast<std::size_t>(toll.kills),
         "scores that were acknowledged", static_cast<std::size_t>(toll.acknowledged), 0},
        lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::database::test
