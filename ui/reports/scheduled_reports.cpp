// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/scheduled_reports.h"

#include <algorithm>
#include <filesystem>

#include "sim_core/numerics/worded_error.h"
#include "ui/language/error_text.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

std::string one_line(std::string line) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
}

}  // namespace

// The same in the same period, so that a second run replaces and adds nothing. The beginning of the
// schedule's id keeps apart what would have one name.
std::string scheduled_file(const database::ReportSchedule& schedule, const std::string& period) {
    std::string name;
    for (const char c : schedule.cohort_name) {
        const bool usual = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (usual || name.empty() || name.back() != '-') name += usual ? c : '-';
    }
    return (std::filesystem::path(schedule.folder) /
            (name + "-" + period + "-" + schedule.id.substr(0, 8) + "." + schedule.format))
        .string();
}

bool is_due(const database::ReportSchedule& schedule, database::UtcMilliseconds now) {
    const std::string period = database::period_of(schedule.every, now);
    std::error_code unknown;
    return schedule.last_period != period ||
           !std::filesystem::exists(scheduled_file(schedule, period), unknown);
}

ScheduledRun run_schedules(const database::Store& store, const database::Session& director,
                           const ScheduleMeans& means, const ScheduleRequest& wanted,
                           const Progress& progress) {
    ScheduledRun run;
    const database::Schedules schedules(store);
    schedules.list(director);  // who may not is refused before a file is made
    const database::ScheduleLock lock(store);
    run.busy = !lock.held();
    if (run.busy) return run;
    const std::vector<database::ReportSchedule> all = schedules.list(director);  // as the last run left them
    for (const database::ReportSchedule& one : all) {
        if (!wanted.only.empty() && one.id != wanted.only) continue;
        if (wanted.if_due && !is_due(one, store.now())) {
            ++run.current;
            continue;
        }
        const std::string period = database::period_of(one.every, store.now());
        try {
            ReportRequest request;
            request.cohort_id = one.cohort_id;
            request.format = parse_report_format(one.format);
            request.path = scheduled_file(one, period);
            request.curriculum = &means.curriculum;
            const std::vector<std::string> files =
                write_report(store, director, request, means.tasks, means.program_version, progress);
            if (files.empty()) return run;  // stopped
            run.written.insert(run.written.end(), files.begin(), files.end());
            schedules.note(director, one.id, period, {});
        } catch (const std::exception& error) {
            const Sentence problem = sentence_of(error);
            run.failed.push_back(
                {one.id, one.cohort_name, one_line(problem.words()), one_line(plain(error_text(error)))});
            schedules.note(director, one.id, period, problem);
        }
    }
    return run;
}

}  // namespace fulcrum::ui
