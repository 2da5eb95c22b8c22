// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the demonstration programme that *Look around* opens: simulates the plan day by day into a store
// whose clock is the plan's, and packs it. It can be stopped, also by a kill, and resumes with the day that
// it was at.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/cli/arguments.h"
#include "app/lab/demonstration_plan.h"

namespace fulcrum::app {

struct DemonstrationRequest {
    std::string output;  ///< the packed store
    DemoSize size = {};
    /// After each attempt and about ten times a second in it; false stops. May be empty.
    std::function<bool(double done, const std::string& line)> progress = {};
};

struct DemonstrationResult {
    bool complete = false;  ///< false: stopped; what was simulated is kept next to the output
    int attempts = 0, traces = 0;
    std::uint64_t bytes = 0, packed_bytes = 0;
};

/// What is not yet finished is in the folder OUTPUT.work. Throws InputError (the folder belongs to another
/// plan, or another program works on it), StoreError, std::system_error.
DemonstrationResult build_demonstration(const DemonstrationRequest& request);

int run_demonstration(const Arguments& arguments);  ///< lab demonstration

}  // namespace fulcrum::app
