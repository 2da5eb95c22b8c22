// SPDX-License-Identifier: Apache-2.0
// The hash that a replay is compared by.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// 64-bit hash of the numbers put in, in order. Doubles enter by their bits, so equality means bit for bit;
/// negative zero differs from zero on purpose. Not cryptographic.
class StateHash {
  public:
    void add(std::uint64_t word) noexcept {
        hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15ULL;
        hash_ ^= hash_ >> 29U;
    }
    void add(double value) noexcept {
        std::uint64_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        add(word);
    }
    void add(std::int64_t value) noexcept { add(static_cast<std::uint64_t>(value)); }
    void add(const Vector3& value) noexcept {
        for (int i = 0; i < 3; ++i) add(value[i]);
    }
    void add(const Quaternion& value) noexcept {
        for (int i = 0; i < 4; ++i) add(value.coeffs()[i]);
    }
    std::uint64_t value() const noexcept { return hash_; }

  private:
    std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

}  // namespace fulcrum
