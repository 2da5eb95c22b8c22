// SPDX-License-Identifier: Apache-2.0
// docs/results/store.md adds up what all tests that kill programs have found. Each test enters its row in the
// folder that FULCRUM_KILLS_PAGE names, and the page is written from all rows that are there, whichever
// program's tests they are of. A row keeps the commit it was measured at.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim_core/lab/machine.h"

namespace fulcrum::test {

/// What a killed program was doing. The first six add up to the number that the page ends with.
enum class Killed {
    performing,
    writing,
    reviewing,
    exchanging,
    migrating,
    backing_up,
    restoring,
    first_start
};

/// What the test that calls has found; its name, and the time since it began, are entered with it.
struct KillRow {
    Killed activity = Killed::performing;
    std::size_t kills = 0;
    std::string checked;      ///< what was looked for after the kills
    std::size_t found = 0;    ///< how many of these
    std::size_t missing = 0;  ///< and how many were lost or damaged
};

/// The folder of pages; null where none is asked for, or the test has failed.
const char* kill_pages();
/// Nothing without a folder of pages.
void enter_kills(const KillRow& row, const lab::Machine& machine);
/// A value that several programs on one store gave, without a kill.
void enter_shared_store(const std::string& what, const std::string& value, const lab::Machine& machine);
/// "12 min 3 s" since the test, or between tests its suite, began.
std::string time_of_test();

}  // namespace fulcrum::test
