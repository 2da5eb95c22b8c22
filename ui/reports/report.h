// SPDX-License-Identifier: GPL-3.0-or-later
// Progress on paper and as data: one gathering of the figures (database/records/report_data.h) and four ways
// to write them, so that PDF, CSV and JSON agree with the screens. Usable without a window (PDF needs a
// QGuiApplication for fonts). Any thread, with a Store of that thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "assessment/task/task.h"
#include "database/records/cohort_dashboard.h"
#include "database/records/ratings.h"
#include "database/records/report_data.h"
#include "database/rows/csv_text.h"
#include "sim_core/numerics/name_table.h"
#include "ui/services/application_services.h"

namespace fulcrum::ui {

/// What is printed at the foot of every report.
struct ReportProvenance {
    std::string programme, program_version, audit_head;
    std::string station_key;  ///< fingerprint of the key that signed the audit head; empty: not signed
    /// Of the report of one attempt: fingerprint of the key that signed it; empty: none that this store
    /// knows.
    std::optional<std::string> attempt_key = {};
    std::vector<std::string> metric_versions, benchmark_sets, program_versions;
    /// Task, scene, set and curriculum: of the assessed attempts, or of the one attempt.
    std::vector<database::AssetFile> assets;
    std::string program_digest;    ///< SHA-256 of the program that wrote the report
    bool tamper_evident = false;   ///< a service account owns the store
    std::int64_t as_of = 0;        ///< UTC ms
    std::string made_by, made_as;  ///< who asked for it, in which role
    bool demo = false;             ///< watermark
};

/// In English, for files: "not tamper-evident", with where to read more, unless it is.
std::string tamper_evidence(const ReportProvenance& provenance);

struct ReportTask {
    std::string id, title, stage;
};

struct PersonReport {
    ReportProvenance provenance;
    std::string person_id, login, name;
    bool synthetic = false;
    std::vector<ReportTask> tasks;
    std::vector<database::CohortRow> rows;               ///< by task, then device class
    std::vector<database::PersonProgress> progress;      ///< one a task
    std::optional<database::PersonStandings> standings;  ///< in the curriculum, where one was given
};

struct CohortReport {
    ReportProvenance provenance;
    std::vector<ReportTask> tasks;
    database::CohortTable table;
    const Curriculum* curriculum = nullptr;  ///< of the standings; outlives the report
    database::CohortDashboard dashboard;     ///< where there is one
    std::vector<PersonReport> people;        ///< pages of their own
};

/// One attempt.
struct AttemptPaper {
    ReportProvenance provenance;
    ReportTask task;
    database::AttemptReport report;
    std::vector<database::RatingRow> ratings;     ///< those that the trainee is shown, by handing in
    std::vector<database::AssetFile> unaccepted;  ///< its files that no assessed attempt may use
};

class ReportWriter;  // report_writer.h
const ReportWriter& pdf_writer();
const ReportWriter& csv_writer();
const ReportWriter& xlsx_writer();
const ReportWriter& json_writer();
const ReportWriter& xapi_writer();

enum class ReportFormat { pdf, csv, xlsx, json, xapi };
/// `name` is the option's word; `ending` of a file shows the format on screens. Statements for a record store
/// (xapi) need an address, so they are written by the command alone and have no ending of their own.
struct ReportFormatRow {
    ReportFormat kind;
    const char* name;
    const char* ending;
    const ReportWriter& (*writer)();
};
inline constexpr ReportFormatRow report_formats[] = {{ReportFormat::pdf, "pdf", ".pdf", pdf_writer},
                                                     {ReportFormat::csv, "csv", ".csv", csv_writer},
                                                     {ReportFormat::xlsx, "xlsx", ".xlsx", xlsx_writer},
                                                     {ReportFormat::json, "json", ".json", json_writer},
                                                     {ReportFormat::xapi, "xapi", nullptr, xapi_writer}};
static_assert(in_order(report_formats));
/// Throws InputError for an unknown name.
ReportFormat parse_report_format(const std::string& name);

/// Throw AccessDenied, StoreError. `exported`: checked as exports.
PersonReport gather_person(const database::Store& store, const database::Session& session,
                           const std::string& person_id, const std::vector<TaskDefinition>& tasks,
                           const std::string& program_version, const Curriculum* curriculum = nullptr);
AttemptPaper gather_attempt(const database::Store& store, const database::Session& session,
                            const std::string& attempt_id, const std::vector<TaskDefinition>& tasks,
                            const std::string& program_version);
/// What a cohort's report has of each person: PDF has pages, the others no more than the table.
enum class PeoplePages { none, pages };
/// What statements for a record store need of a cohort's people: the progress with its metrics, by name.
/// Reports its progress; an empty optional when it was stopped.
std::optional<std::vector<PersonReport>> gather_people(const database::Store& store,
                                                       const database::Session& session,
                                                       const std::string& cohort_id,
                                                       const std::vector<TaskDefinition>& tasks,
                                                       const std::string& program_version,
                                                       const Progress& progress = {});
/// Reports its progress; an empty optional when it was stopped.
std::optional<CohortReport> gather_cohort(const database::Store& store, const database::Session& session,
                                          const std::string& cohort_id,
                                          const std::vector<TaskDefinition>& tasks,
                                          const std::string& program_version, PeoplePages people,
                                          const Progress& progress = {},
                                          const Curriculum* curriculum = nullptr,
                                          int plan_weeks = database::usual_plan_weeks);

std::string person_json(const PersonReport& report);
std::string cohort_json(const CohortReport& report);
/// One line a value: metrics, the pathology report by level and sector, then ratings by rater and item.
std::string attempt_csv(const AttemptPaper& paper);
std::string attempt_json(const AttemptPaper& paper);
/// Written to a temporary file first. Throw StoreError (failed) when it cannot be written.
void write_person_pdf(const PersonReport& report, const std::string& path);
void write_attempt_pdf(const AttemptPaper& paper, const std::string& path);
/// False when stopped; the file is then not there.
bool write_cohort_pdf(const CohortReport& report, const std::string& path, const Progress& progress = {});

struct ReportRequest {
    std::string person_id, cohort_id, attempt_id;  ///< exactly one
    ReportFormat format = ReportFormat::pdf;
    std::string path;
    std::string home_page;                        ///< for xapi: the address that the ids of people belong to
    const Curriculum* curriculum = nullptr;       ///< null: the report has no standings
    int plan_weeks = database::usual_plan_weeks;  ///< of the pictures of a cohort
};
/// Gathers and writes; a CSV of a person or cohort gets its dictionary next to it
/// (FILE.dictionary.csv). Returns the files, none
/// when stopped.
std::vector<std::string> write_report(const database::Store& store, const database::Session& session,
                                      const ReportRequest& request, const std::vector<TaskDefinition>& tasks,
                                      const std::string& program_version, const Progress& progress = {});

/// Throws the StoreError that says why a report's file cannot be written.
[[noreturn]] void fail_output(const std::string& path, const std::system_error& error);

using database::csv_number;
using database::csv_text;

}  // namespace fulcrum::ui
