// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum report: progress reports as PDF, CSV, XLSX, JSON or xAPI statements, from the same query as the
// screens.
#include <iostream>

#include "app/cli/attempt_document.h"
#include "app/cli/installed_curriculum.h"
#include "app/cli/placed_assets.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/task/task.h"
#include "ui/reports/report.h"
#include "ui/reports/report_xapi.h"

namespace fulcrum::app {

namespace {

int report_files(const Arguments& arguments, const std::vector<std::string>& files) {
    if (arguments.has("--json")) {
        print_json({{"files", files}});
    } else {
        for (const std::string& file : files) std::cout << "wrote " << file << '\n';
    }
    return 0;
}

/// The record of one attempt as tables, in the folder --output.
int write_trace(const Arguments& arguments) {
    if (!arguments.has("--attempt"))
        throw UsageError("--format trace", QT_TRANSLATE_NOOP("errors", "is for one attempt"),
                         QT_TRANSLATE_NOOP("errors", "name it: --attempt ID"));
    const std::string folder = arguments.folder("--output", "");  // refused before the work
    const database::Store store = open_store(arguments, false);
    const database::Session session = session_of(arguments, store);
    return report_files(arguments, export_trace(store, session, *arguments.value("--attempt"), folder));
}

int run_report(const Arguments& arguments) {
    if (arguments.has("--person") + arguments.has("--cohort") + arguments.has("--attempt") != 1)
        throw UsageError("report",
                         QT_TRANSLATE_NOOP("errors", "needs exactly one of --person, --cohort and --attempt"),
                         QT_TRANSLATE_NOOP("errors", "give one of them"));
    if (!arguments.has("--output"))
        throw UsageError("--output", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the file to write: -o FILE"));
    if (arguments.value_or("--format", "pdf") == "trace") return write_trace(arguments);
    ui::ReportRequest request;
    request.format = ui::parse_report_format(arguments.value_or("--format", "pdf"));
    request.path = *arguments.value("--output");
    request.home_page = arguments.value_or("--home-page", "");
    request.plan_weeks = static_cast<int>(
        arguments.integer("--plan-weeks", database::usual_plan_weeks, 1, database::longest_plan_weeks));
    if (request.format == ui::ReportFormat::xapi) ui::require_home_page(request.home_page);

    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    if (arguments.has("--person")) {
        request.person_id = person_named(arguments, store, session);
    } else if (const auto attempt = arguments.value("--attempt")) {
        request.attempt_id = *attempt;
    } else {
        const std::string name = *arguments.value("--cohort");
        const auto cohort = database::People(store).find_cohort(session, name);
        if (!cohort)
            throw InputError("--cohort", "",
                             {QT_TRANSLATE_NOOP("errors", "no cohort '%1' that you may read"), name},
                             QT_TRANSLATE_NOOP("errors", "name a cohort of this store"));
        request.cohort_id = cohort->id;
    }
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    const Curriculum curriculum = installed_curriculum();
    check_followed(store, curriculum);
    request.curriculum = &curriculum;
    const std::vector<std::string> files = ui::write_report(store, session, request, tasks, version_line());
    return report_files(arguments, files);
}

}  // namespace

Command report_command() {
    return {
        "report",
        "",
        0,
        0,
        QT_TRANSLATE_NOOP("commands",
                          "Writes a progress report of a person, a cohort or an attempt; needs --as, or a "
                          "programme server."),
        joined(
            {{"--person", "LOGIN", QT_TRANSLATE_NOOP("commands", "A report of this person.")},
             {"--cohort", "NAME", QT_TRANSLATE_NOOP("commands", "A report of this cohort.")},
             {"--attempt", "ID", QT_TRANSLATE_NOOP("commands", "A report of this attempt.")},
             {"--format",
              "FORMAT",
              QT_TRANSLATE_NOOP("commands", "The kind of file."),
              "pdf",
              {"pdf", "csv", "xlsx", "json", "xapi", "trace"}},
             {"--home-page", "ADDRESS",
              QT_TRANSLATE_NOOP(
                  "commands", "With --format xapi: the web address that the ids of your people belong to.")},
             {"--plan-weeks", "N",
              QT_TRANSLATE_NOOP("commands",
                                "Of a cohort as pdf or json: the plan gives so many weeks for all tasks."),
              "26"},
             {"--output",
              "FILE",
              QT_TRANSLATE_NOOP("commands", "The file to write; with --format trace the folder."),
              "",
              {},
              "-o"}},
            session_options()),
        run_report,
        true};
}

}  // namespace fulcrum::app
