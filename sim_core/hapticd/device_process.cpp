// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/device_process.h"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

#include "sim_core/devices/force_guard.h"
#include "sim_core/devices/jitter.h"
#include "sim_core/devices/sentence_packet.h"
#include "sim_core/devices/tick_account.h"
#include "sim_core/hapticd/rights.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t overseer_silence = 20'000'000;     // ns
constexpr std::int64_t nanoseconds = 1000LL * 1'000'000;  // of a second
constexpr std::int64_t catch_up = 20;                     // periods; above it the clock is moved
constexpr int device_priority = 85;
constexpr unsigned int time_to_close_s = 1;

void sleep_until(std::int64_t deadline) noexcept {
    timespec time{};
    time.tv_sec = deadline / nanoseconds;
    time.tv_nsec = deadline % nanoseconds;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
    }
}

bool write_line(int descriptor, const nlohmann::json& line) {
    const std::string text = line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

/// One hand's motors.
class Motors {
  public:
    Motors(Backend& backend, StatePage& state, const CommandPage& command, int hand)
        : backend_(backend), state_(state), command_(command), hand_(hand) {
        ForceGuardLimits limits;
        if (const auto& force = backend.facts().force[hand]) {
            limits.peak = force->peak;
            limits.torque = force->torque;
        }
        guard_ = ForceGuard(limits);
    }
    void step(std::int64_t now, std::uint64_t connection, bool overseen) noexcept {
        if (command_.command[hand_].read(newest_)) any_ = true;
        render(now, guard_.step(now, any_ ? &newest_ : nullptr, connection, overseen));
    }
    void off(std::int64_t now, ForceOff why) noexcept {
        guard_.step(now, nullptr, 0, false);  // the next good command is the first
        ForceGuard::Sent nothing;
        nothing.off = why;
        render(now, nothing);
    }

  private:
    void render(std::int64_t now, const ForceGuard::Sent& sent) noexcept {
        backend_.render(hand_, sent.force, sent.torque);
        ForceReport report;
        report.sequence = newest_.sequence;
        report.command_time = newest_.time;
        report.time = now;
        for (int axis = 0; axis < 3; ++axis) report.force[axis] = sent.force[axis];
        report.off = static_cast<std::uint64_t>(sent.off);
        state_.report[hand_].write(report);
    }
    Backend& backend_;
    StatePage& state_;
    const CommandPage& command_;
    int hand_;
    ForceGuard guard_;
    ForceCommand newest_;
    bool any_ = false;
};

/// True if it ended because the device is lost.
bool run_loop(Backend& backend, StatePage& state, const CommandPage& command, pid_t overseer,
              bool real_time) noexcept {
    Motors motors[2] = {{backend, state, command, 0}, {backend, state, command, 1}};
    LoopReport loop;
    loop.period = static_cast<std::int64_t>(1e9 / backend.facts().rate);
    loop.real_time = real_time ? 1 : 0;
    DevicePose poses[device_slots];
    Jitter jitter(loop.period);
    TickAccount account(loop.period);
    std::int64_t worked = 0;  // ns, by the tick before
    ThreadUse used;
    std::int64_t deadline = monotonic_ns() + loop.period;
    while (state.stopping.load(std::memory_order_relaxed) == 0) {
        sleep_until(deadline);
        const std::int64_t now = monotonic_ns(), late = now - deadline;
        const ThreadUse at_begin = use_of_this_thread();
        ++loop.ticks;
        const Lateness lateness = account.begin(late, worked, used);
        if (lateness != Lateness::in_time) ++loop.late;
        if (lateness == Lateness::by_program) ++loop.late_own;
        loop.worst_late = std::max(loop.worst_late, late);
        jitter.came(now);
        loop.jitter = jitter.seconds();
        if (late >= catch_up * loop.period) {
            deadline = now;
            account.clock_moved();
        }
        deadline += loop.period;
        backend.read(now, poses);
        for (int i = 0; i < device_slots; ++i) {
            poses[i].time = now;
            state.pose[i].write(poses[i]);
        }
        if (getppid() != overseer) {  // nobody could switch off the motors of a stopped device process
            for (Motors& hand : motors) hand.off(now, ForceOff::overseer_stopped);
            return false;
        }
        const std::int64_t beat = state.overseer_time.load(std::memory_order_relaxed);
        const bool overseen = now - beat <= overseer_silence;
        const std::uint64_t connection = state.connection.load(std::memory_order_relaxed);
        const FaultReport fault = backend.fault();
        state.fault.write(fault);
        for (Motors& hand : motors) {
            if (fault.fault == 0)
                hand.step(now, connection, overseen);
            else
                hand.off(now, ForceOff::device_fault);
        }
        if (backend.lost()) return true;
        state.loop.write(loop);
        worked = monotonic_ns() - now;
        used = use_of_this_thread() - at_begin;
    }
    for (Motors& hand : motors) hand.off(monotonic_ns(), ForceOff::no_program);
    return false;
}

}  // namespace

int run_device(Backend& backend, StatePage& state, const CommandPage& command, pid_t overseer, int report) {
    try {
        backend.open();
    } catch (const InputError& error) {
        write_line(report, {{"error", sentence_packet(error.problem_sentence())},
                            {"file", error.file()},
                            {"place", error.place()},
                            {"hint", sentence_packet(error.hint_sentence())}});
        return 2;
    }
    const RealTime real_time = become_real_time(device_priority);
    const bool filtered = give_up_rights();
    nlohmann::json line = {{"device", to_json(backend.facts())},
                           {"notes", real_time.notes},
                           {"real_time", real_time.priority},
                           {"filtered", filtered}};
    if (!filtered) line["notes"].push_back("the system does not filter system calls of this process");
    if (!write_line(report, line)) return 1;
    const bool lost = run_loop(backend, state, command, overseer, real_time.priority);
    alarm(time_to_close_s);  // a library that hangs is ended by the system
    backend.close();
    return lost ? status_lost : 0;
}

}  // namespace fulcrum::hapticd
