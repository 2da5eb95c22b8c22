// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum sync, fulcrum server: the programme server.
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <iostream>

#include "app/cli/commands.h"
#include "app/cli/placed_assets.h"
#include "app/cli/simulation_options.h"
#include "database/sync/enrolment.h"
#include "database/sync/programme_server.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/sync.h"
#include "database/sync/trace_fetch.h"

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
    for (const Sentence& conflict : result.conflicts) std::cout << "conflict: " << line_of(conflict) << '\n';
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

/// The server that --to names, or the one at which the station was enrolled; enrols it first with --enrol.
database::ServerAddress server_to_sync(const Arguments& arguments, const database::Store& store,
                                       const database::Session& session) {
    const auto token = arguments.value("--enrol");
    if (!token) return arguments.has("--to") ? address_of(arguments) : database::server_of(store);
    const database::Enrolment enrolment =
        database::enrol_station(store, session, address_of(arguments), *token);
    if (!arguments.has("--json"))
        std::cout << "enrolled at " << enrolment.address.text() << ", "
                  << (enrolment.cohorts.empty()
                          ? std::string("for everybody")
                          : "for " + std::to_string(enrolment.cohorts.size()) + " cohorts")
                  << "; `fulcrum sync` needs no address from now on\n";
    return enrolment.address;
}

/// Progress on a terminal, and Ctrl-C; `work` gets them.
template <typename Work>
auto watched(Work&& work) {
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    database::SyncOptions options;
    options.progress = [&](double done, const std::string& line) {
        if (terminal) std::cerr << "\r\033[K" << std::lround(100 * done) << " %  " << line << std::flush;
    };
    options.stop = [] { return interrupted != 0; };
    const UntilInterrupted until_interrupted;
    auto result = work(options);
    if (terminal) std::cerr << "\r\033[K" << std::flush;
    return result;
}

int fetch_one_trace(const Arguments& arguments, const std::string& attempt) {
    arguments.exclude("--trace", "--enrol");
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::ServerAddress address =
        arguments.has("--to") ? address_of(arguments) : database::server_of(store);
    const database::FetchedTrace fetched = watched([&](const database::SyncOptions& options) {
        return database::fetch_trace(store, session, address, attempt, options);
    });
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)},
                    {"server", address.text()},
                    {"attempt", attempt},
                    {"complete", fetched.complete},
                    {"chunks", fetched.chunks},
                    {"bytes", fetched.bytes},
                    {"signed_by", or_null(fetched.signed_by)}});
    } else if (!fetched.complete) {
        std::cout << "stopped; nothing was stored\n";
    } else if (fetched.chunks == 0) {
        std::cout << "the trace is here already\n";
    } else {
        std::cout << "the trace is here: " << fetched.chunks << " chunks, " << fetched.bytes
                  << " bytes, as signed by the key " << fetched.signed_by << '\n';
    }
    return fetched.complete ? 0 : 1;
}

int sync(const Arguments& arguments) {
    if (const auto attempt = arguments.value("--trace")) return fetch_one_trace(arguments, *attempt);
    const database::Store store = open_store(arguments, false);
    const bool has_people = store.has_administrator();
    const database::Session session = has_people ? person_session(arguments, store) : store.station_session();
    const database::ServerAddress address = server_to_sync(arguments, store, session);
    const database::SyncResult result = watched([&](const database::SyncOptions& options) {
        return database::sync_with_server(store, session, address, options);
    });
    const std::vector<database::PlacedAsset> placed =
        result.complete ? place_assets(store) : std::vector<database::PlacedAsset>();
    if (!arguments.has("--json")) {
        print_sync(result);
        print_placed(placed);
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
                    {"conflicts", english_of(result.conflicts)},
                    {"placed", placed_json(placed)}});
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
    const SimulationSample sample = simulation_sample(arguments);
    database::ServerCheck check = database::check_programme_server(address);
    if (sample.attempts > 0 && check.problems.empty()) {
        const database::Store store = database::Store::open(address.text());
        database::CheckItem item = check_by_simulation(store, store.station_session(), sample);
        for (Sentence& problem : item.problems) check.problems.push_back(std::move(problem));
        for (Sentence& note : item.notes) check.notes.push_back(std::move(note));
    }
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
        for (const Sentence& problem : check.problems) std::cout << "  " << line_of(problem) << '\n';
        for (const Sentence& note : check.notes) std::cout << "  note: " << line_of(note) << '\n';
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

const char* state_name(database::EnrolledStation::State state) {
    switch (state) {
        case database::EnrolledStation::State::open:
            return "open";
        case database::EnrolledStation::State::ended:
            return "ended";
        case database::EnrolledStation::State::enrolled:
            return "enrolled";
        case database::EnrolledStation::State::withdrawn:
            break;
    }
    return "withdrawn";
}

const char* proof_name(database::Proof proof) {
    return proof == database::Proof::holds    ? "yes"
           : proof == database::Proof::broken ? "broken"
                                              : "not asked";
}

const char* proof_words(database::Proof proof) {
    return proof == database::Proof::holds    ? "possession proved"
           : proof == database::Proof::broken ? "POSSESSION NOT PROVED"
                                              : "possession was not asked for";
}

std::string list_of(const std::vector<std::string>& words, const char* none) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list.empty() ? none : list;
}

int enrol_at_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    const auto hours = arguments.integer("--hours", database::usual_token_h, database::shortest_token_h,
                                         database::longest_token_h);
    const database::TokenMade made = database::make_enrolment_token(
        address, arguments.value_or("--name", ""), arguments.words(), static_cast<int>(hours));
    if (arguments.has("--json")) {
        print_json({{"server", address.text()},
                    {"token", made.text},
                    {"id", made.id},
                    {"until", database::iso_utc(made.until)},
                    {"cohorts", made.cohorts}});
        return 0;
    }
    database::ServerAddress to = address;
    to.user.clear();
    std::cout << "token " << made.id << ", once, until " << database::iso_utc(made.until) << ", for "
              << list_of(made.cohorts, "everybody") << ":\n  " << made.text
              << "\nat the station, with its own "
              << "route to the server in place of the address: fulcrum sync --to " << to.text()
              << " --enrol TOKEN\n";
    return 0;
}

int stations_of_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    nlohmann::json list = nlohmann::json::array();
    for (const database::EnrolledStation& one : database::enrolled_stations(address)) {
        const auto time = [](database::UtcMilliseconds at) {
            return at == 0 ? std::string() : database::iso_utc(at);
        };
        list.push_back({{"id", one.id},
                        {"state", state_name(one.state)},
                        {"name", one.name},
                        {"cohorts", one.cohorts},
                        {"made", time(one.made)},
                        {"made_by", one.made_by},
                        {"until", time(one.expires)},
                        {"used", or_null(time(one.used))},
                        {"withdrawn", or_null(time(one.withdrawn))},
                        {"station", or_null(one.station_id)},
                        {"account", or_null(one.account)},
                        {"key", or_null(one.key)},
                        {"key_proved", or_null(one.used == 0 ? "" : proof_name(one.proof))},
                        {"last_row", or_null(time(one.last_row))}});
        if (arguments.has("--json")) continue;
        std::cout << one.id << "  " << state_name(one.state) << (one.name.empty() ? "" : "  " + one.name)
                  << "  for " << list_of(one.cohorts, "everybody");
        if (one.used != 0)
            std::cout << "  station " << one.station_id << ", key " << one.key.substr(0, 16) << " ("
                      << proof_words(one.proof) << "), since " << time(one.used)
                      << (one.last_row == 0 ? ", has sent nothing" : ", newest row " + time(one.last_row));
        else
            std::cout << "  until " << time(one.expires);
        std::cout << '\n';
    }
    if (arguments.has("--json"))
        print_json({{"server", address.text()}, {"stations", list}});
    else if (list.empty())
        std::cout << "no token was made yet: fulcrum server enrol\n";
    return 0;
}

int withdraw_at_server(const Arguments& arguments) {
    const database::ServerAddress address = address_of(arguments);
    database::withdraw_enrolment(address, arguments.words()[0]);
    if (arguments.has("--json"))
        print_json({{"server", address.text()}, {"withdrawn", arguments.words()[0]}});
    else
        std::cout << "withdrawn; what the station has sent stays\n";
    return 0;
}

std::vector<Command> station_commands(const Option& to) {
    constexpr std::size_t most_cohorts = 100;
    return {
        {"server enrol",
         "[COHORT...]",
         0,
         most_cohorts,
         QT_TRANSLATE_NOOP("commands", "Makes a token by which one station becomes one of the server's."),
         {to,
          {"--hours", "N", QT_TRANSLATE_NOOP("commands", "How long the token is good."),
           std::to_string(database::usual_token_h)},
          {"--name", "TEXT", QT_TRANSLATE_NOOP("commands", "What you call the station.")},
          json_option()},
         enrol_at_server,
         false,
         QT_TRANSLATE_NOOP(
             "commands",
             "The station gets the people of the cohorts that are named, with their attempts and reviews; "
             "without a cohort those of the whole programme. The token is shown once and works once. To "
             "change the cohorts of a station, give it another token.")},
        {"server stations",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP("commands", "Lists the tokens and the stations that used them."),
         {to, json_option()},
         stations_of_server},
        {"server withdraw",
         "ID",
         1,
         1,
         QT_TRANSLATE_NOOP("commands",
                           "Makes a token useless, or ends the access of a station (id of either)."),
         {to, json_option()},
         withdraw_at_server}};
}

}  // namespace

std::vector<Command> server_commands() {
    const Option to{
        "--to", "ADDRESS",
        QT_TRANSLATE_NOOP("commands",
                          "The programme server: postgresql://USER@HOST:PORT/DATABASE. The password comes "
                          "from ~/.pgpass or the file named in PGPASSFILE, never from the command line.")};
    const Option server{
        "--to", "ADDRESS",
        QT_TRANSLATE_NOOP(
            "commands",
            "The programme server: postgresql://HOST:PORT/DATABASE; not needed once the station "
            "was enrolled.")};
    const Option enrol{"--enrol", "TOKEN",
                       QT_TRANSLATE_NOOP("commands",
                                         "Makes the station one of the server's first, with the token that "
                                         "`fulcrum server enrol` printed.")};
    const Option trace{"--trace", "ATTEMPT",
                       QT_TRANSLATE_NOOP("commands",
                                         "Instead: fetches the recording of an attempt of another station "
                                         "(--as, somebody who may see it).")};
    std::vector<Command> commands = {
        {"sync", "", 0, 0,
         QT_TRANSLATE_NOOP("commands",
                           "Exchanges people, attempts, scores and reviews with the programme server."),
         joined({server, enrol, trace}, session_options()), sync, false,
         QT_TRANSLATE_NOOP("commands",
                           "An administrator signs in with --as; a store without people needs no sign-in for "
                           "its first sync, which brings them. Can be cut off at any time (Ctrl-C too): the "
                           "next sync completes it.")},
        {"server create",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP(
             "commands",
             "Makes the tables of a programme server in an empty PostgreSQL database, or upgrades them."),
         {to, json_option()},
         create_server},
        {"server check", "", 0, 0,
         QT_TRANSLATE_NOOP(
             "commands",
             "Checks the audit logs of all stations on the server, their signatures, and what was signed."),
         joined(simulation_options(), {to, json_option()}), check_server},
        {"server grant",
         "LOGIN",
         1,
         1,
         QT_TRANSLATE_NOOP("commands",
                           "Makes the server's account of a person who is to look at reports and pages "
                           "there, or brings its roles up to date."),
         {to, json_option()},
         grant_at_server,
         false,
         QT_TRANSLATE_NOOP(
             "commands",
             "The account's name is the person's id. It reads what the person may see as trainee, educator "
             "or director, and changes nothing. Give it its password with psql.")},
        {"server erase",
         "PERSON",
         1,
         1,
         QT_TRANSLATE_NOOP("commands",
                           "Erases a person (by id) on the server; each station follows at its next sync."),
         {to,
          {"--dry-run", "", QT_TRANSLATE_NOOP("commands", "Only show what would be erased.")},
          json_option()},
         erase_at_server}};
    for (Command& command : station_commands(to)) commands.push_back(std::move(command));
    return commands;
}

}  // namespace fulcrum::app
