// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum schedule: reports of a cohort that are written to a folder every day or week.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/installed_curriculum.h"
#include "app/cli/placed_assets.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/task/task.h"
#include "database/records/people.h"
#include "database/schedules/schedules.h"
#include "ui/reports/scheduled_reports.h"

namespace fulcrum::app {
namespace {

using database::ReportSchedule;
using database::ScheduleEvery;
using database::Schedules;
using nlohmann::json;

/// In English, in a line.
std::string problem_of(const ReportSchedule& schedule) {
    std::string line = schedule.problem.words();
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

json document_of(const ReportSchedule& one) {
    return {{"id", one.id},
            {"cohort", one.cohort_name},
            {"format", one.format},
            {"folder", one.folder},
            {"every", every_name(one.every)},
            {"last", or_null(one.last_period)},
            {"problem", or_null(problem_of(one))}};
}

std::string required(const Arguments& arguments, const char* option) {
    const auto value = arguments.value(option);
    if (!value)
        throw UsageError(option, QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "see `fulcrum schedule add --help`"));
    return *value;
}

int add(const Arguments& arguments) {
    ReportSchedule schedule;
    const std::string cohort = required(arguments, "--cohort");
    schedule.folder = required(arguments, "--folder");
    schedule.format = arguments.value_or("--format", "pdf");
    schedule.every =
        arguments.value_or("--every", "week") == "day" ? ScheduleEvery::day : ScheduleEvery::week;
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    const auto found = database::People(store).find_cohort(session, cohort);
    if (!found)
        throw InputError("--cohort", "",
                         {QT_TRANSLATE_NOOP("errors", "no cohort '%1' that you may read"), cohort},
                         QT_TRANSLATE_NOOP("errors", "name a cohort of this store"));
    schedule.cohort_id = found->id;
    const std::string id = Schedules(store).add(session, schedule);
    if (arguments.has("--json")) {
        print_json({{"id", id}});
    } else {
        std::cout << id << '\n';
    }
    return 0;
}

int list(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    json rows = json::array();
    for (const ReportSchedule& one : Schedules(store).list(session)) {
        rows.push_back(document_of(one));
        if (arguments.has("--json")) continue;
        std::cout << one.id << "  " << one.cohort_name << "  " << one.format << " every "
                  << every_name(one.every) << " to " << one.folder << "  "
                  << (one.last_period.empty() ? "not written yet" : "written: " + one.last_period) << '\n';
        if (!one.problem.empty()) std::cout << "  last try failed: " << problem_of(one) << '\n';
    }
    if (arguments.has("--json")) print_json({{"schedules", rows}});
    return 0;
}

int remove(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    Schedules(store).remove(session, arguments.words()[0]);
    if (arguments.has("--json")) print_json({{"id", arguments.words()[0]}});
    return 0;
}

/// Writes what is due; one that fails does not keep the others from being written.
int run_due(const Arguments& arguments) {
    const database::Store store = open_store(arguments, false);
    const database::Session session = person_session(arguments, store);
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    const Curriculum curriculum = installed_curriculum();
    check_followed(store, curriculum);
    const ui::ScheduledRun run =
        ui::run_schedules(store, session, {tasks, curriculum, version_line()}, {}, {});
    json failed = json::array();
    for (const auto& one : run.failed) {
        failed.push_back({{"id", one.id}, {"cohort", one.cohort}, {"problem", one.problem}});
        std::cerr << one.id << ": " << one.words << '\n';
    }
    if (arguments.has("--json")) {
        print_json({{"written", run.written},
                    {"failed", failed},
                    {"current", run.current},
                    {"other_run_under_way", run.busy}});
    } else if (run.busy) {
        std::cout << "another run is under way and writes what is due\n";
    } else {
        for (const std::string& file : run.written) std::cout << "wrote " << file << '\n';
        std::cout << run.current << " were written before, " << failed.size() << " failed\n";
    }
    return failed.empty() ? 0 : 1;
}

}  // namespace

std::vector<Command> schedule_commands() {
    Command adding{
        "schedule add",
        "",
        0,
        0,
        QT_TRANSLATE_NOOP("commands", "Schedules a report of a cohort; needs --as, a director."),
        joined({{"--cohort", "NAME", QT_TRANSLATE_NOOP("commands", "The cohort.")},
                {"--folder", "FOLDER",
                 QT_TRANSLATE_NOOP("commands", "The folder to write to, as a path from /.")},
                {"--every", "TIME", QT_TRANSLATE_NOOP("commands", "How often."), "week", {"day", "week"}},
                {"--format",
                 "FORMAT",
                 QT_TRANSLATE_NOOP("commands", "The kind of file."),
                 "pdf",
                 {"pdf", "csv", "xlsx", "json"}}},
               session_options()),
        add};
    Command running{"schedule run",
                    "",
                    0,
                    0,
                    QT_TRANSLATE_NOOP("commands", "Writes the reports that are due; needs --as, a director."),
                    session_options(),
                    run_due,
                    true};
    running.details =
        QT_TRANSLATE_NOOP("commands",
                          "Meant for cron or a systemd timer, any number of times a day: each report is "
                          "written once in its day or week (UTC), and again where its file is gone. One that "
                          "fails is tried again at the next run; the exit status is 1 then, and `fulcrum "
                          "schedule list` shows why. The password is read from --password-file.");
    return {adding,
            {"schedule list", "", 0, 0,
             QT_TRANSLATE_NOOP("commands", "Lists the scheduled reports; needs --as, a director."),
             session_options(), list},
            {"schedule remove", "ID", 1, 1,
             QT_TRANSLATE_NOOP("commands", "Ends a schedule; needs --as, a director."), session_options(),
             remove},
            running};
}

}  // namespace fulcrum::app
