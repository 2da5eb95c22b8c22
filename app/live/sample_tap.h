// SPDX-License-Identifier: GPL-3.0-or-later
// Where the haptic thread leaves its newest sample for a thread that is not in real time. Neither waits for
// the other.
#pragma once

#include <atomic>

#include "sim_core/devices/shared_latest.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum::app {

struct TappedSample {
    TickSample sample;
    std::uint32_t filled = 1;  // the size is a multiple of 8
};

struct SampleTap {
    SharedLatest<TappedSample> newest;
    std::atomic<bool> ended{false};
};

}  // namespace fulcrum::app
