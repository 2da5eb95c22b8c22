// SPDX-License-Identifier: GPL-3.0-or-later
// `fulcrum devices --calibrate DEVICE`: a guided calibration in a terminal.
#pragma once

#include <string>

#include "app/cli/arguments.h"

namespace fulcrum::app {

/// Prints each step and waits for Enter, or for "s" and Enter where a step may be left out. Returns the exit
/// status: 1 where it was not completed.
int calibrate_device(const Arguments& arguments, const std::string& device);

}  // namespace fulcrum::app
