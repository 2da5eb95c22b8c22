// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of one replay, in order: packed engine states with their place in the record.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "assessment/attempt/replay_cursor.h"

namespace fulcrum::app {

/// Bounded: above most_bytes every second frame is dropped and the distance doubles, so that seeks take
/// longer and memory does not grow with the attempt. add() and put() from one thread, the rest from any.
class FrameStore {
  public:
    static constexpr std::size_t most_bytes = 192U << 20U;
    /// s that simulating from one frame to the next may take on this machine: half of the 0.2 s of a seek.
    static constexpr double longest_gap_s = 0.1;

    struct Frame {
        std::uint32_t tick = 0;
        std::shared_ptr<const std::vector<std::uint8_t>> packed;
    };

    explicit FrameStore(std::size_t most = most_bytes) : most_(most) {}

    /// Whether the cursor, which has run for `run_s` since the last frame, shall leave one here.
    bool wants(double run_s) const { return run_s >= gap_s_; }
    void add(ReplayCursor& cursor);
    /// The last frame at or before a tick; without `packed` where there is none.
    Frame before(std::uint32_t tick) const;
    static void put(const Frame& frame, ReplayCursor& cursor);

    std::size_t bytes() const;
    std::size_t count() const;
    /// Of one frame, uncompressed; add()'s thread.
    std::size_t plain_bytes() const { return plain_.size(); }

  private:
    const std::size_t most_;
    double gap_s_ = longest_gap_s;  ///< add()'s thread
    std::vector<std::uint8_t> plain_;
    mutable std::mutex mutex_;  ///< guards what follows
    std::vector<Frame> frames_;
    std::size_t bytes_ = 0;
};

}  // namespace fulcrum::app
