// SPDX-License-Identifier: Apache-2.0
// Clocks of the system that a test sets, for what happens when a person sets the time or a machine sleeps.
#pragma once

#include <time.h>

namespace fulcrum::test {

/// Sanitizers own this entry point themselves: under them no clock is set.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool clocks_can_be_set = false;
#else
constexpr bool clocks_can_be_set = true;
#endif

/// As long as it exists, all threads of this program and its libraries read `clock` that many seconds later
/// than it is; what the kernel waits for by that clock is not moved. Several add up.
class ClockAhead {
  public:
    ClockAhead(clockid_t clock, int seconds);
    ~ClockAhead();
    ClockAhead(const ClockAhead&) = delete;
    ClockAhead& operator=(const ClockAhead&) = delete;

  private:
    clockid_t clock_;
    int seconds_;
};

}  // namespace fulcrum::test
