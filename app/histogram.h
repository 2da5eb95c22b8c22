// SPDX-License-Identifier: GPL-3.0-or-later
// Durations in fixed memory: counted, never stored, so that an hour of ticks costs what a second does.
#pragma once

#include <array>
#include <cstdint>

namespace fulcrum::app {

/// Counts durations of 0 .. 65 ms in steps of 1 us up to 4 ms and 64 us beyond. One writer; read after it has stopped.
class DurationHistogram {
  public:
    void add(double us) noexcept {
        if (us > worst_) worst_ = us;
        ++count_;
        const auto whole = static_cast<std::size_t>(us < 0 ? 0 : us);
        ++bins_[whole < fine ? whole : (fine + (whole - fine) / 64 < bins_.size() ? fine + (whole - fine) / 64 : bins_.size() - 1)];
    }
    double quantile(double share) const noexcept {
        const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(count_));
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i < bins_.size(); ++i) {
            seen += bins_[i];
            if (seen > wanted) return i < fine ? static_cast<double>(i) : static_cast<double>(fine + (i - fine) * 64);
        }
        return worst_;
    }
    double worst() const noexcept { return worst_; }
    std::uint64_t count() const noexcept { return count_; }

  private:
    static constexpr std::size_t fine = 4096;
    std::array<std::uint32_t, fine + 960> bins_{};
    std::uint64_t count_ = 0;
    double worst_ = 0;
};

}  // namespace fulcrum::app
