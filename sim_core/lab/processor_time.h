// SPDX-License-Identifier: Apache-2.0
// Processor time of the calling thread: time used by other programs is not included.
#pragma once

#include <time.h>

namespace fulcrum::lab {

inline double processor_time_us() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

}  // namespace fulcrum::lab
