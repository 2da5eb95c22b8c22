// SPDX-License-Identifier: Apache-2.0
// Decides at each tick of the device process whether the force that the program asked for may reach a hand.
//
// The program is not trusted: the age of a command is measured with this process's clock from the moment at
// which a new sequence number was seen. After any trouble the force is 0 at once and stays 0 until commands
// have been good for `steady`; then it rises over `ramp`. No allocation, lock or exception; the result is
// finite and within `peak` for every input, and depends on the arguments only.
#pragma once

#include <cstdint>

#include "sim_core/devices/device_page.h"

namespace fulcrum {

struct ForceGuardLimits {
    std::int64_t silence = 20'000'000;  ///< ns without a new command
    std::int64_t steady = 200'000'000;  ///< ns of good commands before force comes back
    std::int64_t ramp = 300'000'000;    ///< ns from 0 to the whole force
    double peak = 0;                    ///< N; 0: the hand's device renders no force
    double torque = 0;                  ///< N m
};

class ForceGuard {
  public:
    explicit ForceGuard(const ForceGuardLimits& limits = {}) : limits_(limits) {}

    struct Sent {
        Vector3 force = Vector3::Zero();  ///< N
        double torque = 0;                ///< N m
        ForceOff off = ForceOff::starting;
    };
    /// `command`: the newest, null where none can be read. `connection`: 0 where no program is connected;
    /// another number is another program. `overseen`: the overseer runs.
    Sent step(std::int64_t now, const ForceCommand* command, std::uint64_t connection,
              bool overseen) noexcept;

  private:
    ForceOff trouble(std::int64_t now, const ForceCommand* command, std::uint64_t connection,
                     bool overseen) noexcept;
    ForceGuardLimits limits_;
    std::uint64_t connection_ = 0, sequence_ = 0;
    std::int64_t new_at_ = 0, good_since_ = 0;
    bool seen_ = false, good_ = false;
};

}  // namespace fulcrum
