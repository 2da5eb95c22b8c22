// SPDX-License-Identifier: GPL-3.0-or-later
// Passwords from the terminal or a file.
#pragma once

#include <string>

namespace fulcrum::app {

/// Asks at the terminal without showing what is typed. A signal that ends or stops the program restores the
/// terminal first. Throws UsageError where there is no terminal or nothing was typed.
std::string ask_password(const std::string& login);

/// The first line of a file, which may end with CR and LF. Throws InputError where there is none.
std::string read_password(const std::string& path);

}  // namespace fulcrum::app
