// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report.h"

#include <QDateTime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "assessment/metrics/statement_words.h"
#include "database/records/people.h"
#include "database/rows/crypto.h"
#include "database/store/audit.h"
#include "database/store/store_owner.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "ui/reports/report_rows.h"
#include "ui/reports/report_writer.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

std::vector<ReportTask> titles_of(const std::vector<std::string>& ids,
                                  const std::vector<TaskDefinition>& tasks) {
    std::vector<ReportTask> titles;
    for (const std::string& id : ids) {
        ReportTask shown{id, id, ""};
        for (const TaskDefinition& task : tasks) {
            if (task.id == id) shown = {id, task.title, task.stage};
        }
        titles.push_back(std::move(shown));
    }
    return titles;
}

std::vector<std::string> ids_of(const std::vector<TaskDefinition>& tasks) {
    std::vector<std::string> ids;
    for (const TaskDefinition& task : tasks) ids.push_back(task.id);
    return ids;
}

void require_not_the_store(const std::string& path, const database::Store& store) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(path, store.path(), ignored)) return;
    throw database::StoreError(database::StoreErrorKind::bad_value,
                               {QT_TRANSLATE_NOOP("errors", "%1: this file is the store itself"), path},
                               QT_TRANSLATE_NOOP("errors", "choose another name for the report"));
}

}  // namespace

std::string why_not_scored(const Statement& because, bool continues) {
    return continues ? database::never_scored_words : words_of(because);
}

void fail_output(const std::string& path, const std::system_error& error) {
    throw database::StoreError(
        database::StoreErrorKind::failed,
        {QT_TRANSLATE_NOOP("errors", "%1: the report cannot be written (%2)"), path, error.code().message()},
        QT_TRANSLATE_NOOP("errors", "choose another folder or free some space"));
}

std::string tamper_evidence(const ReportProvenance& provenance) {
    return provenance.tamper_evident ? "a service account owns the store"
                                     : "not tamper-evident: see Who can change the store in docs/MANUAL.md";
}

ReportProvenance provenance_of(const database::Store& store, const database::Session& session,
                               const std::string& program_version) {
    ReportProvenance provenance;
    provenance.programme = store.programme_name();
    provenance.program_version = program_version;
    provenance.as_of = store.now();
    provenance.made_by = session.display_name().empty() ? session.login() : session.display_name();
    provenance.made_as = database::role_name(session.role());
    provenance.demo = store.is_demo();
    provenance.station_key = database::Audit(store).signing_key();
    provenance.program_digest = database::program_digest();
    provenance.tamper_evident = database::owned_by_service_account(store);
    return provenance;
}

const TaskStanding* standing_in(const database::CohortTable& table, const std::string& person_id,
                                const std::string& task_id) {
    for (const database::PersonStandings& person : table.standings) {
        if (person.person_id != person_id || person.not_here) continue;
        for (const auto* tasks : {&person.tasks, &person.own_tasks})
            for (const database::PersonTask& task : *tasks)
                if (task.standing.task == task_id) return &task.standing;
    }
    return nullptr;
}

ReportFormat parse_report_format(const std::string& name) {
    if (const ReportFormatRow* row = find_row(report_formats, name)) return row->kind;
    throw InputError(QT_TRANSLATE_NOOP("errors", "command line"), "--format",
                     {QT_TRANSLATE_NOOP("errors", "unknown report format \"%1\""), name},
                     {QT_TRANSLATE_NOOP("errors", "use one of %1"), names_of(report_formats)});
}

namespace {

PersonReport report_of(database::PersonData data, ReportProvenance provenance,
                       const std::vector<TaskDefinition>& tasks) {
    PersonReport report;
    report.provenance = std::move(provenance);
    take_basis(report.provenance, data);
    report.person_id = std::move(data.person_id);
    report.login = std::move(data.login);
    report.name = std::move(data.name);
    report.synthetic = data.synthetic;
    report.tasks = titles_of(ids_of(tasks), tasks);
    report.rows = std::move(data.rows);
    report.progress = std::move(data.progress);
    report.standings = std::move(data.standings);
    return report;
}

}  // namespace

PersonReport gather_person(const database::Store& store, const database::Session& session,
                           const std::string& person_id, const std::vector<TaskDefinition>& tasks,
                           const std::string& program_version, const Curriculum* curriculum) {
    return report_of(database::Reports(store).person_data(session, person_id, {ids_of(tasks), curriculum}),
                     provenance_of(store, session, program_version), tasks);
}

std::optional<CohortReport> gather_cohort(const database::Store& store, const database::Session& session,
                                          const std::string& cohort_id,
                                          const std::vector<TaskDefinition>& tasks,
                                          const std::string& program_version, PeoplePages people,
                                          const Progress& progress, const Curriculum* curriculum,
                                          int plan_weeks) {
    CohortReport report;
    report.provenance = provenance_of(store, session, program_version);
    database::CohortTableOptions options;
    options.tasks = ids_of(tasks);
    options.curriculum = curriculum;
    const auto take_table = [&](database::CohortTable&& table) {
        report.table = std::move(table);
        report.tasks = titles_of(report.table.tasks, tasks);
        report.provenance.as_of = report.table.as_of;
        take_basis(report.provenance, report.table);
        report.curriculum = curriculum;
        if (curriculum == nullptr) return;
        const std::int64_t at = report.table.as_of;
        const int offset_s = QDateTime::fromMSecsSinceEpoch(at).offsetFromUtc();
        report.dashboard =
            database::dashboard_of(report.table.standings, *curriculum, {at, offset_s / 60, plan_weeks});
    };
    const database::Reports reports(store);
    if (people == PeoplePages::none) {
        take_table(reports.cohort_table(session, cohort_id, options, database::ReportPurpose::exported));
        return report;
    }
    database::PersonDataOptions pages;
    pages.tasks = ids_of(tasks);
    pages.curriculum = curriculum;
    pages.detail = database::PointDetail::none;
    auto table = reports.table_with_people(
        session, cohort_id, options, pages,
        [&](const database::CohortTable& whole, database::PersonData&& data, double done) {
            ReportProvenance provenance = report.provenance;
            provenance.as_of = whole.as_of;
            report.people.push_back(report_of(std::move(data), std::move(provenance), tasks));
            return !progress || progress(0.5 * done, {});
        });
    if (!table) return std::nullopt;
    take_table(std::move(*table));
    return report;
}

std::optional<std::vector<PersonReport>> gather_people(
    const database::Store& store, const database::Session& session, const std::string& cohort_id,
    const std::vector<TaskDefinition>& tasks, const std::string& program_version, const Progress& progress) {
    const ReportProvenance provenance = provenance_of(store, session, program_version);
    database::PersonDataOptions options;
    options.tasks = ids_of(tasks);
    options.detail = database::PointDetail::metrics;
    options.with_rows = false;
    std::vector<PersonReport> people;
    const bool all = database::Reports(store).each_of_cohort(
        session, cohort_id, options, [&](database::PersonData&& data, double done) {
            people.push_back(report_of(std::move(data), provenance, tasks));
            return !progress || progress(0.5 * done, {});
        });
    if (!all) return std::nullopt;
    return people;
}

void save_report(const std::string& path, const std::string& content) {
    try {
        write_output_file(path, content, OutputFile::Existing::replace, OutputFile::Access::owner_only);
    } catch (const std::system_error& error) {
        fail_output(path, error);
    }
}

ReportFiles ReportWriter::write_attempt(const AttemptPaper&, const ReportRequest& request) const {
    throw InputError(QT_TRANSLATE_NOOP("errors", "command line"), "--format",
                     {QT_TRANSLATE_NOOP("errors", "one attempt has no report in the format %1"),
                      row_of(report_formats, request.format).name},
                     QT_TRANSLATE_NOOP("errors", "use pdf, csv or json, or name a person or a cohort"));
}

std::optional<CohortReport> gather_cohort(const ReportSource& source, const ReportRequest& request,
                                          PeoplePages people, const Progress& progress) {
    return gather_cohort(source.store, source.session, request.cohort_id, source.tasks,
                         source.program_version, people, progress, request.curriculum, request.plan_weeks);
}

std::vector<std::string> write_report(const database::Store& store, const database::Session& session,
                                      const ReportRequest& request, const std::vector<TaskDefinition>& tasks,
                                      const std::string& program_version, const Progress& progress) {
    require_not_the_store(request.path, store);
    const ReportWriter& writer = row_of(report_formats, request.format).writer();
    writer.check(request);
    const auto stopped = [&](double done) { return progress && !progress(done, {}); };
    if (!request.attempt_id.empty()) {
        const AttemptPaper paper = gather_attempt(store, session, request.attempt_id, tasks, program_version);
        return stopped(0.5) ? ReportFiles() : writer.write_attempt(paper, request);
    }
    if (!request.person_id.empty()) {
        if (stopped(0.1)) return {};
        const PersonReport report =
            gather_person(store, session, request.person_id, tasks, program_version, request.curriculum);
        return stopped(0.6) ? ReportFiles() : writer.write_person(report, request);
    }
    return writer.write_cohort({store, session, tasks, program_version}, request, progress);
}

}  // namespace fulcrum::ui
