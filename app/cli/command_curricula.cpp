// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum curriculum list and move: the installed versions of the curriculum, who follows which, and moving a
// person or a cohort to another one, with a dry run.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/installed_curriculum.h"
#include "app/cli/placed_assets.h"
#include "database/records/curricula.h"
#include "database/records/people.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

using database::Curricula;
using database::CurriculumChange;
using nlohmann::json;

std::string standing_name(const TaskStanding& standing) {
    return row_of(fulcrum::standing_names, standing.standing).name;
}

std::vector<std::string> chosen_people(const Arguments& arguments, const database::Store& store,
                                       const database::Session& session) {
    if (arguments.has("--person") + arguments.has("--cohort") != 1)
        throw UsageError("curriculum move",
                         QT_TRANSLATE_NOOP("errors", "needs exactly one of --person and --cohort"),
                         QT_TRANSLATE_NOOP("errors", "give one of them"));
    if (arguments.has("--person")) return {person_named(arguments, store, session)};
    const std::string name = *arguments.value("--cohort");
    const auto cohort = database::People(store).find_cohort(session, name);
    if (!cohort)
        throw InputError("--cohort", "",
                         {QT_TRANSLATE_NOOP("errors", "no cohort '%1' that you may read"), name},
                         QT_TRANSLATE_NOOP("errors", "name a cohort of this store"));
    return cohort->members;
}

int run_list(const Arguments& arguments) {
    const Curriculum newest = installed_curriculum();
    std::map<std::string, int> people;
    if (arguments.has("--db")) {
        const database::Store store = open_store(arguments, false);
        check_followed(store, newest);
        people = Curricula(store).people(newest);
    }
    json versions = json::array();
    const auto add = [&](const Curriculum& one) {
        versions.push_back({{"curriculum", one.name()},
                            {"file", one.file},
                            {"title", one.title},
                            {"tasks", one.tasks.size()},
                            {"people", arguments.has("--db") ? json(people[one.name()]) : json()}});
    };
    add(newest);
    for (const Curriculum& one : newest.older) add(one);
    if (arguments.has("--json")) {
        print_json({{"versions", versions}});
        return 0;
    }
    for (const json& one : versions) {
        std::cout << one["curriculum"].get<std::string>() << "  " << one["title"].get<std::string>() << ", "
                  << one["file"].get<std::string>();
        if (!one["people"].is_null()) std::cout << ", people with attempts: " << one["people"];
        std::cout << '\n';
    }
    return 0;
}

json to_json(const CurriculumChange& change) {
    return {{"task", change.task},
            {"before", change.only_after ? json() : json(standing_name(change.before))},
            {"after", change.only_before ? json() : json(standing_name(change.after))}};
}

std::string login_of(const database::Store& store, const database::Session& session,
                     const std::string& person) {
    const auto found = database::People(store).find(session, person);
    return found ? found->login : person;
}

int run_move(const Arguments& arguments) {
    if (!arguments.has("--to"))
        throw UsageError("--to", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the version: --to rectal@3"));
    const bool dry = arguments.has("--dry-run");
    if (!dry && !arguments.has("--reason"))
        throw UsageError("--reason", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "say why, or look first with --dry-run"));
    const std::string to = *arguments.value("--to");
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const Curriculum newest = installed_curriculum();
    const Curricula curricula(store);
    check_followed(store, newest);
    std::vector<std::string> people;
    json rows = json::array(), left_out = json::array();
    for (const std::string& person : chosen_people(arguments, store, session)) {
        if (const std::string name = curricula.missing(session, person, newest);
            !name.empty() && arguments.has("--cohort")) {
            left_out.push_back({{"person", login_of(store, session, person)}, {"from", name}});
            continue;
        }
        people.push_back(person);
        json changes = json::array();
        for (const CurriculumChange& change : curricula.preview(session, person, newest, to))
            changes.push_back(to_json(change));
        rows.push_back({{"person", login_of(store, session, person)},
                        {"from", curricula.followed(session, person, newest).back().name},
                        {"changes", changes}});
    }
    const int moved = dry ? 0 : curricula.move(session, people, newest, to, *arguments.value("--reason"));
    if (arguments.has("--json")) {
        print_json(
            {{"to", to}, {"dry_run", dry}, {"moved", moved}, {"people", rows}, {"left_out", left_out}});
        return 0;
    }
    for (const json& row : left_out)
        std::cerr << row["person"].get<std::string>() << ": "
                  << line_of(database::not_here_words(row["from"].get<std::string>())) << '\n';
    for (const json& row : rows) {
        std::cout << row["person"].get<std::string>() << ": " << row["from"].get<std::string>() << " to "
                  << to;
        const char* between = "; ";
        for (const json& change : row["changes"]) {
            const auto word = [](const json& value) {
                return value.is_null() ? std::string("not in it") : value.get<std::string>();
            };
            std::cout << between << change["task"].get<std::string>() << ' ' << word(change["before"])
                      << " -> " << word(change["after"]);
        }
        if (row["changes"].empty()) std::cout << "; no standing changes";
        std::cout << '\n';
    }
    std::cout << (dry ? "dry run: nobody was moved\n" : "moved: " + std::to_string(moved) + "\n");
    return 0;
}

}  // namespace

std::vector<Command> curricula_commands() {
    return {
        {"curriculum list",
         "",
         0,
         0,
         QT_TRANSLATE_NOOP(
             "commands",
             "Lists the installed versions of the curriculum; with --db also how many people follow each."),
         {store_option(), json_option()},
         run_list},
        {"curriculum move", "", 0, 0,
         QT_TRANSLATE_NOOP("commands",
                           "Moves a person or a cohort to another version of the curriculum; needs --as."),
         joined({{"--person", "LOGIN", QT_TRANSLATE_NOOP("commands", "Move this person.")},
                 {"--cohort", "NAME", QT_TRANSLATE_NOOP("commands", "Move everybody in this cohort.")},
                 {"--to", "VERSION", QT_TRANSLATE_NOOP("commands", "The version, such as rectal@3.")},
                 {"--dry-run", "",
                  QT_TRANSLATE_NOOP("commands", "Print which standings would change and move nobody.")},
                 {"--reason", "TEXT", QT_TRANSLATE_NOOP("commands", "Why; kept in the audit log.")}},
                session_options()),
         run_move}};
}

}  // namespace fulcrum::app
