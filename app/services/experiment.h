// SPDX-License-Identifier: GPL-3.0-or-later
// The experiments of Pan et al. 2011 as pages: each file of assets/experiments run without a window, its
// panels drawn and put side by side.
#pragma once

#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::app {

/// Files of assets/experiments, sorted.
std::vector<std::string> experiment_files();
/// Runs one file and lays out its picture (ID.png) and page (ID.md). Needs a QGuiApplication whose platform
/// offers OpenGL. Throws InputError.
lab::ResultPage experiment_page(const std::string& file);

}  // namespace fulcrum::app
