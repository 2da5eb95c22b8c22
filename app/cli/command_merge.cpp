// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum people merge and people unmerge: a person who was entered twice. fulcrum people login: a login that
// two people got.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/records/person_merge.h"

namespace fulcrum::app {
namespace {

using database::MergePlan;
using database::Person;
using database::PersonMerge;
using nlohmann::json;

/// By the login as it was given, merged or not: what the list of people shows.
Person account_of(const database::Store& store, const database::Session& session, const std::string& login) {
    for (Person& person : database::People(store).list(session))
        if (person.login == login || person.id == login) return std::move(person);
    throw database::StoreError(database::StoreErrorKind::not_found,
                               {QT_TRANSLATE_NOOP("errors", "no person %1"), login},
                               QT_TRANSLATE_NOOP("errors", "list the people and name one of them"));
}

std::string required_reason(const Arguments& arguments) {
    const auto reason = arguments.value("--reason");
    if (!reason)
        throw UsageError("--reason", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "say why: it is stored in the audit log"));
    return *reason;
}

int merge(const Arguments& arguments) {
    const bool dry = arguments.has("--dry-run");
    const std::string reason = dry ? std::string() : required_reason(arguments);
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const std::string from = account_of(store, session, arguments.words()[0]).id,
                      into = account_of(store, session, arguments.words()[1]).id;
    const PersonMerge people(store);
    const MergePlan plan = dry ? people.plan(session, from, into) : people.merge(session, from, into, reason);
    if (arguments.has("--json")) {
        json counts = json::object();
        for (const MergePlan::Count& one : plan.counts) counts[one.what.words()] = one.count;
        print_json({{"dry_run", dry},
                    {"from", {{"id", from}, {"login", plan.from.login}}},
                    {"into", {{"id", into}, {"login", plan.into.login}}},
                    {"follows", counts},
                    {"cohorts", plan.cohorts}});
        return 0;
    }
    std::cout << plan.from.login << " (" << plan.from.display_name << ") into " << plan.into.login << " ("
              << plan.into.display_name << ")\n";
    for (const MergePlan::Count& one : plan.counts)
        std::cout << "  " << one.what.words() << ": " << one.count << '\n';
    for (const std::string& cohort : plan.cohorts) std::cout << "  cohort: " << cohort << '\n';
    std::cout << plan.from.login << " no longer signs in; " << plan.into.login
              << " keeps its login and password\n";
    if (dry) std::cout << "dry run, nothing was changed\n";
    return 0;
}

int unmerge(const Arguments& arguments) {
    const std::string reason = required_reason(arguments);
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const Person person = account_of(store, session, arguments.words()[0]);
    PersonMerge(store).undo(session, person.id, reason);
    if (arguments.has("--json")) {
        print_json({{"id", person.id}, {"login", person.login}});
    } else {
        std::cout << person.login
                  << " is a person of its own again, deactivated, without roles, cohorts and password\n";
    }
    return 0;
}

int change_login(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const Person person = account_of(store, session, arguments.words()[0]);
    const std::string& login = arguments.words()[1];
    database::People(store).set_login(session, person.id, login);
    if (arguments.has("--json")) {
        print_json({{"id", person.id}, {"before", person.login}, {"login", login}});
    } else {
        std::cout << person.display_name << " signs in as " << login << " now; the password stays\n";
    }
    return 0;
}

}  // namespace

std::vector<Command> merge_commands() {
    const Option reason{"--reason", "TEXT", QT_TRANSLATE_NOOP("commands", "Why; stored in the audit log.")};
    Command merging{
        "people merge",
        "LOGIN INTO",
        2,
        2,
        QT_TRANSLATE_NOOP(
            "commands",
            "Merges an account into another account of the same person; needs --as, an administrator."),
        joined({{"--dry-run", "", QT_TRANSLATE_NOOP("commands", "Print what follows and change nothing.")},
                reason},
               session_options()),
        merge};
    merging.details = QT_TRANSLATE_NOOP(
        "commands",
        "LOGIN is the doubled account, INTO the one that stays. Attempts with their scores, comments and "
        "ratings, goals and decisions are read as INTO's from then on, on every station and on the programme "
        "server; nothing that is signed is changed. Cohorts and drafts move. LOGIN no longer signs in, and "
        "nobody else can be given it. INTO has to hold every role that LOGIN holds.");
    Command undoing{"people unmerge",
                    "LOGIN",
                    1,
                    1,
                    QT_TRANSLATE_NOOP("commands", "Undoes a merge; needs --as, an administrator."),
                    joined({reason}, session_options()),
                    unmerge};
    undoing.details =
        QT_TRANSLATE_NOOP("commands",
                          "What was done under LOGIN is its own again. The account stays deactivated; roles, "
                          "cohorts and a password are given as to a new one.");
    Command renaming{
        "people login",
        "LOGIN NEW",
        2,
        2,
        QT_TRANSLATE_NOOP("commands", "Gives an account another login; needs --as, an administrator."),
        session_options(),
        change_login};
    renaming.details = QT_TRANSLATE_NOOP(
        "commands",
        "Where two stations gave the same login to two people, neither is transferred until one of them has "
        "another login: change it at the station that made the account, and sync. The password, and all that "
        "is stored of the person, stay.");
    return {merging, undoing, renaming};
}

}  // namespace fulcrum::app
