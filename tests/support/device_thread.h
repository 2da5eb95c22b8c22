// SPDX-License-Identifier: Apache-2.0
// A device has a processor of its own: the thread that plays one does not wait for the window that draws on
// the same cores.
#pragma once

#include <pthread.h>
#include <sched.h>

namespace fulcrum::test {

/// The calling thread comes before ordinary ones, as far as the machine allows it.
inline void work_as_a_device() {
    sched_param parameter{};
    parameter.sched_priority = 20;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
}

}  // namespace fulcrum::test
