// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fulcrum::app {

/// Path of the program `fulcrum` that was built with the tests. One source knows it: a path in the command
/// line of a compiler keeps ccache from finding what another clone compiled.
const char* program_path();

}  // namespace fulcrum::app
