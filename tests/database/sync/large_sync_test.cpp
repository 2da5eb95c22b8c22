// SPDX-License-Identifier: GPL-3.0-or-later
// Many attempts: FULCRUM_SYNC_ATTEMPTS at a station (default 40; 5,000 is the measured size), and how long it
// takes; the same with stations that are killed FULCRUM_SYNC_CUTS times (default 4) while they exchange.
// FULCRUM_SYNC_PAGE is the folder for the page of the latter.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <thread>

#include "database/sync/enrolment.h"
#include "database/sync/server_enrolment.h"
#include "sim_core/lab/result_page.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/processes.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

int number_asked(const char* variable, int usually) {
    return qEnvironmentVariableIsSet(variable) ? std::max(1, qEnvironmentVariableIntValue(variable))
                                               : usually;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class SyncLarge : public Sync {
  protected:
    template <typename Act>
    SyncResult timed(const char* what, Act&& act) const {
        const auto start = std::chrono::steady_clock::now();
        const SyncResult result = act();
        std::printf("%s: %lld units, %lld audit rows, %.2f s\n", what,
                    static_cast<long long>(result.transferred()), static_cast<long long>(result.audit_rows),
                    seconds_since(start));
        std::fflush(stdout);
        return result;
    }
    /// New attempts at both stations, of the same two people.
    void record_at_both(const Programme& one, const Station& other) const {
        for (int i = 0; i < attempts; ++i) one.record(i % 2 == 0 ? "ann" : "ben", i % 3 != 0, i % 100);
        const Session ann = other.sign_in("ann");
        for (int i = 0; i < attempts; ++i) {
            Recorder recorder(other.path, ann, example_meta(ann.person_id()), other.clock.options());
            Programme::append_second(recorder);
            recorder.finish(example_result(true, i % 100));
        }
    }
    const int attempts = number_asked("FULCRUM_SYNC_ATTEMPTS", 40);
};

TEST_F(SyncLarge, TwoStationsEndWithTheSame) {
    Station b;
    sync(a);
    sync(b);
    record_at_both(a, b);
    timed("a sends", [&] { return sync(a); });
    timed("b sends and receives", [&] { return sync(b); });
    timed("a receives", [&] { return sync(a); });
    EXPECT_EQ(timed("a again", [&] { return sync(a); }).transferred(), 0);
    EXPECT_EQ(rows_at(*a.store), rows_at(*b.store));
    EXPECT_EQ(rows_at(*a.store), rows_on(server, false));
    Query count(a.store->connection(), "SELECT COUNT(*) FROM attempt");
    EXPECT_TRUE(count.next() && count.integer(0) == 2 * attempts);
    expect_the_same_standings(b);
    // A station of one cohort, whose rows the server chooses.
    const KeysOfOneTest keys;
    const Station c;
    enrol_station(*c.store, c.store->station_session(), server,
                  make_enrolment_token(server, "", {"Year 1"}, 1).text);
    const auto receive = [&] {
        return sync_with_server(
            *c.store, c.store->has_administrator() ? c.sign_in("administrator") : c.store->station_session(),
            server_of(*c.store));
    };
    timed("c, of one cohort, receives", receive);
    EXPECT_EQ(timed("c again", receive).transferred(), 0);
    Query received(c.store->connection(), "SELECT COUNT(*) FROM attempt");
    EXPECT_TRUE(received.next() && received.integer(0) == 2 * attempts);
    expect_sound(*a.store);
    expect_sound(*b.store);
    expect_sound(server);
}

/// What an uninterrupted exchange of both stations took.
struct WholeExchange {
    SyncResult one, other, one_again;
    double one_s = 0, other_s = 0, one_again_s = 0;
    int lines_of_one = 0, lines_of_other = 0;  ///< of progress
    double all_s() const { return one_s + other_s + one_again_s; }
};

struct Cuts {
    int made = 0, in_the_middle = 0;
    double exchanging_s = 0;  ///< children until their kill, and the exchanges that completed the rest
    std::int64_t rest = 0;    ///< units of the latter
};

class SyncLargeCutOff : public SyncLarge {
  protected:
    SyncResult exchange(const Store& store, const Session& session, double& took, int& lines) const {
        SyncOptions options;
        options.progress = [&lines](double, const std::string&) { ++lines; };
        const auto start = std::chrono::steady_clock::now();
        const SyncResult result = sync_with_server(store, session, server, options);
        took = seconds_since(start);
        EXPECT_TRUE(result.complete);
        return result;
    }
    WholeExchange exchange_whole(const Store& one, const Session& there, const Store& other) const {
        WholeExchange whole;
        whole.one = exchange(one, there, whole.one_s, whole.lines_of_one);
        whole.other = exchange(other, People(other).sign_in("administrator", password), whole.other_s,
                               whole.lines_of_other);
        whole.one_again = exchange(one, there, whole.one_again_s, whole.lines_of_one);
        return whole;
    }
    /// A program exchanges for the station of this folder, and is killed after about so many lines of its
    /// progress. False where its exchange was whole before.
    bool cut_once(const std::string& folder, int lines) {
        DeedsJournal& journal = DeedsJournal::in(folder);
        journal.clear();
        const auto start = std::chrono::steady_clock::now();
        const pid_t child = start_child("exchange", folder);
        EXPECT_TRUE(wait_for_deeds(journal, child, static_cast<std::uint32_t>(lines)))
            << "the child ended by itself";
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 5'000));
        EXPECT_TRUE(kill_child(child)) << "the child ended by itself";
        cuts.exchanging_s += seconds_since(start);
        ++cuts.made;
        for (const Deed& deed : journal.deeds())
            if (deed.kind == DeedKind::exchanged) return false;
        ++cuts.in_the_middle;
        return true;
    }
    /// In turns; the kills of a station are spread over its exchange.
    void cut_off(const Programme& one, const Station& other, const WholeExchange& whole) {
        bool open[2] = {true, true};
        const int asked = number_asked("FULCRUM_SYNC_CUTS", 4), each = (asked + 1) / 2;
        for (int i = 0; cuts.in_the_middle < asked && (open[0] || open[1]) && !HasFailure(); ++i) {
            const bool first = i % 2 == 0;
            if (!open[first ? 0 : 1]) continue;
            const int lines = (first ? whole.lines_of_one : whole.lines_of_other) / (each + 1);
            open[first ? 0 : 1] =
                cut_once((first ? one.folder : other.folder).path().toStdString(),
                         static_cast<int>(random() % static_cast<unsigned>(std::max(1, 2 * lines))));
            const std::string& path = first ? one.path : other.path;
            expect_sound(Store::open(path, one.clock.options()));
            std::printf("cut %d, %s\n", cuts.made, open[first ? 0 : 1] ? "in the middle" : "afterwards");
            std::fflush(stdout);
        }
    }
    void write_page(const std::string& folder, const WholeExchange& whole) const {
        const auto number = [](auto value) { return std::to_string(value); };
        const auto tenths = [](double value) {
            char text[32];
            std::snprintf(text, sizeof text, "%.1f", value);
            return std::string(text);
        };
        lab::ResultTable table;
        table.name = "sync_cut_off";
        table.columns = {"what", "value"};
        table.rows = {
            {"attempts recorded at each of the two stations", number(attempts)},
            {"uninterrupted: the first station sends, s", tenths(whole.one_s)},
            {"units, audit rows", number(whole.one.transferred()) + ", " + number(whole.one.audit_rows)},
            {"uninterrupted: the second station sends and receives, s", tenths(whole.other_s)},
            {"units, audit rows", number(whole.other.transferred()) + ", " + number(whole.other.audit_rows)},
            {"uninterrupted: the first station receives, s", tenths(whole.one_again_s)},
            {"units", number(whole.one_again.transferred())},
            {"uninterrupted, together, s", tenths(whole.all_s())},
            {"programs killed while they exchanged", number(cuts.in_the_middle)},
            {"with these kills: exchanging, together, s", tenths(cuts.exchanging_s)},
            {"units that were left for the exchanges after the last kill", number(cuts.rest)},
        };
        lab::ResultPage page(
            "sync_cut_off", "Two stations exchange " + number(attempts) + " attempts each and are killed",
            "FULCRUM_SYNC_ATTEMPTS=" + number(attempts) + " FULCRUM_SYNC_CUTS=" + number(cuts.in_the_middle) +
                " FULCRUM_SYNC_PAGE=" + folder + " test_database --gtest_filter=SyncLargeCutOff.*");
        page.paragraph(
            "Two stations of a programme have as many new attempts each, of one second, with traces, scores "
            "and audit rows, and exchange with one PostgreSQL that the test starts on the same machine. "
            "In turns a program exchanges for each of them and a `kill -9` ends it after a random number of "
            "lines of its progress; the next one begins on the same store. After every kill the whole store "
            "of that station is checked (not part of the times). At the end both stations exchange until "
            "nothing is left. Copies of both stores from before the kills exchange with another server "
            "without interruption. All rows of the exchanged tables of both servers and of each station and "
            "its copy (with their own traces) are compared; the check of the stores and of the server "
            "passes. This page is written only where all of that held.");
        page.table(table);
        page.write(folder, lab::this_machine(lab::build_info()));
    }
    std::mt19937_64 random{20261127};
    Cuts cuts;
};

TEST_F(SyncLargeCutOff, EndsAsAnUninterruptedExchange) {
    const TemporaryFoldersInMemory in_memory;
    Programme one;
    Station other("fulcrum.db");
    const ServerAddress interrupted = server;
    sync(one);
    sync(other);
    const ServerAddress control = PostgresqlServer::of_this_process()->new_database();
    server = control;
    sync(one);  // the same beginning there
    record_at_both(one, other);
    one.store.reset();
    other.store.reset();
    const QTemporaryDir copies;
    const std::string copy = copies.filePath("one.db").toStdString(),
                      copy_of_other = copies.filePath("other.db").toStdString();
    std::filesystem::copy_file(one.path, copy);
    std::filesystem::copy_file(other.path, copy_of_other);
    const Store whole_one = Store::open(copy, one.clock.options()),
                whole_other = Store::open(copy_of_other, other.clock.options());
    const WholeExchange whole = exchange_whole(whole_one, one.session("administrator"), whole_other);

    server = interrupted;
    for (const QTemporaryDir* folder : {&one.folder, &other.folder})
        std::ofstream(folder->filePath("server").toStdString()) << server.text() << '\n';
    cut_off(one, other, whole);
    EXPECT_GT(cuts.in_the_middle, 0);
    one.open();
    other.store = std::make_unique<Store>(Store::open(other.path, other.clock.options()));
    const auto start = std::chrono::steady_clock::now();
    for (int round = 0; round < 2; ++round) {
        cuts.rest += sync(one).transferred();
        cuts.rest += sync(other).transferred();
    }
    cuts.exchanging_s += seconds_since(start);
    EXPECT_EQ(sync(one).transferred() + sync(other).transferred(), 0);

    // Compared one after the other: at the full size each takes a hundred megabytes.
    const auto same = [](std::vector<std::string> rows, std::vector<std::string> expected) {
        return rows == expected;
    };
    EXPECT_TRUE(same(rows_on(interrupted), rows_on(control)));
    EXPECT_TRUE(same(rows_at(*one.store, true), rows_at(whole_one, true)));
    EXPECT_TRUE(same(rows_at(*other.store, true), rows_at(whole_other, true)));
    Query count(one.store->connection(), "SELECT COUNT(*) FROM attempt");
    EXPECT_TRUE(count.next() && count.integer(0) == 2 * attempts);
    expect_sound(*one.store);
    expect_sound(*other.store);
    expect_sound(interrupted);
    std::printf(
        "%d kills, %d of them before the exchange was whole; uninterrupted %.1f s, with them %.1f s\n",
        cuts.made, cuts.in_the_middle, whole.all_s(), cuts.exchanging_s);
    const char* page = std::getenv("FULCRUM_SYNC_PAGE");
    if (page != nullptr && !HasFailure()) {
        ASSERT_EQ(cuts.in_the_middle, number_asked("FULCRUM_SYNC_CUTS", 4)) << "too few for the page";
        write_page(page, whole);
    }
}

}  // namespace
}  // namespace fulcrum::database::test
