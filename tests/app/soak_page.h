// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of soak_test.cpp: runs of one process next to each other, alone and with all cores busy, where
// the program reads the hands itself (in process) and through the device process.
#pragma once

#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::app::program_test {

struct SoakRun {
    bool through_daemon = false, loaded = false;
    std::vector<std::vector<std::string>> rows;  ///< what, value
};

/// Names of two rows: ticks late by the program, and those of them at which the host took the processor.
inline constexpr const char* soak_missed = "missed by the program";
inline constexpr const char* soak_missed_then = "of these while the host took the processor (steal time)";

/// A column for each run; what a run does not have is a dash.
lab::ResultTable soak_table(const std::string& name, const std::vector<SoakRun>& runs);
/// Of all runs: those in process alone on the page soak, all of them on the page soak_daemon once a device
/// process was among them.
std::vector<lab::ResultPage> soak_pages(const std::vector<SoakRun>& runs, int seconds);

}  // namespace fulcrum::app::program_test
