// SPDX-License-Identifier: Apache-2.0
#include "tests/support/clock_ahead.h"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace {

/// s, by the clock's number; the clocks of a process or thread have negative ones.
std::array<std::atomic<int>, 16> seconds_ahead{};

}  // namespace

namespace fulcrum::test {

ClockAhead::ClockAhead(clockid_t clock, int seconds) : clock_(clock), seconds_(seconds) {
    seconds_ahead.at(static_cast<std::size_t>(clock_)).fetch_add(seconds_);
}

ClockAhead::~ClockAhead() {
    seconds_ahead[static_cast<std::size_t>(clock_)].fetch_sub(seconds_);
}

}  // namespace fulcrum::test

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// Calls inside the C library do not pass through here; calls of a program and its libraries do.
extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
    using Function = int(clockid_t, timespec*);
    static std::atomic<Function*> kept{nullptr};
    Function* function = kept.load(std::memory_order_relaxed);
    if (function == nullptr) {
        function = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, "clock_gettime"));
        kept.store(function, std::memory_order_relaxed);
    }
    const int result = function(clock, time);
    if (result == 0 && clock >= 0 && clock < static_cast<clockid_t>(seconds_ahead.size()))
        time->tv_sec += seconds_ahead[static_cast<std::size_t>(clock)].load(std::memory_order_relaxed);
    return result;
}

#endif
