// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands: the same product without a window. Each returns the exit status; bad usage and bad input
// throw (exit 2 in main).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "database/records/people.h"
#include "database/store/store.h"

namespace fulcrum::app {

int command_perform(const std::vector<std::string>& words);
int command_replay(const std::vector<std::string>& words);
int command_metrics(const std::vector<std::string>& words);
int command_check(const std::vector<std::string>& words);
int command_benchmark(const std::vector<std::string>& words);
int command_report(const std::vector<std::string>& words);
int command_db(const std::vector<std::string>& words);
int command_lab(const std::vector<std::string>& words);
int command_tissues(const std::vector<std::string>& words);
int command_demonstrate(const std::vector<std::string>& words);

/// Runs the subcommand named by the first word. Throws UsageError for an unknown one.
int run_command(const std::vector<std::string>& words);
/// True if the word names a subcommand.
bool is_command(const std::string& word);
std::string command_list();

/// One JSON document on standard output.
void print_json(const nlohmann::json& document);
/// Opens the store named by --db, or the default one; `create`: makes it when missing.
database::Store open_store(const Arguments& arguments, bool create, bool read_only = false);
/// --as LOGIN with the password from --password-file or the terminal; without it the station.
database::Session session_of(const Arguments& arguments, const database::Store& store);
/// Throws UsageError where a command needs --as.
database::Session person_session(const Arguments& arguments, const database::Store& store);
std::set<std::string> session_options();

}  // namespace fulcrum::app
