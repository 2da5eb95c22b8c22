// SPDX-License-Identifier: GPL-3.0-or-later
// Shared functions of the laboratory's commands: pages and their folder.
#pragma once

#include "app/cli/commands.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::app {

/// Creates the folder of --output. Call it after all checks of the command line and before the work, so that
/// a wrong command leaves no folder.
void make_output(const Arguments& arguments);
/// Writes the page to --output, or prints it; with --json prints the document. Returns 0.
int deliver(const Arguments& arguments, const lab::ResultPage& page, nlohmann::json document);
int run_fidelity(const Arguments& arguments);  ///< lab fidelity

}  // namespace fulcrum::app
