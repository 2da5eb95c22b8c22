// SPDX-License-Identifier: Apache-2.0
// Ends of cuts in a sheet, where fibres part under tension (FibreSpec). A part of the sheet's state.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/state_hash.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

struct SheetFibres {
    /// Tissue just beyond an end: root and place in it outlast what is cut around them.
    struct Tip {
        std::int32_t root = -1;  ///< -1: no end is here
        Vector3 barycentric = Vector3::Zero();
        double direction = 1;  ///< along the marked line, +1 or -1
        double gathered = 0;   ///< m that fibres have given way since the last of them parted
    };
    static constexpr std::int32_t capacity = 16;  // the oldest end is forgotten for the next
    std::array<Tip, capacity> tips;
    std::int32_t next = 0, looked = 0;
    std::array<std::int32_t, hand_count> back = {-1, -1}, front = {-1, -1};  ///< of each hand's latest stroke

    std::int32_t add(const Tip& tip) noexcept {
        const std::int32_t place = next;
        tips[static_cast<std::size_t>(place)] = tip;
        next = (next + 1) % capacity;
        return place;
    }
    void hash(StateHash& hash) const noexcept {
        for (const Tip& tip : tips) {
            hash.add(static_cast<std::int64_t>(tip.root));
            hash.add(tip.barycentric);
            hash.add(tip.direction);
            hash.add(tip.gathered);
        }
        for (const std::int32_t n : {next, looked, back[0], back[1], front[0], front[1]})
            hash.add(static_cast<std::int64_t>(n));
    }
};

}  // namespace fulcrum
