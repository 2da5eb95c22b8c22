// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum sync, fulcrum server: the programme server.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <iostream>

#include "app/cli/commands.h"
#include "database/sync/programme_server.h"
#include "database/sync/sync.h"

namespace fulcrum::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// While it lives, the first Ctrl-C asks for the end, a second one ends the program at once.
class UntilInterrupted {
  public:
    UntilInterrupted() {
        interrupted = 0;
        struct sigaction action {};
        action.sa_handler = [](int) { interrupted = 1; };
        action.sa_flags = SA_RESETHAND;
        sigaction(SIGINT, &action, &before_);
    }
    ~UntilInterrupted() { sigaction(SIGINT, &before_, nullptr); }
    UntilInterrupted(const UntilInterrupted&) = delete;
    UntilInterrupted& operator=(const UntilInterrupted&) = delete;

  private:
    struct sigaction before_ {};
};

database::ServerAddress address_of(const Arguments& arguments) {
    const auto to = arguments.value("--to");
    if (!to)
        throw UsageError(
            "--to", QT_TRANSLATE_NOOP("errors", "is missing"),
            QT_TRANSLATE_NOOP("errors", "name the server: --to postgresql://USER@HOST:PORT/DATABASE"));
    return database::ServerAddress::parse(*to);
}

void print_sync(const database::SyncResult& result) {
    for (const database::SyncCount& one : result.counts)
        std::cout << one.title << ": " << one.pushed << " sent, " << one.pulled << " received\n";
    if (result.erased > 0) std::cout << "people erased here, as on the server: " << result.erased << '\n';
    if (result.audit_rows > 0) std::cout << "audit rows: " << result.audit_rows << " sent\n";
    for (const Sentence& conflict : result.conflicts)
        std::cout << "conflict: " << line_of(WordedError(conflict)) << '\n';
    if (std::abs(result.clock_ahead_s) > database::clock_tolerance_s)
        std::cout << "this station's clock is " << std::llround(std::abs(result.clock_ahead_s)) << " s "
                  << (result.clock_ahead_s > 0 ? "ahead of" : "behind") << " the server's: set it\n";
    if (!result.complete)
        std::cout << "stopped before the end; nothing is lost, the next sync completes it\n";
    else if (result.transferred() + result.erased + result.audit_rows == 0)
        std::cout << "station and server agree already\n";
    else
        std::cout << "station and server agree\n";
}

int sync(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const database::Store store = open_store(arguments, false);
    const bool has_people = store.has_administrator();
    const database::Session session = has_people ? person_session(arguments, store) : store.station_session();
    database::SyncOptions options;
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    options.progress = [&](double done, const std::string& line) {
        if (terminal) std::cerr << "\r\033[K" << std::lround(100 * done) << " %  " << line << std::flush;
    };
    options.stop = [] { return interrupted != 0; };
    database::SyncResult result;
    {
        const UntilInterrupted until_interrupted;
        result = database::sync_with_server(store, session, address, options);
    }
    if (terminal) std::cerr << "\r\033[K" << std::flush;
    if (!arguments.has("--json")) {
        print_sync(result);
    } else {
        nlohmann::json tables = nlohmann::json::array();
        for (const database::SyncCount& one : result.counts)
            tables.push_back({{"what", one.title}, {"sent", one.pushed}, {"received", one.pulled}});
        print_json({{"store", store_path(arguments)},
                    {"server", address.text()},
                    {"complete", result.complete},
                    {"transferred", result.transferred()},
                    {"tables", tables},
                    {"erased", result.erased},
                    {"audit_rows", result.audit_rows},
                    {"clock_ahead_s", result.clock_ahead_s},
                    {"conflicts", english_of(result.conflicts)}});
    }
    return result.complete ? 0 : 1;
}

int create_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const database::ServerSchema schema = database::create_programme_server(address);
    if (arguments.has("--json")) {
        print_json({{"server", address.text()}, {"from", schema.from}, {"schema", schema.to}});
    } else if (schema.from == 0) {
        std::cout << "created a programme server in " << address.text() << " (schema " << schema.to << ")\n";
    } else if (schema.from == schema.to) {
        std::cout << address.text() << " has schema " << schema.to << " already\n";
    } else {
        std::cout << "brought " << address.text() << " from schema " << schema.from << " to " << schema.to
                  << '\n';
    }
    return 0;
}

int check_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const database::ServerCheck check = database::check_programme_server(address);
    if (arguments.has("--json")) {
        print_json({{"server", address.text()},
                    {"ok", check.problems.empty()},
                    {"stations", check.stations},
                    {"audit_rows", check.audit_rows},
                    {"signatures", check.signatures},
                    {"records", check.records},
                    {"audit_head", check.audit_head},
                    {"problems", english_of(check.problems)},
                    {"notes", english_of(check.notes)}});
    } else {
        std::cout << "audit logs of " << check.stations
                  << " stations: " << (check.problems.empty() ? "intact" : "BROKEN") << ", "
                  << check.audit_rows << " rows, " << check.signatures << " signatures\n"
                  << "audit head, as reports from this server print it: " << check.audit_head << '\n';
        for (const Sentence& problem : check.problems) std::cout << "  " << problem.words() << '\n';
        for (const Sentence& note : check.notes) std::cout << "  note: " << note.words() << '\n';
    }
    return check.problems.empty() ? 0 : 1;
}

int grant_at_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const database::ServerAccount account =
        database::grant_at_programme_server(address, arguments.words()[0]);
    std::vector<std::string> roles;
    for (const database::Role role : account.roles) roles.emplace_back(database::role_name(role));
    if (arguments.has("--json")) {
        print_json({{"server", address.text()},
                    {"account", account.name},
                    {"login", account.login},
                    {"name", account.display_name},
                    {"roles", roles},
                    {"made", account.made},
                    {"store", account.address}});
        return 0;
    }
    std::string list;
    for (const std::string& role : roles) list += (list.empty() ? "" : ", ") + role;
    std::cout << (account.made ? "made the account " : "the account is ") << account.name << " of "
              << account.display_name << " (" << account.login
              << "), roles: " << (list.empty() ? "none; it sees nothing" : list) << '\n';
    if (account.made) std::cout << "give it a password, in psql: \\password \"" << account.name << "\"\n";
    if (!list.empty()) std::cout << "the person opens the server with --db " << account.address << '\n';
    return 0;
}

int erase_at_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const std::string& person = arguments.words()[0];
    const bool dry_run = arguments.has("--dry-run");
    const std::vector<database::ErasedRows> rows =
        database::erase_at_programme_server(address, person, dry_run);
    if (arguments.has("--json")) {
        nlohmann::json tables = nlohmann::json::object();
        for (const database::ErasedRows& one : rows) tables[one.table] = one.rows;
        print_json({{"server", address.text()}, {"person", person}, {"dry_run", dry_run}, {"rows", tables}});
        return 0;
    }
    for (const database::ErasedRows& one : rows) std::cout << one.table << ": " << one.rows << " rows\n";
    std::cout << (dry_run ? "would be erased; nothing was changed\n"
                          : "erased on the server; each station erases at its next sync\n");
    return 0;
}

}  // namespace

std::vector<Command> server_commands() {
    const Option to{
        "--to", "ADDRESS",
        "The programme server: postgresql://USER@HOST:PORT/DATABASE. The password comes from ~/.pgpass "
        "or the file named in PGPASSFILE, never from the command line."};
    return {
        {"sync", "", 0, 0, "Exchanges people, attempts, scores and reviews with the programme server.",
         joined({to}, session_options()), sync, false,
         "An administrator signs in with --as; a store without people needs no sign-in for its first "
         "sync, which "
         "brings them. Can be cut off at any time (Ctrl-C too): the next sync completes it."},
        {"server create",
         "",
         0,
         0,
         "Makes the tables of a programme server in an empty PostgreSQL database, or upgrades them.",
         {to, json_option()},
         create_server},
        {"server check",
         "",
         0,
         0,
         "Checks the audit logs of all stations on the server, their signatures, and what was signed.",
         {to, json_option()},
         check_server},
        {"server grant",
         "LOGIN",
         1,
         1,
         "Makes the server's account of a person who is to look at reports and pages there, or brings its "
         "roles up to date.",
         {to, json_option()},
         grant_at_server,
         false,
         "The account's name is the person's id. It reads what the person may see as trainee, educator or "
         "director, and changes nothing. Give it its password with psql."},
        {"server erase",
         "PERSON",
         1,
         1,
         "Erases a person (by id) on the server; each station follows at its next sync.",
         {to, {"--dry-run", "", "Only show what would be erased."}, json_option()},
         erase_at_server}};
}

}  // namespace fulcrum::app
