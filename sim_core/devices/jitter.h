// SPDX-License-Identifier: Apache-2.0
// How evenly something comes that should come once a period.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fulcrum {

/// Standard deviation of the time between two of them from the period, over about the newest thousand.
class Jitter {
  public:
    explicit Jitter(std::int64_t period_ns) : period_(period_ns) {}
    void came(std::int64_t now_ns) noexcept {
        if (last_ != 0) {
            constexpr double remembered = 1000;
            count_ = std::min(count_ + 1, remembered);
            const double off = 1e-9 * static_cast<double>(now_ns - last_ - period_);
            variance_ += (off * off - variance_) / count_;
        }
        last_ = now_ns;
    }
    double seconds() const noexcept { return std::sqrt(variance_); }

  private:
    std::int64_t period_, last_ = 0;
    double count_ = 0, variance_ = 0;
};

}  // namespace fulcrum
