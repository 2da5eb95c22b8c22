// SPDX-License-Identifier: Apache-2.0
// Counts calls that may make the calling thread wait: locks, condition variables, sleeps, files and sockets.
// Together with the allocation count (allocation_count.h) this makes "no lock, no allocation, no I/O in the
// loop" a test.
#pragma once

#include <cstdint>

namespace fulcrum::test {

/// Sanitizers own these entry points themselves: under them nothing is counted.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool waits_are_counted = false;
#else
constexpr bool waits_are_counted = true;
#endif

/// Calls so far, on all threads, of the C library's locking, waiting and input/output functions; C++'s
/// mutexes and streams end in them.
std::uint64_t wait_count();

}  // namespace fulcrum::test
