// SPDX-License-Identifier: GPL-3.0-or-later
// Kills the program at random times during an attempt in real time: once without a window, once the whole
// window, used by mouse and key events. FULCRUM_KILLS sets the number of kills (200 for the long run);
// FULCRUM_KILLS_PAGE is the folder for its page.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <set>
#include <thread>

#include "app/live/interrupted.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "sim_core/lab/result_page.h"
#include "tests/app/counters.h"
#include "tests/app/program_path.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::app::program_test {

Counters* map_counters(const char* path) {
    const int file = ::open(path, O_RDWR | O_CREAT, 0600);
    if (file < 0 || ::ftruncate(file, sizeof(Counters)) != 0) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(Counters), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    return memory == MAP_FAILED ? nullptr : static_cast<Counters*>(memory);
}

namespace {

int kills(int usually) {
    const char* asked = std::getenv("FULCRUM_KILLS");
    return asked != nullptr ? std::atoi(asked) : usually;
}

/// Results of all kills of a run.
struct Toll {
    int kills = 0;
    std::size_t begun = 0,
                missing = 0;  ///< attempts whose first tick was read; of these, missing in the store
    std::size_t scored = 0;   ///< found with a score stored before the kill
    std::size_t interrupted = 0, scored_after = 0, finished = 0, finished_lost = 0;
    std::vector<std::uint32_t> lost_ticks;  ///< of each interrupted attempt
    std::vector<double> recorded_s;         ///< of each interrupted attempt
    std::uint32_t worst() const {
        return lost_ticks.empty() ? 0 : *std::max_element(lost_ticks.begin(), lost_ticks.end());
    }
};

class Kills : public ::testing::Test {
  protected:
    Kills() : counters(map_counters(counters_path.c_str())) { database::Store::create(store_path, false); }
    /// Long enough for a second attempt to run while the first is stored.
    static constexpr unsigned longest_wait_ms = 3000;
    /// Of a programme with an administrator and this trainee, as the child signs in.
    database::Session create_trainee() const;
    /// Opens the store from other programs while the child runs: the command line and SQLite in turn.
    void open_from_outside(int times);
    /// Starts `child`, kills it at a random time after its first tick, and looks at what the next start
    /// finds.
    void round(const char* child, int number, const database::Session& performer);

    QTemporaryDir folder;
    const std::string folder_path = folder.path().toStdString(), store_path = folder_path + "/fulcrum.db",
                      counters_path = folder_path + "/counters";
    Counters* counters;
    std::mt19937_64 random{20261121};
    std::set<std::string> earlier;  ///< attempts of the previous rounds
    int foreign_opens = 0;          ///< in each round, before the kill
    Toll toll;
};

database::Session Kills::create_trainee() const {
    const database::Store store = database::Store::open(store_path);
    const database::People people(store);
    const auto programme = people.create_programme("Department", "alma", "Alma Admin", "correct horse");
    const auto created =
        people.create(programme.administrator, trainee_login, "Tara Trainee", {database::Role::trainee});
    return people.change_password(people.sign_in(trainee_login, created.one_time_password),
                                  created.one_time_password, trainee_password);
}

void Kills::open_from_outside(int times) {
    for (int k = 0; k < times; ++k) {
        if (k % 2 == 1) {
            sqlite3* store = nullptr;
            EXPECT_EQ(sqlite3_open_v2(store_path.c_str(), &store, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
            EXPECT_EQ(sqlite3_exec(store, "select count(*) from attempt", nullptr, nullptr, nullptr),
                      SQLITE_OK)
                << sqlite3_errmsg(store);
            EXPECT_EQ(sqlite3_close(store), SQLITE_OK);
            continue;
        }
        const pid_t program = ::fork();
        ASSERT_GE(program, 0);
        if (program == 0) {
            ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
            ::execl(program_path(), "fulcrum", "tissues", "B2", "--db", store_path.c_str(),
                    static_cast<char*>(nullptr));
            ::_exit(127);
        }
        int status = 0;
        ASSERT_EQ(::waitpid(program, &status, 0), program);
        EXPECT_EQ(status, 0) << "fulcrum tissues";
    }
}

void Kills::round(const char* child_option, int number, const database::Session& performer) {
    counters->ticks.store(0);
    const std::uint32_t finished_before = counters->finished.load(), begun_before = counters->begun.load();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        ::execl("/proc/self/exe", "test_app_kills", child_option, folder_path.c_str(), counters_path.c_str(),
                std::to_string(number).c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    int status = 0;
    while (counters->begun.load() == begun_before) {  // at a random time after the first tick
        ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << "the child ended by itself: " << status;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    open_from_outside(foreign_opens);
    ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << "the child ended by itself: " << status;
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % longest_wait_ms));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself: " << status;
    const std::size_t finished = counters->finished.load() - finished_before;

    // The next start lists a running attempt as interrupted and scores it from its record.
    const database::Store store = database::Store::open(store_path);
    const database::Attempts attempts(store);
    const std::size_t open = attempts.interrupted_without_score(performer).size();
    EXPECT_EQ(store.interrupted_at_open().size(), open);
    EXPECT_LE(open, 1U);
    std::size_t seen = 0, scored = 0;
    database::AttemptFilter all;
    all.limit = -1;
    for (const database::AttemptSummary& attempt : attempts.list(performer, all)) {
        if (!earlier.insert(attempt.meta.id).second) continue;
        ++seen;
        EXPECT_NE(attempt.state, AttemptState::running);
        if (attempt.state != AttemptState::interrupted) {
            EXPECT_TRUE(attempts.score(performer, attempt.meta.id).has_value());
            ++scored;
            continue;
        }
        const database::Trace trace = attempts.read_trace(performer, attempt.meta.id);
        for (std::size_t k = 0; k < trace.samples.size(); ++k) ASSERT_EQ(trace.samples[k].tick, k + 1);
        toll.lost_ticks.push_back(counters->ticks.load() - static_cast<std::uint32_t>(trace.samples.size()));
        toll.recorded_s.push_back(attempt.duration_s);
    }
    EXPECT_GE(scored, finished) << "an acknowledged score is lost";
    EXPECT_GE(seen, std::size_t{counters->begun.load() - begun_before});
    const std::size_t now_scored = score_interrupted(store_path, performer).size();
    EXPECT_EQ(now_scored, open);
    EXPECT_TRUE(attempts.interrupted_without_score(performer).empty());
    ++toll.kills;
    const std::size_t begun = counters->begun.load() - begun_before;
    toll.begun += begun;
    toll.missing += begun > seen ? begun - seen : 0;
    toll.scored += scored;
    toll.interrupted += open;
    toll.scored_after += now_scored;
    toll.finished += finished;
    toll.finished_lost += finished > scored ? finished - scored : 0;
}

/// One second if the recorder's thread gets the processor; a machine that starves it for seconds loses
/// those.
void expect_a_second_at_most(const Toll& toll) {
    EXPECT_LE(toll.worst(), toll.kills >= 200 ? 1000U : 5000U);
}

/// In the page that adds up the kills of all tests.
void enter_in_page(const Toll& toll) {
    fulcrum::test::KillRow row;
    row.activity = fulcrum::test::Killed::performing;
    row.kills = static_cast<std::size_t>(toll.kills);
    row.checked = "attempts that had begun, and scores that were acknowledged";
    row.found = toll.begun + toll.finished;
    row.missing = toll.missing + toll.finished_lost;
    fulcrum::test::enter_kills(row, lab::this_machine(lab::build_info()));
}

TEST_F(Kills, NoFinishedScoreIsLostAndEveryAttemptIsFoundAndScored) {
    ASSERT_NE(counters, nullptr);
    const database::Session station = database::Store::open(store_path).station_session();
    const int rounds = kills(4);
    for (int i = 0; i < rounds && !HasFatalFailure(); ++i) round("--perform-until-killed", i, station);
    EXPECT_TRUE(database::Store::open(store_path).check(station).ok);
    std::printf("%d kills: %zu attempts interrupted and scored, %zu finished, at most %u ticks lost\n",
                toll.kills, toll.interrupted, toll.finished, toll.worst());
    enter_in_page(toll);
    expect_a_second_at_most(toll);
}

void write_page(const char* page_folder, const Toll& toll) {
    const auto figure = [](double value, const char* format = "%.0f") {
        char text[32];
        std::snprintf(text, sizeof text, format, value);
        return std::string(text);
    };
    std::vector<std::uint32_t> lost = toll.lost_ticks;
    std::vector<double> recorded = toll.recorded_s;
    std::sort(lost.begin(), lost.end());
    std::sort(recorded.begin(), recorded.end());
    lab::ResultTable table;
    table.name = "kills";
    table.columns = {"what", "value"};
    table.rows = {
        {"kills", figure(toll.kills)},
        {"attempts begun", figure(static_cast<double>(toll.begun))},
        {"of these missing at the next start", figure(static_cast<double>(toll.missing))},
        {"found with their score", figure(static_cast<double>(toll.scored))},
        {"found listed as interrupted", figure(static_cast<double>(toll.interrupted))},
        {"of these scored from their record at the next start",
         figure(static_cast<double>(toll.scored_after))},
        {"attempts whose debrief was shown before the kill", figure(static_cast<double>(toll.finished))},
        {"of these scores lost", figure(static_cast<double>(toll.finished_lost))},
        {"ticks of trace lost: median", lost.empty() ? "–" : figure(lost[lost.size() / 2])},
        {"ticks of trace lost: worst", figure(toll.worst())},
        {"recorded part of these, s: shortest", recorded.empty() ? "–" : figure(recorded.front(), "%.2f")},
        {"recorded part of these, s: longest", recorded.empty() ? "–" : figure(recorded.back(), "%.2f")},
    };
    lab::ResultPage page("kills", "Killed " + std::to_string(toll.kills) + " times during an attempt",
                         "FULCRUM_KILLS=" + std::to_string(toll.kills) + " FULCRUM_KILLS_PAGE=" +
                             page_folder + " test_app --gtest_filter=*TheWholeWindow*");
    page.paragraph(
        "The window of the program runs under Xvfb with its haptic, world and recorder threads and its "
        "store. Mouse and key events act as a trainee: sign in, perform A2 as an assessed attempt, abandon "
        "it, read the debrief, start again. A `kill -9` ends the program at a random time, up to 3 s after "
        "the first tick. A finished attempt is one whose debrief was shown. At the end the whole store is "
        "checked: pages, references, audit chain, checksums and score digests.");
    page.table(table);
    page.write(page_folder, lab::this_machine(lab::build_info()));
}

// The window is signed in and an attempt is on the clock while other programs open and close the store.
TEST_F(Kills, OfTheWholeWindowAfterFiftyForeignOpensLoseNoScore) {
    ASSERT_NE(counters, nullptr);
    const database::Session trainee = create_trainee();
    foreign_opens = 50;
    round("--use-window-until-killed", 0, trainee);
    const database::Store store = database::Store::open(store_path);
    EXPECT_TRUE(store.check(store.station_session()).ok);
    EXPECT_EQ(toll.missing, 0U);
    EXPECT_EQ(toll.finished_lost, 0U);
    expect_a_second_at_most(toll);
}

TEST_F(Kills, OfTheWholeWindowLoseNoScoreAndListEveryAttempt) {
    ASSERT_NE(counters, nullptr);
    const database::Session trainee = create_trainee();
    const int rounds = kills(1);  // KillsWithForce kills windows too
    for (int i = 0; i < rounds && !HasFatalFailure(); ++i) round("--use-window-until-killed", i, trainee);
    const database::Store store = database::Store::open(store_path);
    const bool sound = store.check(store.station_session()).ok;
    EXPECT_TRUE(sound);
    std::printf(
        "%d kills of the window: %zu attempts interrupted and scored, %zu finished, at most %u ticks lost\n",
        toll.kills, toll.interrupted, toll.finished, toll.worst());
    if (const char* page = fulcrum::test::kill_pages(); page != nullptr && sound) write_page(page, toll);
    enter_in_page(toll);
    expect_a_second_at_most(toll);
}

}  // namespace
}  // namespace fulcrum::app::program_test
