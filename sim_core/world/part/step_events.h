// SPDX-License-Identifier: Apache-2.0
// What a part of the world did to tissue in a step, in fixed room: what does not fit is dropped.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "sim_core/telemetry/event.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

template <int Capacity>
class StepEvents {
  public:
    static constexpr int capacity = Capacity;

    void clear() noexcept { count_ = 0; }
    /// hand: -1 where no hand did it. detail: rounded, held within the record's 32 bits.
    void add(std::uint32_t tick, EventKind kind, int hand, int tissue, double value, double detail) noexcept {
        if (count_ == Capacity) return;
        Event& event = events_[static_cast<std::size_t>(count_++)];
        event = Event();
        event.tick = tick;
        event.kind = kind;
        event.hand = hand < 0 ? std::uint8_t{255} : static_cast<std::uint8_t>(hand);
        event.tissue = static_cast<std::int8_t>(tissue);
        event.value = static_cast<float>(value);
        event.detail = static_cast<std::int32_t>(std::lround(std::clamp(detail, -2.0e9, 2.0e9)));
    }
    const Event* data() const noexcept { return events_.data(); }
    int count() const noexcept { return count_; }

    /// Room for these in addition to what the others have; then a step's.
    static void size(WorldSnapshot& snapshot) { snapshot.events.resize(snapshot.events.size() + Capacity); }
    void append_to(WorldSnapshot& snapshot) const noexcept {
        std::copy_n(events_.begin(), count_, snapshot.events.begin() + snapshot.event_count);
        snapshot.event_count += count_;
    }

  private:
    std::array<Event, Capacity> events_;
    int count_ = 0;
};

}  // namespace fulcrum
