// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that need no window, and their shared functions. Each file contains a command's row of the
// table and its code.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "database/records/people.h"
#include "database/store/store.h"

namespace fulcrum::app {

/// All commands of app/cli.
std::vector<Command> headless_commands();

Command perform_command();
Command replay_command();
Command metrics_command();
Command import_command();
Command check_command();
Command benchmark_command();
Command tissues_command();
Command forms_command();
Command research_command();
std::vector<Command> asset_commands();        ///< assets ...
std::vector<Command> curricula_commands();    ///< curriculum list, move
std::vector<Command> roster_commands();       ///< people import, cohort import
std::vector<Command> merge_commands();        ///< people merge, unmerge, login
Command erase_command();                      ///< people erase
std::vector<Command> person_data_commands();  ///< people export, retention
std::vector<Command> statistics_commands();   ///< curriculum ..., benchmark statistics
std::vector<Command> store_commands();        ///< db create, check, audit, score, recompute
std::vector<Command> care_commands();         ///< db backup, restore, migrate
std::vector<Command> key_commands();          ///< db keys, db rotate-key
std::vector<Command> server_commands();       ///< sync, server ...
std::vector<Command> igtl_commands();         ///< igtl serve, record
std::vector<Command> laboratory_commands();   ///< lab ...: without code, run by the program fulcrum-lab

Option json_option();
Option store_option();                  ///< --db
std::vector<Option> session_options();  ///< --db, --as, --role, --password-file, --json
Option seed_option();
Option variant_option();
inline constexpr int default_fidelity_seeds =
    40;                                     ///< of lab fidelity, for each task: under an hour on two cores
std::vector<std::string> fidelity_names();  ///< choices of --fidelity
std::vector<std::string> device_class_names();  ///< choices of --device-class
/// `more`, then `rest`.
std::vector<Option> joined(std::vector<Option> more, const std::vector<Option>& rest);

/// What an error says, in one line and in the language in use.
std::string line_of(const std::exception& error);
std::string line_of(const Sentence& sentence);
/// A line on standard error in the language in use; `line`: marked for "commands".
void print_note(const Sentence& line);
/// The note on a gap between samples, with its times (s).
void print_gap(const std::string& from, const std::string& to);
/// One JSON document on standard output.
void print_json(const nlohmann::json& document);
std::string store_path(const Arguments& arguments);
/// Opens the store named by --db, or the default one; `create`: creates a missing store.
database::Store open_store(const Arguments& arguments, bool create, bool read_only = false);
/// --as LOGIN with the password from --password-file or the terminal; without it the station. At a programme
/// server the person whose account the address names.
database::Session session_of(const Arguments& arguments, const database::Store& store);
/// Throws UsageError without --as, which a programme server does not need.
database::Session person_session(const Arguments& arguments, const database::Store& store);
/// The id of the person that --person names; empty without it. Throws InputError.
std::string person_named(const Arguments& arguments, const database::Store& store,
                         const database::Session& session);

/// Null for an empty text or optional.
nlohmann::json or_null(const std::string& text);
template <typename T>
nlohmann::json or_null(const std::optional<T>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace fulcrum::app
