// SPDX-License-Identifier: GPL-3.0-or-later
// An assessed attempt whose operator breaks a limit or does not, and whose devices a test unplugs.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/live/live_attempt.h"
#include "assessment/metrics/statement.h"
#include "assessment/operators/cheats.h"
#include "database/records/attempts.h"
#include "database/records/people.h"

namespace fulcrum::app::program_test {

/// Within minutes, on a machine that has much else to do. No event of a window is processed until then.
template <typename Condition>
bool comes_true(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(240);
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

/// An operator whose left device can be unplugged; its hands can rest. It can press in two steps: lightly for
/// a while, then on.
class EscapingHands : public ObservingRig {
  public:
    static constexpr double broken_n = 4.5;  // A2 gates 4 N
    explicit EscapingHands(std::unique_ptr<ObservingRig> rig) : rig_(std::move(rig)) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        if (lingering_ > 0) {
            --lingering_;
        } else if (!resting.load() || !begun_) {
            rig_->read(tick, last_);
            begun_ = true;
        } else {
            last_.flags = 0;
        }
        sample = last_;
        sample.hand[0].present = unplugged.load() ? 0 : 1;
    }
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
        const auto force = static_cast<double>(display.force[0]);
        if (force > broken_n) broke = true;
        if (display.moving_seen) moved = true;
        if (linger.load() && force > touching_n && force < pressed_n) {
            linger = false;
            lingering_ = 300;
        }
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }

    std::atomic<bool> resting{false}, unplugged{false}, linger{false};
    /// Shown once, at any time.
    std::atomic<bool> broke{false}, moved{false};

  private:
    static constexpr double touching_n = 1.6, pressed_n = 3.5;
    std::unique_ptr<ObservingRig> rig_;
    RigSample last_;
    bool begun_ = false;
    int lingering_ = 0;  // ticks
};

/// An expert's hands at A2, or those of an operator who presses far too hard.
inline std::shared_ptr<EscapingHands> hands_at_a2(const LoadedTask& loaded, bool heavy) {
    constexpr std::uint64_t seed = 2001;
    if (!heavy)
        return std::make_shared<EscapingHands>(
            make_operator(OperatorLevel::expert, loaded.task, loaded.scene, seed));
    const Cheat* cheat = nullptr;
    for (const Cheat& one : cheats())
        if (std::string(one.name) == "heavy") cheat = &one;
    return std::make_shared<EscapingHands>(make_cheat(*cheat, loaded.task, loaded.scene, seed));
}

/// At A2, with the hands of hands_at_a2(). It is begun unless `starts` is false.
struct EscapingAttempt {
    EscapingAttempt(const std::string& store_path, bool heavy, bool linger = false, bool starts = true)
        : store(database::Store::open(store_path)), session(store.station_session()) {
        const LoadedTask loaded = load_task_and_scene("A2");
        hands = hands_at_a2(loaded, heavy);
        hands->linger = linger;
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
        request.simulator_fails = fails;
        live.emplace(std::move(request));
        if (starts) live->start();
    }
    bool reaches(ui::AttemptPhase phase) {
        return comes_true([&] { return live->phase() == phase; });
    }
    bool shows_force(double newton) {
        return comes_true([&] {
            live->update();
            return static_cast<double>(live->display().force[0]) > newton;
        });
    }
    /// Until the press has been recorded.
    bool breaks_the_limit() {
        return comes_true([&] { return hands->broke.load(); }) && ticks_pass(400);
    }
    bool moves() {
        return comes_true([&] { return hands->moved.load(); });
    }
    bool ticks_pass(std::uint32_t count) {
        const std::uint32_t before = live->health().ticks;
        return comes_true([&] { return live->health().ticks >= before + count; });
    }
    bool pauses() {
        hands->resting = true;  // a hand that moves in a pause is not in place after a loss
        live->pause();
        return reaches(ui::AttemptPhase::paused) && ticks_pass(5);
    }
    bool loses_the_device() {
        hands->resting = true;
        hands->unplugged = true;
        return reaches(ui::AttemptPhase::device_lost);
    }
    bool device_comes_back() {
        hands->unplugged = false;
        return comes_true([&] {
            const ui::Realignment shown = live->realignment();
            return shown.back && shown.in_place;
        });
    }
    /// While it is back and the attempt has not resumed.
    bool loses_it_again() {
        hands->unplugged = true;
        return comes_true([&] { return !live->realignment().back; });
    }
    void asks_to_resume() {
        live->resume();
        hands->resting = false;
    }
    bool resumes() {
        asks_to_resume();
        return reaches(ui::AttemptPhase::running);
    }
    void abandon_and_wait() {
        live->abandon();
        live->wait();
        live->rethrow();
    }

    database::Store store;
    database::Session session;
    std::shared_ptr<EscapingHands> hands;
    std::shared_ptr<std::atomic<bool>> fails = std::make_shared<std::atomic<bool>>(false);
    std::optional<LiveAttempt> live;
};

inline std::vector<database::AttemptSummary> stored_attempts(const std::string& store_path) {
    const database::Store store = database::Store::open(store_path);
    database::AttemptFilter all;
    return database::Attempts(store).list(store.station_session(), all);
}

inline database::AttemptSummary only_attempt(const std::string& store_path) {
    const auto attempts = stored_attempts(store_path);
    EXPECT_EQ(attempts.size(), 1U);
    return attempts.empty() ? database::AttemptSummary() : attempts.front();
}

inline void expect_failed(const database::AttemptSummary& attempt) {
    EXPECT_EQ(attempt.passed, false) << stored_text(attempt.not_scored_because);
    EXPECT_EQ(attempt.meta.mode, AttemptMode::assessed);
    EXPECT_TRUE(attempt.counting);
}

}  // namespace fulcrum::app::program_test
