// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/force_test.h"

#include <algorithm>
#include <cmath>

#include "app/live/real_time.h"

namespace fulcrum::app {
namespace {

constexpr std::int64_t command_period = 1'000'000;   // ns
constexpr std::int64_t kept_for = 2000 * 1'000'000;  // ns
constexpr double round_s = 3;                        // three axes
constexpr int ending_ticks = 10;                     // with force 0, so that the last one is rendered

}  // namespace

GentleForce gentle_force(double time, double peak) {
    const double in_second = time - std::floor(time);
    return {static_cast<int>(std::fmod(time, 3)), peak * (1 - std::abs(2 * in_second - 1))};
}

ForceTest::ForceTest(std::shared_ptr<DaemonClient> client) : client_(std::move(client)) {
    // Commands of before are older.
    for (ForceCommand& one : sent_) one.sequence = static_cast<std::uint64_t>(monotonic_ns());
    thread_ = std::thread([this] { run(); });
}

ForceTest::~ForceTest() {
    stop();
}

void ForceTest::stop() {
    stop_.store(true);
    if (thread_.joinable()) thread_.join();
}

bool ForceTest::command(int hand, const GentleForce& force) noexcept {
    ForceCommand& one = sent_[hand];
    ++one.sequence;
    one.time = monotonic_ns();
    for (int axis = 0; axis < 3; ++axis) one.force[axis] = axis == force.axis ? force.size : 0;
    client_->command().command[hand].write(one);
    asked_.store(force.size);
    largest_asked_.store(std::max(largest_asked_.load(), force.size));
    ForceReport report;
    if (client_->state().report[hand].read(report))
        rendered_.store(std::max(rendered_.load(),
                                 std::hypot(std::hypot(report.force[0], report.force[1]), report.force[2])));
    return !stop_.load(std::memory_order_relaxed) && one.time - kept_.load() < kept_for;
}

void ForceTest::run() noexcept {
    raise_priority(80);
    const auto& force = client_->facts().force;
    const int hands = (force[0] ? 1 : 0) + (force[1] ? 1 : 0);
    int done = 0;
    bool goes_on = hands > 0;
    std::int64_t deadline = monotonic_ns();
    const auto next = [&deadline] {
        deadline = std::max(deadline + command_period, monotonic_ns() - 5 * command_period);
        sleep_until(deadline);
    };
    for (int h = 0; h < 2 && goes_on; ++h) {
        if (!force[h]) continue;
        hand_.store(h);
        // The force is off until commands have been good for a while, and then rises: wait for that with 0.
        for (int i = 0; i < 600 && goes_on; ++i, next()) goes_on = command(h, {});
        const std::int64_t begin = monotonic_ns();
        for (double time = 0; time < 2 * round_s && goes_on; next()) {
            const double limit = std::min(time < round_s ? first_peak : peak, force[h]->continuous);
            const GentleForce now = gentle_force(time, limit);
            axis_.store(now.axis);
            goes_on = command(h, now);
            time = static_cast<double>(monotonic_ns() - begin) * 1e-9;
            progress_.store((done + std::min(1.0, time / (2 * round_s))) / hands);
        }
        for (int i = 0; i < ending_ticks; ++i, next()) command(h, {});
        ++done;
    }
    asked_.store(0);
    runs_.store(false);
}

}  // namespace fulcrum::app
