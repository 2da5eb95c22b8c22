// SPDX-License-Identifier: GPL-3.0-or-later
// What limits many stations that exchange with one server at the same moment: processor, locks, round trips
// or bytes. FULCRUM_STATIONS_PAGE=FOLDER measures up to twenty stations and writes the page; in the suite two
// stations with two attempts each show that what it measures is what happens.
#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <thread>

#include "sim_core/lab/result_page.h"
#include "tests/database/sync/counting_proxy.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point start) {
    return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

/// Of this process, which runs all stations.
double own_processor_s() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Of one round: all stations at once.
struct Round {
    double wall_s = 0;          ///< of the slowest
    double stations_cpu_s = 0;  ///< of all
    double server_cpu_s = 0;
    std::int64_t units = 0, statements = 0, up = 0, down = 0;
    std::map<std::string, int> samples;  ///< of sessions at the server that had something to do
    double share(const std::string& what) const {
        int all = 0;
        for (const auto& [name, count] : samples) all += count;
        const auto found = samples.find(what);
        return all == 0 || found == samples.end() ? 0 : static_cast<double>(found->second) / all;
    }
};

class SyncMeasured : public Sync {
  protected:
    /// What the backends have used, once they have ended.
    double server_processor_s() const {
        Connection connection(server);
        Query row(connection, "SELECT split_part(pg_read_file('postmaster.pid'), chr(10), 1)");
        if (!row.next()) return 0;
        std::ifstream file("/proc/" + row.text(0) + "/stat");
        std::string word;
        double ticks = 0;
        constexpr int children_user = 16, children_system = 17;
        for (int field = 1; field <= children_system && file >> word; ++field)
            if (field >= children_user) ticks += std::stod(word);
        return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
    }
    /// Asks twenty times a second what each backend waits for.
    void watch_server(const std::atomic<bool>& ended, std::map<std::string, int>& samples) const {
        Connection connection(server);
        while (!ended) {
            Query rows(
                connection,
                "SELECT CASE WHEN state LIKE 'idle in transaction%' THEN 'station' WHEN wait_event_type "
                "IS NULL THEN 'processor' ELSE wait_event_type END, COUNT(*) FROM pg_stat_activity WHERE "
                "datname = current_database() AND pid <> pg_backend_pid() AND backend_type = 'client "
                "backend' AND state IN ('active', 'idle in transaction') GROUP BY 1");
            while (rows.next()) samples[rows.text(0)] += static_cast<int>(rows.integer(1));
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }
    Round exchange_at_once(std::chrono::microseconds one_way) {
        Round round;
        std::vector<std::string> trouble(stations.size());
        std::vector<double> seconds(stations.size(), 0);
        std::atomic<std::int64_t> statements{0}, units{0};
        std::atomic<bool> go{false}, ended{false};
        const double server_before = server_processor_s();
        CountingProxy proxy(server, one_way);
        std::thread watcher([&] { watch_server(ended, round.samples); });
        const auto exchange = [&](std::size_t i) {
            try {
                const Store store = Store::open(stations[i]->path, stations[i]->clock.options());
                SyncOptions options;
                options.stop = [&] {
                    ++statements;
                    return false;
                };
                while (!go) std::this_thread::yield();
                const auto start = SteadyClock::now();
                units += sync_with_server(store, administrators[i], proxy.address(), options).transferred();
                seconds[i] = seconds_since(start);
            } catch (const std::exception& error) {
                trouble[i] = error.what();
            }
        };
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < stations.size(); ++i) threads.emplace_back(exchange, i);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const double own_before = own_processor_s();
        go = true;
        for (std::thread& thread : threads) thread.join();
        round.stations_cpu_s = own_processor_s() - own_before;
        ended = true;
        watcher.join();
        for (const std::string& one : trouble) EXPECT_EQ(one, "");
        round.wall_s = *std::max_element(seconds.begin(), seconds.end());
        round.units = units;
        round.statements = statements;
        round.up = proxy.bytes_to_server();
        round.down = proxy.bytes_from_server();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        round.server_cpu_s = server_processor_s() - server_before;
        return round;
    }
    /// So many stations that know the programme, each with new attempts.
    void open(int count, int each) {
        stations.clear();
        administrators.clear();
        // Nothing of the case before: a station that had been there would bring it along.
        server = PostgresqlServer::of_this_process()->new_database();
        base.emplace();
        sync(*base);
        for (int i = 0; i < count; ++i) {
            stations.push_back(std::make_unique<Station>());
            const Station& one = *stations.back();
            sync(one);
            administrators.push_back(one.sign_in("administrator"));
            const Session ann = one.sign_in("ann");
            for (int k = 0; k < each; ++k) {
                Recorder recorder(one.path, ann, example_meta(ann.person_id()), one.clock.options());
                Programme::append_second(recorder);
                recorder.finish(example_result(k % 2 == 0, 50 + k % 50));
            }
        }
    }
    std::optional<Programme> base;
    std::vector<std::unique_ptr<Station>> stations;
    std::vector<Session> administrators;
};

std::string number_text(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::vector<std::string> row_of_round(int stations, double rtt_ms, const std::string& what,
                                      const Round& round) {
    const double each = stations;
    return {std::to_string(stations),
            number_text(rtt_ms, 0),
            what,
            std::to_string(round.units),
            number_text(round.wall_s, 2),
            number_text(round.stations_cpu_s, 2),
            number_text(round.server_cpu_s, 2),
            number_text(static_cast<double>(round.statements) / each, 0),
            number_text(static_cast<double>(round.up) / each / 1024, 0),
            number_text(static_cast<double>(round.down) / each / 1024, 0),
            number_text(100 * round.share("processor"), 0),
            number_text(100 * round.share("Lock"), 0),
            number_text(100 * (round.share("LWLock") + round.share("IO")), 0),
            number_text(100 * (round.share("station") + round.share("Client")), 0)};
}

TEST_F(SyncMeasured, WhatTwoStationsSendArrivesAndIsCounted) {
    open(2, 2);
    const Round sent = exchange_at_once(std::chrono::microseconds(200)),
                received = exchange_at_once(std::chrono::microseconds(0));
    EXPECT_EQ(rows_on(server, false), rows_at(*stations[0]->store));
    EXPECT_EQ(rows_on(server, false), rows_at(*stations[1]->store));
    EXPECT_GT(sent.units, 8);
    EXPECT_GT(sent.statements, 100);
    EXPECT_GT(sent.up, 4 * 8000) << "four traces at least";
    EXPECT_GT(received.down, 0);
    EXPECT_LT(received.up, sent.up);
    EXPECT_EQ(exchange_at_once(std::chrono::microseconds(0)).units, 0);
}

TEST_F(SyncMeasured, UpToTwentyStationsForThePage) {
    const char* folder = std::getenv("FULCRUM_STATIONS_PAGE");
    if (folder == nullptr) GTEST_SKIP() << "measured with FULCRUM_STATIONS_PAGE=FOLDER";
    const int each = qEnvironmentVariableIsSet("FULCRUM_SYNC_EACH")
                         ? qEnvironmentVariableIntValue("FULCRUM_SYNC_EACH")
                         : 50;
    lab::ResultTable table;
    table.name = "twenty_stations";
    table.columns = {"stations",
                     "round trip, ms",
                     "round",
                     "units",
                     "slowest, s",
                     "stations' CPU, s",
                     "server's CPU, s",
                     "statements a station",
                     "KiB up a station",
                     "KiB down a station",
                     "server: on CPU, %",
                     "waits for locks, %",
                     "LWLock and IO, %",
                     "waits for the station, %"};
    struct Case {
        int stations, one_way_us;
    };
    for (const Case& one :
         {Case{1, 0}, Case{5, 0}, Case{10, 0}, Case{20, 0}, Case{1, 10000}, Case{20, 10000}}) {
        open(one.stations, each);
        const std::chrono::microseconds one_way(one.one_way_us);
        const double rtt = 2e-3 * one.one_way_us;
        table.rows.push_back(row_of_round(one.stations, rtt, "send", exchange_at_once(one_way)));
        table.rows.push_back(row_of_round(one.stations, rtt, "receive", exchange_at_once(one_way)));
        sync(*base);
        table.rows.push_back(row_of_round(one.stations, rtt, "nothing new", exchange_at_once(one_way)));
        for (const auto& row : table.rows) {
            for (const std::string& cell : row) std::printf("%s  ", cell.c_str());
            std::printf("\n");
        }
        EXPECT_EQ(rows_on(server, false), rows_at(*stations.back()->store));
        std::fflush(stdout);
    }
    expect_sound(server);
    lab::ResultPage page("twenty_stations", "Twenty stations exchange with one server at the same moment",
                         "FULCRUM_SYNC_EACH=" + std::to_string(each) + " FULCRUM_STATIONS_PAGE=" + folder +
                             " test_database --gtest_filter=SyncMeasured.*");
    page.paragraph(
        "Each station has a store of its own and " + std::to_string(each) +
        " new attempts of one second, with traces, scores and audit rows. All begin the exchange in the same "
        "instant, each over a connection of its own to one PostgreSQL. *send*: what is new goes to the "
        "server "
        "(a station that is late receives some already); *receive*: each gets what the others have sent; "
        "*nothing new*: each finds out that there is nothing. Stations, server and the proxy that counts "
        "bytes "
        "and delays messages share the cores of one machine, so the processor is scarcer here than in a "
        "hospital with twenty machines. The server's own time: twenty samples a second of what each of its "
        "sessions does or waits for.");
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

}  // namespace
}  // namespace fulcrum::database::test
