// SPDX-License-Identifier: GPL-3.0-or-later
// The laboratory, fulcrum-lab: a program of its own, so that the product is built without it. Every value is
// measured when asked for; --output writes the pages of docs/results.
#pragma once

#include "app/cli/commands.h"

namespace fulcrum::app {

/// laboratory_commands() with their code. Throws std::logic_error if one has none.
CommandTable laboratory_table();

}  // namespace fulcrum::app
