// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum research export: the programme's attempts for research, without names.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/research/research_export.h"

namespace fulcrum::app {
namespace {

int run_export(const Arguments& arguments) {
    if (!arguments.has("--output"))
        throw UsageError("--output", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the folder to write to: -o FOLDER"));
    const std::string folder = arguments.folder("--output", "");
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::ResearchExport research = database::research_export(store, session);
    const std::vector<std::string> files = database::write_research_files(research, folder);
    if (arguments.has("--json")) {
        print_json({{"people", research.people},
                    {"attempts", research.attempts},
                    {"left_out", research.left_out},
                    {"files", files}});
        return 0;
    }
    for (const std::string& file : files) std::cout << "wrote " << file << '\n';
    std::cout << research.attempts << " attempts of " << research.people << " people; " << research.left_out
              << " left out, of tasks with too few people\n";
    return 0;
}

}  // namespace

Command research_command() {
    Command command{
        "research export",
        "",
        0,
        0,
        QT_TRANSLATE_NOOP(
            "commands",
            "Writes the programme's attempts for research, without names; needs --as, a director."),
        joined(
            {{"--output", "FOLDER", QT_TRANSLATE_NOOP("commands", "The folder to write to."), "", {}, "-o"}},
            session_options()),
        run_export};
    command.details = QT_TRANSLATE_NOOP(
        "commands",
        "Five CSV files: attempts, metrics, people_by_task, attempts_by_task, dictionary. People and "
        "attempts have ids that are drawn again at each export, days count from a person's first attempt, "
        "values have three significant digits. Classes of devices, modes, tasks and metrics of fewer than 5 "
        "people are put together with others or left out. The two tables of counts, taken alone, give no "
        "count below 5. attempts and metrics have rows of single people, from which smaller counts follow, "
        "and somebody who knows a person's attempts well may recognise them: give these files to researchers "
        "only, and do not publish them. Give the same readers no later export without need: next to an "
        "earlier one it shows what single people did in between. A station of some cohorts of a programme "
        "exports nothing.");
    return command;
}

}  // namespace fulcrum::app
