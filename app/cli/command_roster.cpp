// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum people import and cohort import: people and cohorts from another system's files (OneRoster, or a
// list), with a dry run.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/roster/roster_import.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::app {
namespace {

using database::CohortImport;
using database::PersonImport;
using database::Roster;
using database::RosterImport;
using nlohmann::json;

const char* word_of(PersonImport::What what) {
    switch (what) {
        case PersonImport::What::create:
            return "create";
        case PersonImport::What::add_role:
            return "add_role";
        case PersonImport::What::nothing:
            return "nothing";
        case PersonImport::What::refused:
            break;
    }
    return "refused";
}

json role_names(const std::vector<database::Role>& roles) {
    json names = json::array();
    for (const database::Role role : roles) names.push_back(database::role_name(role));
    return names;
}

void print_left_out(const Roster& roster) {
    for (const Sentence& line : roster.left_out) std::cout << "left out: " << line_of(line) << '\n';
}

void print_people(const std::vector<PersonImport>& steps, bool dry, bool with_passwords) {
    std::size_t created = 0, changed = 0, there = 0, refused = 0;
    for (const PersonImport& step : steps) {
        switch (step.what) {
            case PersonImport::What::create:
                ++created;
                std::cout << step.person.login << "  " << step.person.name;
                if (with_passwords && !dry) std::cout << "  " << step.one_time_password;
                std::cout << '\n';
                break;
            case PersonImport::What::add_role:
                ++changed;
                std::cout << step.person.login << "  gets a role\n";
                break;
            case PersonImport::What::nothing:
                ++there;
                break;
            case PersonImport::What::refused:
                ++refused;
                std::cout << step.person.place << ": " << step.person.login << ' ' << step.why << '\n';
                break;
        }
    }
    std::cout << (dry ? "dry run, nothing was changed: " : "") << created << " created, " << changed
              << " with a new role, " << there << " there already, " << refused << " refused\n";
}

int import_people(const Arguments& arguments) {
    const Roster roster = database::read_roster(arguments.words()[0]);
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const bool dry = arguments.has("--dry-run"), as_json = arguments.has("--json");
    const auto file_name = arguments.value("--passwords");
    std::optional<OutputFile> file;
    if (file_name && !dry)
        file.emplace(*file_name, OutputFile::Existing::keep, OutputFile::Access::owner_only);
    const RosterImport roster_import(store, session);
    std::vector<PersonImport> steps = roster_import.plan_people(roster);
    if (!dry) {
        try {
            roster_import.bring_people(steps, [&](std::size_t done, std::size_t all) {
                if (!as_json && done > 0 && done % 20 == 0) std::cerr << done << " of " << all << '\n';
                return true;
            });
        } catch (...) {
            if (file) database::write_passwords(*file, steps);  // of those who were created before it failed
            throw;
        }
    }
    if (file) database::write_passwords(*file, steps);
    if (as_json) {
        json rows = json::array();
        for (const PersonImport& step : steps) {
            rows.push_back({{"login", step.person.login},
                            {"name", step.person.name},
                            {"roles", role_names(step.person.roles)},
                            {"what", word_of(step.what)},
                            {"why", or_null(step.why)},
                            {"one_time_password", or_null(file ? std::string() : step.one_time_password)}});
        }
        print_json({{"dry_run", dry}, {"people", rows}, {"left_out", english_of(roster.left_out)}});
    } else {
        print_people(steps, dry, !file);
        print_left_out(roster);
    }
    const bool refused = std::any_of(steps.begin(), steps.end(), [](const PersonImport& step) {
        return step.what == PersonImport::What::refused;
    });
    return refused ? 1 : 0;
}

int import_cohorts(const Arguments& arguments) {
    const Roster roster = database::read_roster(arguments.words()[0]);
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const bool dry = arguments.has("--dry-run");
    const RosterImport roster_import(store, session);
    const std::vector<CohortImport> steps =
        dry ? roster_import.plan_cohorts(roster) : roster_import.bring_cohorts(roster);
    const bool missing = std::any_of(steps.begin(), steps.end(),
                                     [](const CohortImport& step) { return !step.missing.empty(); });
    if (arguments.has("--json")) {
        json rows = json::array();
        for (const CohortImport& step : steps) {
            rows.push_back({{"cohort", step.name},
                            {"created", step.create},
                            {"members", step.members},
                            {"educators", step.educators},
                            {"missing", step.missing}});
        }
        print_json({{"dry_run", dry}, {"cohorts", rows}, {"left_out", english_of(roster.left_out)}});
        return missing ? 1 : 0;
    }
    for (const CohortImport& step : steps) {
        std::cout << step.name << (step.create ? " (new)" : "") << ": " << step.members.size()
                  << " members and " << step.educators.size() << " educators added\n";
        for (const std::string& login : step.missing)
            std::cout << "  not added: " << login
                      << ", nobody here has this login and role; an administrator imports people first\n";
    }
    print_left_out(roster);
    if (dry) std::cout << "dry run, nothing was changed\n";
    return missing ? 1 : 0;
}

}  // namespace

std::vector<Command> roster_commands() {
    const std::string details = QT_TRANSLATE_NOOP(
        "commands",
        "PATH is a folder or ZIP archive with OneRoster CSV files (users.csv, classes.csv, enrollments.csv, "
        "roles.csv), or one CSV file with the columns login, name, role (trainee or educator) and cohort. "
        "Nobody is "
        "renamed, deactivated or removed, so an import can be repeated.");
    Command people{"people import",
                   "PATH",
                   1,
                   1,
                   QT_TRANSLATE_NOOP(
                       "commands", "Makes accounts for the people of a list; needs --as, an administrator."),
                   joined({{"--dry-run", "",
                            QT_TRANSLATE_NOOP("commands", "Print what would be done and change nothing.")},
                           {"--passwords", "FILE",
                            QT_TRANSLATE_NOOP("commands",
                                              "Write the one-time passwords to this new file instead of "
                                              "printing them; only you can read it.")}},
                          session_options()),
                   import_people};
    Command cohorts{
        "cohort import",
        "PATH",
        1,
        1,
        QT_TRANSLATE_NOOP("commands",
                          "Makes the cohorts of a list and adds people to them; needs --as, a director."),
        joined({{"--dry-run", "",
                 QT_TRANSLATE_NOOP("commands", "Print what would be done and change nothing.")}},
               session_options()),
        import_cohorts};
    people.details = cohorts.details = details;
    return {people, cohorts};
}

}  // namespace fulcrum::app
