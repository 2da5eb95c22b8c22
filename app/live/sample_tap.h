// SPDX-License-Identifier: GPL-3.0-or-later
// Where an attempt leaves its newest sample and its events for a thread that is not in real time. The haptic
// thread waits for nobody.
#pragma once

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "sim_core/devices/shared_latest.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum::app {

struct TappedSample {
    TickSample sample;
    std::uint32_t filled = 1;  // the size is a multiple of 8
};

/// From the recorder thread, in the order in which they are recorded.
class TappedEvents {
  public:
    void add(const Event& event) {
        const std::lock_guard<std::mutex> lock(mutex_);
        waiting_.push_back(event);
    }
    /// Those that were added since the last call.
    std::vector<Event> take() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return std::exchange(waiting_, {});
    }

  private:
    std::mutex mutex_;  // guards waiting_
    std::vector<Event> waiting_;
};

struct SampleTap {
    SharedLatest<TappedSample> newest;  ///< by the haptic thread
    TappedEvents events;
    std::atomic<bool> part{false};   ///< events are missing; set before `ended`
    std::atomic<bool> ended{false};  ///< set after the last sample and the last event
};

}  // namespace fulcrum::app
