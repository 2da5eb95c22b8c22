// SPDX-License-Identifier: GPL-3.0-or-later
// System services for real-time threads: monotonic time, sleeping until a deadline, priority, a
// signal.
#pragma once

#include <pthread.h>
#include <semaphore.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace fulcrum::app {

inline std::int64_t now_ns() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

inline void sleep_until(std::int64_t deadline_ns) {
    timespec time{};
    time.tv_sec = deadline_ns / 1000000000LL;
    time.tv_nsec = deadline_ns % 1000000000LL;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
    }
}

/// False if the system refuses; the thread then keeps its priority.
inline bool raise_priority(int priority) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
}

/// Of the calling thread, for work that may take its time. SCHED_IDLE would be a fifth of this on a machine
/// that is busy, and its owner may have to wait for it.
inline void take_lowest_priority() {
    const sched_param parameter{};
    pthread_setschedparam(pthread_self(), SCHED_BATCH, &parameter);
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 19);
}

/// Counting signal between threads; post() never blocks.
class Signal {
  public:
    Signal() { sem_init(&semaphore_, 0, 0); }
    ~Signal() { sem_destroy(&semaphore_); }
    Signal(const Signal&) = delete;
    Signal& operator=(const Signal&) = delete;
    void post() noexcept { sem_post(&semaphore_); }
    void wait() noexcept {
        while (sem_wait(&semaphore_) != 0 && errno == EINTR) {
        }
    }
    /// False on timeout, which no change of the system's time moves.
    bool wait_for_ms(int milliseconds) noexcept {
        timespec time{};
        clock_gettime(CLOCK_MONOTONIC, &time);
        time.tv_nsec += milliseconds * 1000000L;
        time.tv_sec += time.tv_nsec / 1000000000L;
        time.tv_nsec %= 1000000000L;
        int result = 0;
        while ((result = sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &time)) != 0 && errno == EINTR) {
        }
        return result == 0;
    }

  private:
    sem_t semaphore_;
};

}  // namespace fulcrum::app
