// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/servo_backend.h"

#include <poll.h>

#include <algorithm>
#include <cmath>

namespace fulcrum::hapticd {

bool ServoBackend::is_silent(Silence& silence, bool is_new, std::int64_t now) noexcept {
    if (is_new || silence.new_at == 0) silence.new_at = now;
    const bool was = silence.now;
    silence.now = now - silence.new_at > servo_silence;
    const bool lately = silence.seen_at != 0 && now - silence.seen_at < falls_behind;
    if (silence.now && !was) silence.again = lately;
    if (silence.now) silence.seen_at = now;
    return silence.now || (silence.again && lately);
}

void ServoBackend::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    DeviceFault worst = DeviceFault::none;
    report_ = {};
    for (int h = 0; h < 2; ++h) {
        DevicePose& pose = poses[h];
        if (!facts_.slot[h]) continue;
        const std::uint64_t before = newest_[h].sequence;
        const bool got = reading_[h].read(newest_[h]);
        auto fault = static_cast<DeviceFault>(newest_[h].fault);
        if (is_silent(silence_[h], got && newest_[h].sequence != before, now)) fault = silent_;
        pose.sequence = newest_[h].sequence;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = newest_[h].position[axis];
        pose.roll = newest_[h].roll;
        pose.jaw = newest_[h].jaw;
        pose.buttons = static_cast<std::uint32_t>(newest_[h].buttons);
        pose.present = got && fault == DeviceFault::none ? 1 : 0;
        if (fault == DeviceFault::none) continue;
        report_.hands |= std::uint64_t{1} << h;
        if (worst == DeviceFault::none || (needs_opening(fault) && !needs_opening(worst))) worst = fault;
    }
    report_.fault = static_cast<std::uint64_t>(worst);
    if (!needs_opening(worst))
        faulty_since_ = 0;
    else if (faulty_since_ == 0)
        faulty_since_ = now;
    lost_ = faulty_since_ != 0 && now - faulty_since_ > time_to_be_lost;
}

void ServoBackend::render(int hand, const Vector3& force, double torque) noexcept {
    Wanted wanted;
    wanted.time = monotonic_ns();
    for (int axis = 0; axis < 3; ++axis) wanted.force[axis] = force[axis];
    wanted.torque = torque;
    wanted_[hand].write(wanted);
}

bool ServoBackend::newest(int hand, std::int64_t now, Wanted& wanted) const noexcept {
    return wanted_[hand].read(wanted) && now - wanted.time <= servo_silence;
}

Vector3 ServoBackend::wanted_force(int hand, std::int64_t now) const noexcept {
    Wanted wanted;
    if (!facts_.force[hand] || !newest(hand, now, wanted)) return Vector3::Zero();
    Vector3 force(wanted.force[0], wanted.force[1], wanted.force[2]);
    if (!force.allFinite()) return Vector3::Zero();
    const double size = force.norm(), peak = facts_.force[hand]->peak;
    if (size > peak) force *= peak / size;
    return force;
}

double ServoBackend::wanted_torque(int hand, std::int64_t now) const noexcept {
    Wanted wanted;
    if (!facts_.force[hand] || !newest(hand, now, wanted) || !std::isfinite(wanted.torque)) return 0;
    const double limit = facts_.force[hand]->torque;
    return std::clamp(wanted.torque, -limit, limit);
}

void ServoBackend::publish(int hand, ServoReading reading) noexcept {
    reading.sequence = count_[hand].load(std::memory_order_relaxed) + 1;
    reading_[hand].write(reading);
    count_[hand].store(reading.sequence, std::memory_order_release);
}

void ServoBackend::wait_for_servo() const noexcept {
    std::uint64_t begin[2] = {published(0), published(1)};
    for (int ms = 0; ms < 20; ++ms) {
        bool both = true;
        for (int h = 0; h < 2; ++h) both = both && (!facts_.slot[h] || published(h) >= begin[h] + 2);
        if (both) return;
        poll(nullptr, 0, 1);
    }
}

}  // namespace fulcrum::hapticd
