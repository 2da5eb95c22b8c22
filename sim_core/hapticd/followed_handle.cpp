// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/followed_handle.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::hapticd {
namespace {

constexpr double whole_turn = 2 * 3.14159265358979323846;
constexpr std::int64_t of_ms = 1'000'000;
constexpr std::int64_t least_span = 2 * of_ms, largest_span = 60 * of_ms;
constexpr std::int64_t least_silence = 100 * of_ms, largest_silence = 250 * of_ms;

}  // namespace

void FollowedHandle::take(TrackedHandle next, std::int64_t now, std::int64_t spacing) noexcept {
    next.roll += whole_turn * std::round((to_.roll - next.roll) / whole_turn);
    const bool first = arrived_ == 0 || now - arrived_ > largest_silence;
    to_ = next;
    if (!first && now == arrived_) return;  // two that arrived together: the newer one is reached
    const std::int64_t since = spacing > 0 ? spacing : now - arrived_;
    if (first)
        interval_ = 0;
    else
        interval_ = interval_ == 0 ? since : (3 * interval_ + since) / 4;
    from_ = first ? next : now_;
    if (first) now_ = next;
    arrived_ = now;
}

const TrackedHandle& FollowedHandle::at(std::int64_t now) noexcept {
    const std::int64_t span = std::clamp(interval_, least_span, largest_span);
    const double share = std::min(static_cast<double>(now - arrived_) / static_cast<double>(span), 1.0);
    now_.position = from_.position + share * (to_.position - from_.position);
    now_.roll = from_.roll + share * (to_.roll - from_.roll);
    return now_;
}

bool FollowedHandle::fresh(std::int64_t now) const noexcept {
    return arrived_ != 0 && now - arrived_ <= std::clamp(3 * interval_, least_silence, largest_silence);
}

}  // namespace fulcrum::hapticd
