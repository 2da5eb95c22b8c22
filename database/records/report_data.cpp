// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_data.h"

#include "database/records/attempt_query.h"
#include "database/records/report_parts.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

PersonSource source_of(const Store& store, const Session& session, const AttemptFilter& filter) {
    PersonSource source;
    source.person = name_of(store, filter.person_id);
    for (AttemptSummary& attempt : query_attempts(store, session, filter)) source.add(std::move(attempt));
    source.sort();
    return source;
}

}  // namespace

const char* task_state_name(TaskState state) {
    switch (state) {
        case TaskState::open:
            return "open";
        case TaskState::attempted:
            return "attempted";
        case TaskState::passed:
            return "passed";
    }
    return "";
}

PersonStandings Reports::standings(const Session& session, const std::string& person_id,
                                   const Curriculum& curriculum, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    PersonSource source = source_of(store_, session, all_of_person(person_id));
    return standings_of(source, curriculum, store_.now(),
                        decisions_of(store_, session, person_id, curriculum));
}

PersonProgress Reports::person_progress(const Session& session, const std::string& person_id,
                                        const std::string& task_id, ReportPurpose purpose,
                                        const Curriculum* curriculum) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    AttemptFilter filter = all_of_person(person_id);
    // Other tasks decide whether this one was unlocked.
    if (curriculum == nullptr) filter.task_id = task_id;
    filter.include_voided = true;
    PersonSource source = source_of(store_, session, filter);
    if (curriculum != nullptr)
        standings_of(source, *curriculum, store_.now(),
                     decisions_of(store_, session, person_id, *curriculum));
    source.scores = read_scores_in_force(
        store_.connection(), belongs_to("a.person_id") + " AND a.task_id = ?", {person_id, task_id});
    if (purpose == ReportPurpose::exported)
        source.released = released_forms(store_, session, person_id, task_id);
    Provenance provenance(store_, belongs_to("a.person_id"), person_id);
    PersonProgress progress = progress_of(source, task_id, provenance);
    provenance.write(progress);
    return progress;
}

PersonData Reports::person_data(const Session& session, const std::string& person_id,
                                const PersonDataOptions& options) const {
    store_.require(session, Operation::export_person, Subject::person(person_id));
    AttemptFilter filter = all_of_person(person_id);
    filter.include_voided = true;
    PersonSource source = source_of(store_, session, filter);
    source.released = released_forms(store_, session, person_id);
    if (options.detail != PointDetail::none)
        source.scores = read_scores_in_force(store_.connection(), belongs_to("a.person_id"), {person_id});
    Decisions decisions;
    if (options.curriculum != nullptr)
        decisions = decisions_of(store_, session, person_id, *options.curriculum);
    Provenance provenance(store_, belongs_to("a.person_id"), person_id);
    PersonData data = data_of(source, options, decisions, store_.now(), provenance);
    provenance.write(data);
    return data;
}

std::vector<CohortRow> Reports::person_table(const Session& session, const std::string& person_id,
                                             const std::vector<std::string>& tasks, ReportPurpose purpose,
                                             const Curriculum* curriculum) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    PersonSource source = source_of(store_, session, all_of_person(person_id));
    if (curriculum != nullptr)
        standings_of(source, *curriculum, store_.now(),
                     decisions_of(store_, session, person_id, *curriculum));
    std::vector<std::string> columns = tasks;
    if (columns.empty()) add_tasks(columns, source.attempts);
    if (purpose == ReportPurpose::exported) source.released = released_forms(store_, session, person_id);
    return rows_of(source, columns);
}

}  // namespace fulcrum::database
