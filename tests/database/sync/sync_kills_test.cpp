// SPDX-License-Identifier: GPL-3.0-or-later
// A station is killed at random moments while it exchanges with a programme server, both ways: what was
// reported as transferred is on the other side, db check passes after every kill, and the end state is that
// of an exchange that nobody interrupted. FULCRUM_KILLS sets the number of kills (600 for the long run);
// FULCRUM_KILLS_PAGE is the folder for its page.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <thread>

#include "database/sync/units.h"
#include "sim_core/lab/result_page.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/processes.h"
#include "tests/database/sync/stations.h"
#include "tests/support/kill_pages.h"

namespace fulcrum::database::test {
namespace {

struct SyncToll {
    int kills = 0, in_the_middle = 0, exchanges = 0, rounds = 0;
    std::size_t sent = 0, received = 0, lost = 0;
};

/// Keys that one side has and the other lacks, as the exchange walks them; by title.
using Lacking = std::map<std::string, std::vector<std::string>>;

class SyncKills : public Sync {
  protected:
    static Lacking lacking(Connection& from, Connection& to, Connection& layout) {
        Lacking result;
        for (const SyncTable& table : sync_tables()) {
            if (table.rule != SyncRule::added) continue;
            const Units units(table, layout);
            const std::set<std::string> here = units.keys(from, true), there = units.keys(to, false);
            std::set_difference(here.begin(), here.end(), there.begin(), there.end(),
                                std::back_inserter(result[table.title]));
        }
        return result;
    }
    /// Of the units that were reported as transferred, those that are not on the other side; adds to `moved`
    /// how many were reported.
    static std::size_t lost_of(const Lacking& before, const Lacking& after, const std::vector<Deed>& deeds,
                               DeedKind kind, std::size_t& moved) {
        std::map<std::string, std::uint32_t> reported;
        for (const Deed& deed : deeds)
            if (deed.kind == kind) reported[deed.object] = std::max(reported[deed.object], deed.number);
        std::size_t lost = 0;
        for (const auto& [title, keys] : before) {
            const std::size_t first = std::min<std::size_t>(reported[title], keys.size());
            const std::vector<std::string>& still = after.at(title);
            moved += first;
            for (std::size_t i = 0; i < first; ++i) {
                if (!std::binary_search(still.begin(), still.end(), keys[i])) continue;
                ++lost;
                ADD_FAILURE() << title << ' ' << keys[i] << " was reported, and is not there";
            }
        }
        return lost;
    }
    struct Between {
        Lacking up, down;
    };
    Between between(const Programme& station) const {
        const Store store = Store::open(station.path, station.clock.options());
        Connection there(server);
        return {lacking(store.connection(), there, store.connection()),
                lacking(there, store.connection(), store.connection())};
    }
    /// Deeds of both stations, so that each has what the other lacks.
    void fill_both(const Programme& one, Station& other, int attempts) const {
        fill(one);
        for (int i = 0; i < attempts; ++i) {
            one.record(i % 2 == 0 ? "ann" : "ben", i % 3 != 0, 50 + i % 40);
            const std::string there = other.record(i % 2 == 0 ? "ben" : "ann", 40 + i % 40);
            Reviews(*other.store).write(other.sign_in("educator"), there, 0.1, "Seen.", true);
        }
    }
    /// One child exchanges and is killed; false where a whole exchange was over before.
    bool kill_once(const Programme& station, const std::string& folder) {
        DeedsJournal& journal = DeedsJournal::in(folder);
        journal.clear();
        const Between before = between(station);
        const pid_t child = start_child("exchange", folder);
        // After so many lines of its progress, which do not depend on how busy the machine is.
        if (!wait_for_deeds(journal, child, static_cast<std::uint32_t>(random() % 12))) {
            ADD_FAILURE() << "the child ended by itself";
            return false;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 10'000));
        EXPECT_TRUE(kill_child(child)) << "the child ended by itself";
        ++toll.kills;
        int whole = 0;
        const std::vector<Deed> deeds = journal.deeds();
        for (const Deed& deed : deeds) whole += deed.kind == DeedKind::exchanged ? 1 : 0;
        toll.exchanges += whole;
        toll.in_the_middle += whole == 0 ? 1 : 0;
        const Between after = between(station);
        toll.lost += lost_of(before.up, after.up, deeds, DeedKind::sent, toll.sent);
        toll.lost += lost_of(before.down, after.down, deeds, DeedKind::received, toll.received);
        expect_sound(Store::open(station.path, station.clock.options()));
        return whole == 0;
    }
    /// Until one exchange was whole, or so many kills were made. The same stores, copied before, exchange
    /// without interruption with a server of their own.
    void exchange_and_kill(int kills) {
        const TemporaryFoldersInMemory in_memory;
        Programme one;
        Station other;
        server = PostgresqlServer::of_this_process()->new_database();
        sync(one);
        sync(other);
        const ServerAddress interrupted = server;
        const ServerAddress control = PostgresqlServer::of_this_process()->new_database();
        server = control;
        sync(one);  // the same beginning there
        server = interrupted;
        fill_both(one, other, kills > 10 ? 12 : 4);
        sync(other);
        const std::string folder = one.folder.path().toStdString(), copy = folder + "/copy.db",
                          copy_of_other = folder + "/other.db";
        one.store.reset();
        other.store.reset();
        std::filesystem::copy_file(one.path, copy);
        std::filesystem::copy_file(other.path, copy_of_other);
        std::ofstream(folder + "/server") << server.text() << '\n';
        for (int kill = 0; kill < kills && !HasFailure(); ++kill)
            if (!kill_once(one, folder)) break;
        one.open();
        other.store = std::make_unique<Store>(Store::open(other.path, other.clock.options()));
        sync(one);
        sync(other);
        // Without interruption.
        const Store whole = Store::open(copy, one.clock.options()),
                    whole_other = Store::open(copy_of_other, other.clock.options());
        const Session there = People(whole_other).sign_in("administrator", password);
        sync_with_server(whole_other, there, control);
        sync_with_server(whole, one.session("administrator"), control);
        sync_with_server(whole_other, there, control);
        EXPECT_EQ(rows_on(interrupted), rows_on(control));
        EXPECT_EQ(rows_at(*one.store, true), rows_at(whole, true));
        EXPECT_EQ(rows_at(*other.store), rows_at(whole_other));
        expect_sound(*one.store);
        expect_sound(*other.store);
        expect_sound(interrupted);
        ++toll.rounds;
    }
    std::mt19937_64 random{20261127};
    SyncToll toll;
};

void write_sync_page(const std::string& folder, const SyncToll& toll) {
    lab::ResultTable table;
    table.name = "kills_syncing";
    table.columns = {"what", "value"};
    table.rows = {
        {"kills", std::to_string(toll.kills)},
        {"of these before the exchange was whole", std::to_string(toll.in_the_middle)},
        {"units that were reported as sent", std::to_string(toll.sent)},
        {"units that were reported as received", std::to_string(toll.received)},
        {"of these not on the other side afterwards", std::to_string(toll.lost)},
        {"pairs of stations that were compared with an exchange without kills", std::to_string(toll.rounds)},
    };
    lab::ResultPage page("kills_syncing",
                         "Killed " + std::to_string(toll.kills) + " times while a station exchanges",
                         "FULCRUM_KILLS=" + std::to_string(toll.kills) + " FULCRUM_KILLS_PAGE=" + folder +
                             " test_database --gtest_filter=SyncKills.*");
    page.paragraph(
        "Two stations of a programme: the first has 15 attempts with traces and scores, a comment, an "
        "observer "
        "form, a void and a personal goal that the other lacks, the second 12 attempts with a comment each. "
        "The "
        "second one has sent its own to a PostgreSQL that the test starts. The first one exchanges both "
        "ways, and a `kill -9` ends it up to "
        "10 ms after a random one of its first 12 lines of progress; the next one starts on the same store, "
        "until an exchange was whole. A "
        "unit counts as *reported* when the line of progress that counts it was made. After every kill these "
        "are looked for on the other side, and the whole store of the station is checked. At the end both "
        "stations exchange once more, copies of their stores from before the kills exchange with another "
        "server without interruption, and all rows of both stations (with traces) and both servers are "
        "compared; `server check` passes. This page is written only where every check passed and every end "
        "state was the same.");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

TEST_F(SyncKills, LoseNothingAndEndAsAnUninterruptedExchange) {
    const int asked = kills_asked(2);
    while (toll.kills < asked && !HasFailure()) exchange_and_kill(asked - toll.kills);
    EXPECT_GT(toll.in_the_middle, 0);
    std::printf(
        "%d kills while exchanging, %d before the end: %zu units sent and %zu received were reported, "
        "%zu lost; %d end states compared\n",
        toll.kills, toll.in_the_middle, toll.sent, toll.received, toll.lost, toll.rounds);
    if (const char* page = fulcrum::test::kill_pages()) write_sync_page(page, toll);
    fulcrum::test::enter_kills(
        {fulcrum::test::Killed::exchanging, static_cast<std::size_t>(toll.kills),
         "units that were reported as sent or received", toll.sent + toll.received, toll.lost},
        lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::database::test
