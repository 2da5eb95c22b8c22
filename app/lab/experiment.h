// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of Pan et al. 2011 as pages: runs a file of assets/experiments without a window and draws
// its panels side by side.
#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::app {

/// Files of assets/experiments, sorted.
std::vector<std::string> experiment_files();
/// Runs one file; the page (ID.md) contains its picture (ID.png). Needs a QGuiApplication on a platform with
/// OpenGL. Throws InputError.
lab::ResultPage experiment_page(const std::string& file);
int run_experiments(const Arguments& arguments);  ///< lab experiment

}  // namespace fulcrum::app
