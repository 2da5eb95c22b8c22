// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the reports that are scheduled: for `fulcrum schedule run`, the page of reports and the window of a
// director that is open. Any thread, with a Store of that thread.
#pragma once

#include <string>
#include <vector>

#include "database/schedules/schedules.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {

struct ScheduledRun {
    struct Failed {
        std::string id, cohort;
        std::string problem;  ///< in English, for programs; it is stored as a sentence
        std::string words;    ///< in the language in use
    };
    std::vector<std::string> written;  ///< files
    std::vector<Failed> failed;
    int current = 0;    ///< were written before
    bool busy = false;  ///< another run was under way; it writes what is due, this one wrote nothing
};

/// "/srv/reports/year-1-2026-W48-1a2b3c4d.pdf": the same in the same period.
std::string scheduled_file(const database::ReportSchedule& schedule, const std::string& period);
/// Its report of the present period was not written yet, or its file is gone.
bool is_due(const database::ReportSchedule& schedule, database::UtcMilliseconds now);

/// What it writes with, the same for all of them.
struct ScheduleMeans {
    const std::vector<TaskDefinition>& tasks;
    const Curriculum& curriculum;
    std::string program_version;
};
struct ScheduleRequest {
    std::string only = {};  ///< one of them; empty: all
    bool if_due = true;     ///< false: `only` is written again
};
/// Writes what is due; one that fails does not keep the others from being
/// written. Throws AccessDenied, StoreError.
ScheduledRun run_schedules(const database::Store& store, const database::Session& director,
                           const ScheduleMeans& means, const ScheduleRequest& request = {},
                           const Progress& progress = {});

}  // namespace fulcrum::ui
