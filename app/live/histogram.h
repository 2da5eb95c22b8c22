// SPDX-License-Identifier: GPL-3.0-or-later
// Durations in fixed memory: counted, never stored, so that an hour of ticks costs what a second does.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fulcrum::app {

/// What is said of many durations.
struct Durations {
    double p50_us = 0, p99_us = 0, p999_us = 0, worst_us = 0;
};

/// Counts durations of 0 .. 65 ms in steps of 1 us up to 4 ms and 64 us beyond. One writer;
/// any thread may read meanwhile: every number is whole, only the sum may be a few counts behind.
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
    /// The one writer needs no read-modify-write.
    static void increase(std::atomic<std::uint32_t>& value) noexcept {
        value.store(value.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    std::array<std::atomic<std::uint32_t>, fine + 960> bins_{};
    std::atomic<std::uint32_t> count_{0};
    std::atomic<double> worst_{0};
};

}  // namespace fulcrum::app
