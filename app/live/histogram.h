// SPDX-License-Identifier: GPL-3.0-or-later
// A histogram of durations: its memory does not grow with the number of durations.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fulcrum::app {

/// Quantiles of many durations.
struct Durations {
    double p50_us = 0, p99_us = 0, p999_us = 0, worst_us = 0;
};

/// Counts durations of 0 .. 65 ms in steps of 1 us up to 4 ms and of 64 us above. One thread writes; any
/// thread may read at the same time and may then miss the last few counts.
class DurationHistogram {
  public:
    void add(double us) noexcept {
        if (us > worst()) worst_.store(us, std::memory_order_relaxed);
        const auto whole = static_cast<std::size_t>(us < 0 ? 0 : us);
        increase(bins_[whole < fine ? whole
                                    : (fine + (whole - fine) / 64 < bins_.size() ? fine + (whole - fine) / 64
                                                                                 : bins_.size() - 1)]);
        increase(count_);
    }
    double quantile(double share) const noexcept {
        const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(count()));
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i < bins_.size(); ++i) {
            seen += bins_[i].load(std::memory_order_relaxed);
            if (seen > wanted)
                return i < fine ? static_cast<double>(i) : static_cast<double>(fine + (i - fine) * 64);
        }
        return worst();
    }
    Durations read() const noexcept { return {quantile(0.5), quantile(0.99), quantile(0.999), worst()}; }
    double worst() const noexcept { return worst_.load(std::memory_order_relaxed); }
    std::uint32_t count() const noexcept { return count_.load(std::memory_order_relaxed); }

  private:
    static constexpr std::size_t fine = 4096;
    /// With a single writer no atomic read-modify-write is needed.
    static void increase(std::atomic<std::uint32_t>& value) noexcept {
        value.store(value.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    std::array<std::atomic<std::uint32_t>, fine + 960> bins_{};
    std::atomic<std::uint32_t> count_{0};
    std::atomic<double> worst_{0};
};

}  // namespace fulcrum::app
