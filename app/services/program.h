// SPDX-License-Identifier: GPL-3.0-or-later
// All commands: those of app/cli, and those that draw reports and pictures.
#pragma once

#include "app/cli/commands.h"

namespace fulcrum::app {

const CommandTable& program_commands();
/// Parses and runs one command line in this process. Throws InputError and what the command throws.
int run_command(const std::vector<std::string>& words);

Command report_command();
Command certificate_command();
Command demonstrate_command();
Command devices_command();
std::vector<Command> schedule_commands();  ///< schedule add, list, remove, run
std::vector<Command> xapi_commands();      ///< xapi send, list

}  // namespace fulcrum::app
