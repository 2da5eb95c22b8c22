// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same on every machine: xoshiro256** (Blackman and Vigna 2018) seeded with
// SplitMix64. The distributions of the standard library are not used, because their results differ between
// implementations.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim_core/numerics/functions.h"

namespace fulcrum {

/// One stream of random numbers. Plain copyable state, no allocation, never throws. Do not share one between
/// threads.
class Random {
  public:
    /// Streams of one seed with different `stream` numbers are independent for all practical purposes.
    explicit Random(std::uint64_t seed = 0, std::uint64_t stream = 0) noexcept {
        std::uint64_t mix = seed ^ (stream * 0xd1342543de82ef95ULL + 0x2545f4914f6cdd1dULL);
        for (auto& word : state_) {
            mix += 0x9e3779b97f4a7c15ULL;
            std::uint64_t z = mix;
            z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
            z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
            word = z ^ (z >> 31U);
        }
    }

    /// 64 random bits.
    std::uint64_t bits() noexcept {
        const std::uint64_t result = rotate(state_[1] * 5U, 7) * 9U;
        const std::uint64_t t = state_[1] << 17U;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotate(state_[3], 45);
        return result;
    }

    /// Uniform in [0, 1), 53 bits.
    double uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
    /// Uniform in [low, high).
    double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }
    /// Uniform in 0 .. count-1; count >= 1. Bias below 2^-32 for count < 2^31.
    std::uint32_t below(std::uint32_t count) noexcept {
        return static_cast<std::uint32_t>(((bits() >> 32U) * static_cast<std::uint64_t>(count)) >> 32U);
    }
    /// Normal, mean 0, standard deviation 1 (Marsaglia's polar method; both values of a pair are used).
    double normal() noexcept {
        if (has_spare_) {
            has_spare_ = false;
            return spare_;
        }
        double u = 0, v = 0, s = 0;
        do {
            u = uniform(-1, 1);
            v = uniform(-1, 1);
            s = u * u + v * v;
        } while (s >= 1 || s <= 0);
        const double scale = std::sqrt(-2 * math::log(s) / s);
        spare_ = v * scale;
        has_spare_ = true;
        return u * scale;
    }
    /// Normal with mean and standard deviation.
    double normal(double mean, double deviation) noexcept { return mean + deviation * normal(); }

  private:
    static std::uint64_t rotate(std::uint64_t x, int k) noexcept { return (x << k) | (x >> (64 - k)); }
    std::uint64_t state_[4] = {};
    double spare_ = 0;
    bool has_spare_ = false;
};

}  // namespace fulcrum
