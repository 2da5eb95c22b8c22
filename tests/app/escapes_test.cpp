// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing takes back a limit that is broken: not a kill, not the window's close button, not a device that is
// unplugged and plugged in again.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "app/live/interrupted.h"
#include "app/live/live_attempt.h"
#include "assessment/metrics/statement.h"
#include "assessment/operators/cheats.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/rows/connection.h"
#include "tests/app/counters.h"

namespace fulcrum::app::program_test {
namespace {

using namespace std::chrono_literals;

constexpr double broken_n = 4.5;  // A2 gates 4 N
constexpr auto longest = 240s;    // on a machine that has much else to do

template <typename Condition>
bool wait_until_true(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(2ms);
    }
    return false;
}

/// An operator whose left device can be unplugged; its hands then rest.
class Hands : public ObservingRig {
  public:
    explicit Hands(std::unique_ptr<ObservingRig> rig) : rig_(std::move(rig)) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        if (!resting.load()) {
            rig_->read(tick, last_);
        } else {
            last_.flags = 0;
        }
        sample = last_;
        sample.hand[0].present = unplugged.load() ? 0 : 1;
    }
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }

    std::atomic<bool> resting{false}, unplugged{false};

  private:
    std::unique_ptr<ObservingRig> rig_;
    RigSample last_;
};

/// An assessed attempt at A2 by an operator who presses far too hard, or an expert's.
struct Attempt {
    Attempt(const std::string& store_path, bool heavy)
        : store(database::Store::open(store_path)), session(store.station_session()) {
        const LoadedTask loaded = load_task_and_scene("A2");
        const Cheat* cheat = nullptr;
        for (const Cheat& one : cheats())
            if (std::string(one.name) == "heavy") cheat = &one;
        hands = std::make_shared<Hands>(
            heavy ? make_cheat(*cheat, loaded.task, loaded.scene, 2001)
                  : make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 2001));
        const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
        LiveRequest request;
        request.loaded = loaded;
        request.seed = 2001;
        request.rig = hands;
        request.store_path = store_path;
        request.session = session;
        request.meta = attempt_meta(loaded, request.seed, AttemptMode::assessed, DeviceClass::synthetic,
                                    "synthetic operator", limits);
        request.meta.person_id =
            database::People(store).ensure_synthetic(session, "expert", "Synthetic expert").id;
        request.limits = limits;
        live.emplace(std::move(request));
        live->start();
    }
    bool reaches(ui::AttemptPhase phase) {
        return wait_until_true([&] { return live->phase() == phase; });
    }
    /// Until it is recorded that the limit is broken.
    bool breaks_the_limit() {
        const bool broken = wait_until_true([&] {
            live->update();
            return static_cast<double>(live->display().force[0]) > broken_n;
        });
        std::this_thread::sleep_for(400ms);  // the press lasts, and the recorder looks every 100 ms
        return broken;
    }
    bool moves() {
        return wait_until_true([&] {
            live->update();
            return live->display().moving_seen;
        });
    }
    bool loses_the_device() {
        hands->resting = true;
        hands->unplugged = true;
        return reaches(ui::AttemptPhase::device_lost);
    }
    bool device_comes_back() {
        hands->unplugged = false;
        return wait_until_true([&] {
            const ui::Realignment shown = live->realignment();
            return shown.back && shown.in_place;
        });
    }
    bool resumes() {
        live->resume();
        hands->resting = false;
        return reaches(ui::AttemptPhase::running);
    }

    database::Store store;
    database::Session session;
    std::shared_ptr<Hands> hands;
    std::optional<LiveAttempt> live;
};

database::AttemptSummary only_attempt(const std::string& store_path) {
    const database::Store store = database::Store::open(store_path);
    database::AttemptFilter all;
    const auto attempts = database::Attempts(store).list(store.station_session(), all);
    EXPECT_EQ(attempts.size(), 1U);
    return attempts.empty() ? database::AttemptSummary() : attempts.front();
}

void expect_failed(const database::AttemptSummary& attempt) {
    EXPECT_EQ(attempt.passed, false) << stored_text(attempt.not_scored_because);
    EXPECT_EQ(attempt.meta.mode, AttemptMode::assessed);
    EXPECT_TRUE(attempt.counting);
}

enum Moment { running, paused, device_lost, device_back, resumed, storing, moments };
constexpr std::array<const char*, moments> moment_names = {"running",     "paused",  "device lost",
                                                           "device back", "resumed", "storing"};

bool reaches(Attempt& attempt, int moment) {
    switch (moment) {
        case running:
            return true;
        case paused:
            attempt.live->pause();
            return attempt.reaches(ui::AttemptPhase::paused);
        case device_lost:
            return attempt.loses_the_device();
        case device_back:
            return attempt.loses_the_device() && attempt.device_comes_back();
        case resumed:
            return attempt.loses_the_device() && attempt.device_comes_back() && attempt.resumes();
        default:
            attempt.live->abandon();
            return wait_until_true([&] { return attempt.live->phase() >= ui::AttemptPhase::finishing; });
    }
}

class Escapes : public ::testing::Test {
  protected:
    Escapes() { database::Store::create(store_path, false); }
    QTemporaryDir folder;
    const std::string folder_path = folder.path().toStdString(), store_path = folder_path + "/fulcrum.db",
                      counters_path = folder_path + "/counters";
};

class KilledAt : public Escapes, public ::testing::WithParamInterface<int> {};

TEST_P(KilledAt, AnAttemptWithABrokenLimitIsFailedAtTheNextStart) {
    Counters* counters = map_counters(counters_path.c_str());
    ASSERT_NE(counters, nullptr);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        ::execl("/proc/self/exe", "test_app", "--break-limit", folder_path.c_str(), counters_path.c_str(),
                std::to_string(GetParam()).c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    int status = 0;
    const bool reached = wait_until_true(
        [&] { return counters->finished.load() > 0 || ::waitpid(child, &status, WNOHANG) != 0; });
    ASSERT_TRUE(reached && counters->finished.load() > 0) << "the child did not get there: " << status;
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    {
        const database::Store store = database::Store::open(store_path);
        score_interrupted(store_path, store.station_session());
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_TRUE(attempt.state == AttemptState::interrupted ||
                (GetParam() == storing && attempt.state == AttemptState::abandoned))
        << row_of(attempt_states, attempt.state).name;
    expect_failed(attempt);
}

std::string moment_name(const ::testing::TestParamInfo<int>& moment) {
    std::string name = moment_names[static_cast<std::size_t>(moment.param)];
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    return name;
}
INSTANTIATE_TEST_SUITE_P(Moments, KilledAt, ::testing::Range(0, static_cast<int>(moments)), moment_name);

TEST_F(Escapes, ClosingAbandonsAndIsFailedWithOrWithoutABrokenLimit) {
    {
        Attempt attempt(store_path, false);
        ASSERT_TRUE(attempt.moves());
        attempt.live->abandon();
        attempt.live.reset();  // at once, as a window does that is closed
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_EQ(attempt.state, AttemptState::abandoned);
    expect_failed(attempt);
}

TEST_F(Escapes, AnInterruptionIsFailedOnlyWhereALimitWasBroken) {
    {
        Attempt attempt(store_path, true);
        ASSERT_TRUE(attempt.breaks_the_limit());
        attempt.live.reset();
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_EQ(attempt.state, AttemptState::interrupted);
    expect_failed(attempt);
}

TEST_F(Escapes, AnInterruptionWithoutABrokenLimitIsNotScored) {
    {
        Attempt attempt(store_path, false);
        ASSERT_TRUE(attempt.moves());
        attempt.live.reset();
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_EQ(attempt.state, AttemptState::interrupted);
    EXPECT_FALSE(attempt.passed);
    EXPECT_FALSE(attempt.counting);
}

TEST_F(Escapes, UnpluggingAndPluggingInTakesNothingBack) {
    {
        Attempt attempt(store_path, true);
        ASSERT_TRUE(attempt.breaks_the_limit());
        ASSERT_TRUE(attempt.loses_the_device());
        ASSERT_TRUE(attempt.device_comes_back());
        ASSERT_TRUE(attempt.resumes());
        attempt.live->abandon();
        attempt.live->wait();
        attempt.live->rethrow();
        EXPECT_TRUE(attempt.live->assessed());
        EXPECT_FALSE(attempt.live->became_practice());
    }
    expect_failed(only_attempt(store_path));
}

TEST_F(Escapes, UnpluggingWithoutABrokenLimitMakesPracticeOfIt) {
    {
        Attempt attempt(store_path, false);
        ASSERT_TRUE(attempt.moves());
        ASSERT_TRUE(attempt.loses_the_device());
        ASSERT_TRUE(attempt.device_comes_back());
        ASSERT_TRUE(attempt.resumes());
        EXPECT_TRUE(wait_until_true([&] { return attempt.live->became_practice(); }));
        attempt.live->abandon();
        attempt.live->wait();
        attempt.live->rethrow();
    }
    const database::AttemptSummary attempt = only_attempt(store_path);
    EXPECT_EQ(attempt.meta.mode, AttemptMode::practice);
    EXPECT_FALSE(attempt.counting);
}

/// The whole program stands still for longer than the second that an assessed attempt allows.
void stop_this_program() {
    const std::string wake = "(sleep 1.4; kill -CONT " + std::to_string(::getpid()) + ") &";
    ASSERT_EQ(std::system(wake.c_str()), 0);
    ASSERT_EQ(::kill(::getpid(), SIGSTOP), 0);
}

TEST_F(Escapes, StoppingTheProgramMakesPracticeOfItAndIsInTheAuditLog) {
    {
        Attempt attempt(store_path, false);
        ASSERT_TRUE(attempt.moves());
        stop_this_program();
        EXPECT_TRUE(wait_until_true([&] { return attempt.live->became_practice(); }));
        attempt.live->abandon();
        attempt.live->wait();
        attempt.live->rethrow();
    }
    EXPECT_EQ(only_attempt(store_path).meta.mode, AttemptMode::practice);
    const database::Store store = database::Store::open(store_path);
    database::Query row(store.connection(),
                        "SELECT p.payload FROM audit_payload p JOIN audit_entry e ON e.sequence = p.sequence "
                        "WHERE e.operation = 'attempt.practice'");
    ASSERT_TRUE(row.next());
    const std::string reason = nlohmann::json::parse(row.text(0)).at("reason").get<std::string>();
    EXPECT_EQ(statement_of(reason).id(), StatementId::practice_stood_still) << reason;
    ASSERT_NE(statement_of(reason).number("seconds"), nullptr) << reason;
    EXPECT_GE(*statement_of(reason).number("seconds"), 1) << reason;
    EXPECT_TRUE(store.check(store.station_session()).ok);
}

TEST_F(Escapes, StoppingTheProgramAfterALimitWasBrokenDoesNotTakeItBack) {
    {
        Attempt attempt(store_path, true);
        ASSERT_TRUE(attempt.breaks_the_limit());
        stop_this_program();
        attempt.live->abandon();
        attempt.live->wait();
        attempt.live->rethrow();
        EXPECT_FALSE(attempt.live->became_practice());
    }
    expect_failed(only_attempt(store_path));
}

}  // namespace

int break_limit_until_killed(const char* folder, const char* counters_path, int moment) {
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    Attempt attempt(std::string(folder) + "/fulcrum.db", true);
    if (!attempt.breaks_the_limit()) return 2;
    if (!reaches(attempt, moment)) return 3;
    counters->finished.store(1);
    for (;;) ::pause();
}

}  // namespace fulcrum::app::program_test
