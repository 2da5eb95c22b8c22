// SPDX-License-Identifier: Apache-2.0
#include "tests/support/wait_count.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <ctime>

namespace {
std::atomic<std::uint64_t> counted{0};
}

namespace fulcrum::test {
std::uint64_t wait_count() {
    return counted.load(std::memory_order_relaxed);
}
}  // namespace fulcrum::test

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

/// The C library's function of this name that the one here replaces.
template <typename Function>
Function* behind(std::atomic<Function*>& kept, const char* name) {
    Function* function = kept.load(std::memory_order_relaxed);
    if (function == nullptr) {
        function = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
        kept.store(function, std::memory_order_relaxed);
    }
    return function;
}

}  // namespace

// Calls inside the C library do not pass through here; calls of a program and its C++ library do.
#define FULCRUM_COUNTED(result, name, parameters, arguments, exceptions) \
    extern "C" result name parameters exceptions {                       \
        static std::atomic<result(*) parameters> kept;                   \
        counted.fetch_add(1, std::memory_order_relaxed);                 \
        return behind(kept, #name) arguments;                            \
    }

FULCRUM_COUNTED(int, pthread_mutex_lock, (pthread_mutex_t * lock), (lock), noexcept)
FULCRUM_COUNTED(int, pthread_mutex_trylock, (pthread_mutex_t * lock), (lock), noexcept)
FULCRUM_COUNTED(int, pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock), noexcept)
FULCRUM_COUNTED(int, pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock), noexcept)
FULCRUM_COUNTED(int, pthread_spin_lock, (pthread_spinlock_t * lock), (lock), noexcept)
FULCRUM_COUNTED(int, pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t* lock),
                (condition, lock), )
FULCRUM_COUNTED(int, pthread_cond_signal, (pthread_cond_t * condition), (condition), noexcept)
FULCRUM_COUNTED(int, pthread_cond_broadcast, (pthread_cond_t * condition), (condition), noexcept)
FULCRUM_COUNTED(int, sem_wait, (sem_t * semaphore), (semaphore), )
FULCRUM_COUNTED(int, sched_yield, (), (), noexcept)
FULCRUM_COUNTED(int, nanosleep, (const timespec* time, timespec* rest), (time, rest), )
FULCRUM_COUNTED(int, clock_nanosleep, (clockid_t clock, int flags, const timespec* time, timespec* rest),
                (clock, flags, time, rest), )
FULCRUM_COUNTED(ssize_t, read, (int file, void* bytes, std::size_t count), (file, bytes, count), )
FULCRUM_COUNTED(ssize_t, write, (int file, const void* bytes, std::size_t count), (file, bytes, count), )
FULCRUM_COUNTED(FILE*, fopen, (const char* path, const char* mode), (path, mode), )
FULCRUM_COUNTED(FILE*, fopen64, (const char* path, const char* mode), (path, mode), )
FULCRUM_COUNTED(std::size_t, fwrite, (const void* bytes, std::size_t size, std::size_t count, FILE* file),
                (bytes, size, count, file), )
FULCRUM_COUNTED(int, fflush, (FILE * file), (file), )

#endif
