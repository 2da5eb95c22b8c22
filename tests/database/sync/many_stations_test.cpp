// SPDX-License-Identifier: GPL-3.0-or-later
// Many stations that exchange with the server at the same moment. FULCRUM_SYNC_STATIONS=20
// FULCRUM_SYNC_EACH=100 prints the times of docs/FORMATS.md (Sync).
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

int number_from(const char* name, int otherwise) {
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

class SyncStations : public Sync {
  protected:
    void SetUp() override {
        Sync::SetUp();
        if (IsSkipped()) return;
        sync(a);
        for (int i = 0; i < number_from("FULCRUM_SYNC_STATIONS", 4); ++i) {
            stations.push_back(std::make_unique<Station>());
            sync(*stations.back());
            for (int k = 0; k < number_from("FULCRUM_SYNC_EACH", 5); ++k)
                stations.back()->record(k % 2 == 0 ? "ann" : "ben", 50 + k % 50);
        }
    }
    /// All at once, each from a thread with a store of its own; returns the slowest, in seconds.
    double exchange_at_once(std::int64_t& transferred) {
        std::atomic<bool> go{false};
        std::atomic<std::int64_t> moved{0};
        std::vector<double> seconds(stations.size(), 0);
        std::vector<std::string> trouble(stations.size());
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < stations.size(); ++i)
            threads.emplace_back([&, i] {
                try {
                    const Store store = Store::open(stations[i]->path, stations[i]->clock.options());
                    const Session session = People(store).sign_in("administrator", password);
                    while (!go) std::this_thread::yield();
                    const auto start = std::chrono::steady_clock::now();
                    const SyncResult result = sync_with_server(store, session, server);
                    seconds[i] =
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                    moved += result.transferred();
                } catch (const std::exception& error) {
                    trouble[i] = error.what();
                }
            });
        go = true;
        for (std::thread& thread : threads) thread.join();
        for (const std::string& one : trouble) EXPECT_EQ(one, "");
        transferred = moved;
        return *std::max_element(seconds.begin(), seconds.end());
    }
    std::vector<std::unique_ptr<Station>> stations;
};

TEST_F(SyncStations, AllAtOnceAgreeAfterTwoRounds) {
    std::int64_t sent = 0, received = 0;
    const double first = exchange_at_once(sent), second = exchange_at_once(received);
    sync(a);
    std::int64_t nothing = 0;
    const double third = exchange_at_once(nothing);
    EXPECT_EQ(nothing, 0);
    std::printf("%zu stations at once: %lld units in %.2f s, then %lld in %.2f s; nothing to do: %.2f s\n",
                stations.size(), static_cast<long long>(sent), first, static_cast<long long>(received),
                second, third);
    const std::vector<std::string> whole = rows_at(*a.store);
    int attempts = 0;
    for (const std::string& row : whole) attempts += row.rfind("attempt|", 0) == 0 ? 1 : 0;
    EXPECT_EQ(attempts, static_cast<int>(stations.size()) * number_from("FULCRUM_SYNC_EACH", 5));
    EXPECT_EQ(rows_on(server, false), whole);
    for (const auto& station : stations) EXPECT_EQ(rows_at(*station->store), whole);
    expect_sound(server);
    expect_sound(*stations.front()->store);
}

}  // namespace
}  // namespace fulcrum::database::test
