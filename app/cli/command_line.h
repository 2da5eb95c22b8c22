// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs fulcrum and fulcrum-lab do alike with a command line.
#pragma once

#include <QCoreApplication>
#include <functional>
#include <memory>

#include "app/cli/command.h"
#include "ui/language/language.h"

namespace fulcrum::app {

/// A closed standard stream must not become the descriptor of the next file that is opened, such as the
/// store. Call it first.
void keep_standard_streams();
/// After QCoreApplication has set the user's locale: numbers are read and written with a decimal point, and
/// file names are UTF-8, in every language.
void set_plain_formats();
/// Shows texts in the language that FULCRUM_LANGUAGE names, in `otherwise` if it is not set. Throws
/// InputError for a word that names none.
void use_language_or(ui::Language otherwise);
/// The action's exit status. What it throws is printed as one line: 2 for bad input, else 1.
int guarded(const std::function<int()>& action);
/// Makes the application with which a command draws.
using MakeApplication = std::function<std::unique_ptr<QCoreApplication>(int& argc, char** argv)>;
/// Parses the command line, which has at least one word, and runs its command; the exit status.
int run_command_line(const CommandTable& table, int& argc, char** argv, const MakeApplication& to_draw);

}  // namespace fulcrum::app
