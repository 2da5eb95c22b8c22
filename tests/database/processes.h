// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that work on one store at the same time, and are killed: this test program starts itself with
// --child NAME. What a child did is counted in shared memory, which outlives it.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace fulcrum::database::test {

struct ChildCounters {
    std::atomic<std::uint32_t> begun{0};         ///< children that are about to do what they were started for
    std::atomic<std::uint32_t> acknowledged{0};  ///< scores that the store reported as written
    std::atomic<std::uint32_t> refused{0};       ///< StoreError locked
    std::atomic<std::uint32_t> failed{0};        ///< any other error
    std::atomic<std::uint32_t> longest_ms{0};    ///< of one operation
};

/// Maps the counters of a folder, made on first use. Ends the program if that fails.
ChildCounters& counters_in(const std::string& folder);
/// Starts a child on FOLDER/fulcrum.db. `number` means what the child makes of it.
pid_t start_child(const std::string& name, const std::string& folder, int number = 0);
/// Exit status, or -1 if it was killed.
int wait_for_child(pid_t child);
/// Ends the child wherever it is; false if it had already ended.
bool kill_child(pid_t child);
/// Whether it is still running; fails nothing.
bool is_running(pid_t child);
/// What main() calls for --child NAME FOLDER NUMBER.
int run_child(const std::string& name, const std::string& folder, int number);

}  // namespace fulcrum::database::test
