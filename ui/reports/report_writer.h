// SPDX-License-Identifier: GPL-3.0-or-later
// What a format writes: one class for each, in its own file, named in the table of formats (report.h).
// Internal to this room.
#pragma once

#include "ui/reports/report.h"

namespace fulcrum::ui {

/// The files that were written; none when stopped.
using ReportFiles = std::vector<std::string>;

/// Whose data a report is of, and who asks.
struct ReportSource {
    const database::Store& store;
    const database::Session& session;
    const std::vector<TaskDefinition>& tasks;
    const std::string& program_version;
};

/// Without state. All throw StoreError (failed) when a file cannot be written.
class ReportWriter {
  public:
    virtual ~ReportWriter() = default;
    /// Before anything is read. Throws InputError where the request lacks what the format needs.
    virtual void check(const ReportRequest&) const {}
    /// Refuses, as formats without a report of one attempt do. Throws InputError.
    virtual ReportFiles write_attempt(const AttemptPaper& paper, const ReportRequest& request) const;
    virtual ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const = 0;
    /// Gathers as much of each person as the format shows.
    virtual ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                                     const Progress& progress) const = 0;
};

/// The table of a cohort, with pages of its people or without; an empty optional when stopped.
std::optional<CohortReport> gather_cohort(const ReportSource& source, const ReportRequest& request,
                                          PeoplePages people, const Progress& progress);
/// Readable by its owner only; throws StoreError (failed).
void save_report(const std::string& path, const std::string& content);

}  // namespace fulcrum::ui
