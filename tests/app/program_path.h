// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fulcrum::app {

/// Path of the program `fulcrum` that was built with the tests (tests/support/built.h).
const char* program_path();

}  // namespace fulcrum::app
