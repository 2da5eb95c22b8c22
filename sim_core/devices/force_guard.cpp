// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/force_guard.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

ForceOff ForceGuard::trouble(std::int64_t now, const ForceCommand* command, std::uint64_t connection,
                             bool overseen) noexcept {
    if (connection != connection_) {  // another program counts from its own beginning
        connection_ = connection;
        seen_ = false;
    }
    if (connection == 0) return ForceOff::no_program;
    if (!overseen) return ForceOff::overseer_stopped;
    const bool is_new = command != nullptr && (!seen_ || command->sequence != sequence_);
    if (is_new) {
        const bool back = seen_ && command->sequence < sequence_;
        sequence_ = command->sequence;
        if (back) return ForceOff::sequence_back;
        new_at_ = now;
        seen_ = true;
    }
    if (!seen_ || now - new_at_ > limits_.silence || now < new_at_) return ForceOff::silent;
    if (command == nullptr) return ForceOff::starting;
    const Vector3 force(command->force[0], command->force[1], command->force[2]);
    if (!force.allFinite() || !std::isfinite(command->torque)) return ForceOff::not_finite;
    constexpr double slack = 1 + 1e-6;  // of rounding
    if (!(force.norm() <= limits_.peak * slack) || std::abs(command->torque) > limits_.torque * slack)
        return ForceOff::too_large;
    return ForceOff::none;
}

ForceGuard::Sent ForceGuard::step(std::int64_t now, const ForceCommand* command, std::uint64_t connection,
                                  bool overseen) noexcept {
    Sent sent;
    sent.off = trouble(now, command, connection, overseen);
    if (sent.off != ForceOff::none) {
        good_ = false;
        return sent;
    }
    if (!good_) {
        good_ = true;
        good_since_ = now;
    }
    const std::int64_t risen = now - good_since_ - limits_.steady;
    if (risen <= 0) {
        sent.off = ForceOff::starting;
        return sent;
    }
    const double share =
        limits_.ramp > 0 ? std::min(1.0, static_cast<double>(risen) / static_cast<double>(limits_.ramp)) : 1;
    sent.force = share * Vector3(command->force[0], command->force[1], command->force[2]);
    if (const double size = sent.force.norm(); size > limits_.peak) sent.force *= limits_.peak / size;
    sent.torque = std::clamp(share * command->torque, -limits_.torque, limits_.torque);
    return sent;
}

}  // namespace fulcrum
