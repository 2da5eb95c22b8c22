// SPDX-License-Identifier: Apache-2.0
// A handle whose poses arrive seldom: each is reached in a straight line over the time between two of them,
// so that a tracker of 60 Hz moves an instrument without steps. It is absent where poses stop.
#pragma once

#include <cstdint>

#include "sim_core/numerics/types.h"

namespace fulcrum::hapticd {

/// Handle and roll of a tracked pose, device frame.
struct TrackedHandle {
    Vector3 position = Vector3::Zero();
    double roll = 0;
};

class FollowedHandle {
  public:
    /// A pose that arrived; the roll is taken as the nearest turn. `spacing`: ns since the one before by the
    /// tracker's own clock, 0 where it has none.
    void take(TrackedHandle next, std::int64_t now, std::int64_t spacing = 0) noexcept;
    const TrackedHandle& at(std::int64_t now) noexcept;
    bool seen() const noexcept { return arrived_ != 0; }
    bool fresh(std::int64_t now) const noexcept;

  private:
    TrackedHandle from_, to_, now_;
    std::int64_t arrived_ = 0, interval_ = 0;  // ns; arrived 0: no pose yet
};

}  // namespace fulcrum::hapticd
