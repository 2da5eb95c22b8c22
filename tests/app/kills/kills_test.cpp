// SPDX-License-Identifier: GPL-3.0-or-later
// The program killed at random times while it performs on the clock with all its threads. FULCRUM_KILLS sets
// how often; 200 for the long run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

#include "app/interrupted.h"
#include "app/live_attempt.h"
#include "assessment/operators/operator.h"
#include "database/attempts.h"
#include "database/people.h"

namespace fulcrum::app::test {
namespace {

/// What the child tells: shared memory outlives a kill.
struct Counters {
    std::atomic<std::uint32_t> ticks{0};     ///< of the attempt that runs
    std::atomic<std::uint32_t> begun{0};     ///< attempts whose first tick was read
    std::atomic<std::uint32_t> finished{0};  ///< attempts whose score was acknowledged as stored
};

Counters* map_counters(const char* path) {
    const int file = ::open(path, O_RDWR | O_CREAT, 0600);
    if (file < 0 || ::ftruncate(file, sizeof(Counters)) != 0) return nullptr;
    void* memory = ::mmap(nullptr, sizeof(Counters), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    return memory == MAP_FAILED ? nullptr : static_cast<Counters*>(memory);
}

/// The expert's hands; counts the ticks that were read.
class CountingRig : public ObservingRig {
  public:
    CountingRig(std::unique_ptr<ObservingRig> rig, Counters& counters)
        : rig_(std::move(rig)), counters_(counters) {}
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }
    void read(std::uint32_t tick, RigSample& sample) override {
        rig_->read(tick, sample);
        counters_.ticks.store(tick);
        if (tick == 1) counters_.begun.fetch_add(1);
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }

  private:
    std::unique_ptr<ObservingRig> rig_;
    Counters& counters_;
};

int kills() {
    const char* asked = std::getenv("FULCRUM_KILLS");
    return asked != nullptr ? std::atoi(asked) : 4;
}

}  // namespace

/// One short attempt after the other, each abandoned and scored, until the kill.
int perform_until_killed(const char* store_path, const char* counters_path, unsigned long seed) {
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    std::mt19937_64 random(seed);
    const database::Store store = database::Store::open(store_path);
    const database::Session station = store.station_session();
    const database::Person person =
        database::People(store).ensure_synthetic(station, "expert", "Synthetic expert");
    const LoadedTask loaded = load_task_and_scene("A2");
    const std::optional<BenchmarkSet> benchmark = benchmark_in_force("A2");
    for (std::uint64_t number = 0;; ++number) {
        LiveRequest request;
        request.loaded = loaded;
        request.seed = 5000 + seed * 100 + number;
        request.rig = std::make_shared<CountingRig>(
            make_operator("expert", loaded.task, loaded.scene, request.seed), *counters);
        request.store_path = store_path;
        request.session = station;
        request.meta =
            attempt_meta(loaded, request.seed, "assessed", "synthetic", "synthetic operator", &*benchmark);
        request.meta.person_id = person.id;
        request.benchmark = benchmark;
        counters->ticks.store(0);
        LiveAttempt attempt(std::move(request));
        attempt.start();
        std::this_thread::sleep_for(std::chrono::milliseconds(300 + random() % 1500));
        attempt.abandon();
        attempt.wait();
        attempt.rethrow();
        counters->finished.fetch_add(1);
    }
}

namespace {

TEST(Kills, NoFinishedScoreIsLostAndEveryAttemptIsFoundAndScored) {
    QTemporaryDir folder;
    const std::string store_path = folder.filePath("store.db").toStdString(),
                      counters_path = folder.filePath("counters").toStdString();
    database::Store::create(store_path, false);
    Counters* counters = map_counters(counters_path.c_str());
    ASSERT_NE(counters, nullptr);
    std::mt19937_64 random(20261121);
    std::uint32_t worst_lost = 0;
    std::size_t interrupted_total = 0, earlier = 0;
    for (int round = 0; round < kills(); ++round) {
        counters->ticks.store(0);
        const std::uint32_t finished_before = counters->finished.load(),
                            begun_before = counters->begun.load();
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            ::execl("/proc/self/exe", "test_app_kills", "--perform-until-killed", store_path.c_str(),
                    counters_path.c_str(), std::to_string(round).c_str(), static_cast<char*>(nullptr));
            ::_exit(127);
        }
        int status = 0;
        while (counters->begun.load() == begun_before) {  // at random from the first tick on
            ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << "the child ended by itself: " << status;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 2200));
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
        const std::uint32_t finished = counters->finished.load() - finished_before;

        // The next start: what was running is listed as interrupted, and scored from its record.
        const database::Store store = database::Store::open(store_path);
        const database::Session station = store.station_session();
        const database::Attempts attempts(store);
        const std::size_t open = attempts.interrupted_without_score(station).size();
        EXPECT_LE(open, 1U);
        interrupted_total += open;
        std::size_t seen = 0, scored = 0;
        const auto list = attempts.list(station);
        for (std::size_t i = 0; i + earlier < list.size(); ++i) {  // newest first: this round's
            ++seen;
            EXPECT_NE(list[i].state, "running");
            if (list[i].state != "interrupted") {
                EXPECT_TRUE(attempts.score(station, list[i].meta.id).has_value());
                ++scored;
                continue;
            }
            const database::Trace trace = attempts.read_trace(station, list[i].meta.id);
            for (std::size_t k = 0; k < trace.samples.size(); ++k) ASSERT_EQ(trace.samples[k].tick, k + 1);
            worst_lost = std::max(worst_lost,
                                  counters->ticks.load() - static_cast<std::uint32_t>(trace.samples.size()));
        }
        EXPECT_GE(scored, finished) << "a score that was acknowledged is gone";
        EXPECT_GE(seen, std::size_t{counters->begun.load() - begun_before});
        earlier = list.size();
        EXPECT_EQ(score_interrupted(store_path, station).size(), open);
        EXPECT_TRUE(attempts.interrupted_without_score(station).empty());
        EXPECT_TRUE(store.check(station).ok) << "round " << round;
    }
    std::printf("%d kills: %zu attempts interrupted and scored, %u finished, at most %u ticks lost\n",
                kills(), interrupted_total, counters->finished.load(), worst_lost);
    // A second where the recorder's thread gets the processor; a machine that starves it for seconds loses
    // those.
    EXPECT_LE(worst_lost, kills() >= 200 ? 1000U : 5000U);
}

}  // namespace
}  // namespace fulcrum::app::test
