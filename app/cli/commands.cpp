// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <map>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using Command = int (*)(const std::vector<std::string>&);

const std::map<std::string, Command>& commands() {
    static const std::map<std::string, Command> table = {
        {"perform", command_perform},
        {"replay", command_replay},
        {"metrics", command_metrics},
        {"check", command_check},
        {"benchmark", command_benchmark},
        {"report", command_report},
        {"db", command_db},
        {"lab", command_lab},
        {"demonstrate", command_demonstrate},
        {"tissues", command_tissues},
    };
    return table;
}

/// Reads a line from the terminal without showing it.
std::string ask_password(const std::string& login) {
    if (isatty(STDIN_FILENO) == 0)
        throw UsageError("command line: --as: no terminal to ask for a password; give --password-file FILE");
    std::cerr << "password of " << login << ": " << std::flush;
    termios before{};
    tcgetattr(STDIN_FILENO, &before);
    termios silent = before;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &silent);
    std::string line;
    std::getline(std::cin, line);
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
    std::cerr << '\n';
    return line;
}

std::string read_password(const std::string& path) {
    std::ifstream file(path);
    if (!file)
        throw InputError(path, "", "cannot be read", "name a file that holds the password on its first line");
    std::string line;
    std::getline(file, line);
    return line;
}

}  // namespace

bool is_command(const std::string& word) {
    return commands().count(word) != 0;
}

std::string command_list() {
    std::string list;
    for (const auto& [name, command] : commands()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

int run_command(const std::vector<std::string>& words) {
    const auto found = commands().find(words.at(0));
    if (found == commands().end())
        throw UsageError("command line: " + words[0] + ": no such command; use one of " + command_list());
    return found->second({words.begin() + 1, words.end()});
}

void print_json(const nlohmann::json& document) {
    std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

database::Store open_store(const Arguments& arguments, bool create, bool read_only) {
    const std::string path = arguments.value_or("--db", database::Store::default_path());
    if (create) return database::Store::open_or_create(path);
    database::StoreOptions options;
    options.read_only = read_only;
    return database::Store::open(path, options);
}

std::set<std::string> session_options() {
    return {"--db", "--as", "--password-file", "--role"};
}

database::Session session_of(const Arguments& arguments, const database::Store& store) {
    const auto login = arguments.value("--as");
    if (!login) return store.station_session();
    std::optional<database::Role> role;
    if (const auto name = arguments.value("--role")) {
        database::Role parsed{};
        if (!database::parse_role(*name, parsed))
            throw UsageError("command line: --role: no role '" + *name +
                             "'; use trainee, educator, director or administrator");
        role = parsed;
    }
    const auto file = arguments.value("--password-file");
    return database::People(store).sign_in(*login, file ? read_password(*file) : ask_password(*login), role);
}

database::Session person_session(const Arguments& arguments, const database::Store& store) {
    if (!arguments.has("--as"))
        throw UsageError(
            "command line: --as: this reads people's data; say who asks with --as LOGIN (and --password-file "
            "FILE)");
    return session_of(arguments, store);
}

}  // namespace fulcrum::app
