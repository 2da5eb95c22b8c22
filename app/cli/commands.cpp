// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"

#include <QCoreApplication>
#include <iostream>

#include "app/cli/terminal.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum::app {

std::vector<Command> headless_commands() {
    std::vector<Command> commands = {
        perform_command(),   replay_command(),  metrics_command(), import_command(),   check_command(),
        benchmark_command(), tissues_command(), forms_command(),   research_command(), erase_command()};
    for (const Command& command : asset_commands()) commands.push_back(command);
    for (const Command& command : curricula_commands()) commands.push_back(command);
    for (const Command& command : roster_commands()) commands.push_back(command);
    for (const Command& command : merge_commands()) commands.push_back(command);
    for (const Command& command : statistics_commands()) commands.push_back(command);
    for (const Command& command : store_commands()) commands.push_back(command);
    for (const Command& command : care_commands()) commands.push_back(command);
    for (const Command& command : person_data_commands()) commands.push_back(command);
    for (const Command& command : key_commands()) commands.push_back(command);
    for (const Command& command : server_commands()) commands.push_back(command);
    for (const Command& command : igtl_commands()) commands.push_back(command);
    for (const Command& command : laboratory_commands()) commands.push_back(command);
    return commands;
}

Option json_option() {
    return {"--json", "", QT_TRANSLATE_NOOP("commands", "Print one JSON document on standard output.")};
}

Option store_option() {
    return {"--db", "FILE",
            QT_TRANSLATE_NOOP("commands",
                              "The store to use; for reports also the address of a programme server, "
                              "postgresql://ACCOUNT@HOST:PORT/DATABASE."),
            QT_TRANSLATE_NOOP("commands", "the store of this user account")};
}

Option variant_option() {
    return {"--variant", "ID", QT_TRANSLATE_NOOP("commands", "The variant of the task."), standard_variant};
}

Option seed_option() {
    return {"--seed", "N", QT_TRANSLATE_NOOP("commands", "The seed, from 0 to 4000000000."), "1"};
}

std::vector<Option> session_options() {
    return {store_option(),
            {"--as", "LOGIN", QT_TRANSLATE_NOOP("commands", "Sign in as this person."),
             QT_TRANSLATE_NOOP("commands", "the station, which may see synthetic people only")},
            {"--role",
             "ROLE",
             QT_TRANSLATE_NOOP("commands", "The role to act in."),
             QT_TRANSLATE_NOOP("commands", "the person's first role"),
             {"trainee", "educator", "director", "administrator"}},
            {"--password-file", "FILE",
             QT_TRANSLATE_NOOP("commands", "A file with the password on its first line."),
             QT_TRANSLATE_NOOP("commands", "ask at the terminal")},
            json_option()};
}

std::vector<Option> joined(std::vector<Option> more, const std::vector<Option>& rest) {
    more.insert(more.end(), rest.begin(), rest.end());
    return more;
}

std::string line_of(const std::exception& error) {
    return line_of(sentence_of(error));
}

std::string line_of(const Sentence& sentence) {
    std::string line = sentence.words([](const char* context, const char* source) {
        const std::string words = QCoreApplication::translate(context, source).toStdString();
        return words == source ? help_words(context, source) : words;  // a usage with its placeholders
    });
    for (char& c : line)
        if (c == '\n' || c == '\r') c = ' ';
    return line;
}

void print_note(const Sentence& line) {
    std::cerr << line.words(help_words) << '\n';
}

void print_gap(const std::string& from, const std::string& to) {
    print_note({QT_TRANSLATE_NOOP("commands",
                                  "note: no samples from %1 s to %2 s; nothing is measured across this gap"),
                from, to});
}

void print_json(const nlohmann::json& document) {
    std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

std::string store_path(const Arguments& arguments) {
    return arguments.value_or("--db", database::Store::default_path());
}

database::Store open_store(const Arguments& arguments, bool create, bool read_only) {
    const std::string path = store_path(arguments);
    if (create) return database::Store::open_or_create(path);
    database::StoreOptions options;
    options.read_only = read_only;
    return database::Store::open(path, options);
}

namespace {

/// The server has signed in the person whose account the address names.
database::Session server_session(const Arguments& arguments, const database::Store& store,
                                 std::optional<database::Role> role) {
    if (arguments.has("--password-file"))
        throw UsageError("--password-file",
                         QT_TRANSLATE_NOOP("errors", "has no meaning with a programme server"),
                         QT_TRANSLATE_NOOP("errors",
                                           "put the password into ~/.pgpass "
                                           "(HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or name such a "
                                           "file in PGPASSFILE"));
    database::Session session = database::People(store).account_session(role);
    const auto login = arguments.value("--as");
    if (login && QString::fromStdString(*login).compare(QString::fromStdString(session.login()),
                                                        Qt::CaseInsensitive) != 0)
        throw UsageError("--as",
                         {QT_TRANSLATE_NOOP("errors", "the server's account belongs to %1"), session.login()},
                         QT_TRANSLATE_NOOP("errors",
                                           "leave --as out, or name the account of that person in the "
                                           "address"));
    return session;
}

std::optional<database::Role> role_wanted(const Arguments& arguments) {
    database::Role role{};
    const auto name = arguments.value("--role");
    return name && database::parse_role(*name, role) ? std::optional(role) : std::nullopt;
}

}  // namespace

database::Session session_of(const Arguments& arguments, const database::Store& store) {
    if (store.is_server()) return server_session(arguments, store, role_wanted(arguments));
    const auto login = arguments.value("--as");
    if (!login) {
        for (const char* option : {"--role", "--password-file"})
            if (arguments.has(option))
                throw UsageError(option, QT_TRANSLATE_NOOP("errors", "has no meaning without --as"),
                                 QT_TRANSLATE_NOOP("errors", "name the person who signs in: --as LOGIN"));
        return store.station_session();
    }
    const auto file = arguments.value("--password-file");
    return database::People(store).sign_in(*login, file ? read_password(*file) : ask_password(*login),
                                           role_wanted(arguments));
}

database::Session person_session(const Arguments& arguments, const database::Store& store) {
    if (!arguments.has("--as") && !store.is_server())
        throw UsageError(
            "--as", QT_TRANSLATE_NOOP("errors", "is missing; this command reads personal data"),
            QT_TRANSLATE_NOOP(
                "errors", "sign in with --as LOGIN, and --password-file FILE where there is no terminal"));
    return session_of(arguments, store);
}

std::string person_named(const Arguments& arguments, const database::Store& store,
                         const database::Session& session) {
    const auto login = arguments.value("--person");
    if (!login) return {};
    const auto person = database::People(store).find_login(session, *login);
    if (!person)
        throw InputError("--person", "",
                         {QT_TRANSLATE_NOOP("errors", "no person '%1' that you may read"), *login},
                         QT_TRANSLATE_NOOP("errors", "name a login of this store"));
    return person->id;
}

nlohmann::json or_null(const std::string& text) {
    return text.empty() ? nlohmann::json() : nlohmann::json(text);
}

}  // namespace fulcrum::app
