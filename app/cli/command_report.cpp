// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum report: progress on paper and as data, from the one query behind the screens.
#include <iostream>

#include "app/assets.h"
#include "app/cli/commands.h"
#include "app/services/application.h"
#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"
#include "ui/reports/report.h"

namespace fulcrum::app {

int command_report(const std::vector<std::string>& words) {
    OptionSpec spec;
    spec.usage =
        "usage: fulcrum report (--person LOGIN | --cohort NAME | --attempt ID) --format pdf|csv|json -o FILE "
        "--as LOGIN [--password-file FILE] [--db FILE] [--json]";
    spec.with_value = session_options();
    spec.with_value.insert({"--person", "--cohort", "--attempt", "--format", "--output"});
    spec.flags = {"--json"};
    const Arguments arguments(words, spec);
    if (arguments.has("--person") + arguments.has("--cohort") + arguments.has("--attempt") != 1)
        throw UsageError("command line: give one of --person, --cohort and --attempt; " + spec.usage);
    if (!arguments.has("--output"))
        throw UsageError("command line: -o: name the file to write; " + spec.usage);
    ui::ReportRequest request;
    request.format = ui::parse_report_format(arguments.value_or("--format", "pdf"));
    request.path = *arguments.value("--output");

    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const database::People people(store);
    if (const auto login = arguments.value("--person")) {
        const auto person = people.find_login(session, *login);
        if (!person)
            throw InputError("command line", "--person", "no person '" + *login + "' that you may read",
                             "name a login of this store");
        request.person_id = person->id;
    } else if (const auto attempt = arguments.value("--attempt")) {
        request.attempt_id = *attempt;
    } else {
        const auto cohort = people.find_cohort(session, *arguments.value("--cohort"));
        if (!cohort)
            throw InputError("command line", "--cohort",
                             "no cohort '" + *arguments.value("--cohort") + "' that you may read",
                             "name a cohort of this store");
        request.cohort_id = cohort->id;
    }
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    const std::vector<std::string> files = ui::write_report(store, session, request, tasks, version_line());
    if (arguments.has("--json")) {
        print_json({{"files", files}});
    } else {
        for (const std::string& file : files) std::cout << "wrote " << file << '\n';
    }
    return 0;
}

}  // namespace fulcrum::app
