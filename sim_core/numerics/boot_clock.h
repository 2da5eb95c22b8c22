// SPDX-License-Identifier: Apache-2.0
// Time that nobody can set and that passes while the machine sleeps.
#pragma once

#include <time.h>

#include <cstdint>

namespace fulcrum {

/// ns since the machine was started, by CLOCK_BOOTTIME. CLOCK_MONOTONIC does not count sleep.
inline std::int64_t boot_ns() noexcept {
    timespec time{};
    clock_gettime(CLOCK_BOOTTIME, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

}  // namespace fulcrum
