// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of a cohort: its attempts are read once, whatever is made of them.
#include <algorithm>
#include <map>
#include <set>

#include "database/records/attempt_query.h"
#include "database/records/curricula.h"
#include "database/records/limits_in_force.h"
#include "database/records/report_data.h"
#include "database/records/report_parts.h"
#include "database/rows/person_kind.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

/// Of whom there are ratings at all: most people have none, and each would be asked for.
std::set<std::string> rated_people(const Store& store) {
    Query rows(store.connection(), "SELECT DISTINCT " + owner_of("a.person_id") +
                                       " FROM rating r JOIN attempt a ON a.id = r.attempt_id");
    std::set<std::string> people;
    while (rows.next()) people.insert(rows.text(0));
    return people;
}

/// Condition with one `?`, the cohort: what `column` names belongs to a member.
QString belongs_to_cohort(const QString& column) {
    return column + " IN (SELECT same.person_id FROM " + person_owners +
           " same WHERE same.owner_id IN (SELECT m.person_id FROM cohort_member m WHERE m.cohort_id = ?))";
}

/// Of all members, in as many queries as for one, and one more each where ratings are asked for.
std::map<std::string, Decisions> decisions_in(const Store& store, const Session& session,
                                              const std::string& cohort_id, const Curriculum& curriculum,
                                              const std::map<std::string, BegunWith>& begun_with) {
    std::map<std::string, Decisions> result;
    for (auto& [person, followed] :
         Curricula(store).assignments_in(session, cohort_id, curriculum, begun_with))
        result[person].followed = std::move(followed);
    const std::vector<LimitsPutInForce> limits = limits_put_in_force(store.connection());
    for (auto& [person, decisions] : result) decisions.limits = limits;
    for (OverrideRow& row : read_overrides(store.connection(), {})) {
        const auto person = result.find(row.owner_id);
        if (person != result.end()) person->second.overrides.push_back(std::move(row));
    }
    if (asks_for_ratings(curriculum))
        for (auto& [person, decisions] : result)
            decisions.ratings = released_ratings(store.connection(), person);
    return result;
}

/// Members by name.
std::vector<PersonName> members_of(const Store& store, const std::string& cohort_id) {
    Query rows(
        store.connection(),
        "SELECT p.id, p.login, p.display_name, p.kind, p.active FROM cohort_member m "
        "JOIN person p ON p.id = m.person_id WHERE m.cohort_id = ? ORDER BY p.display_name, p.login_key");
    rows.bind(cohort_id);
    std::vector<PersonName> people;
    while (rows.next())
        people.push_back({rows.text(0), rows.text(1), rows.text(2),
                          person_kind_of(rows.text(3), rows.text(0)) != PersonKind::real, rows.flag(4)});
    return people;
}

std::string cohort_name(const Store& store, const std::string& cohort_id) {
    Query name(store.connection(), "SELECT name FROM cohort WHERE id = ?");
    name.bind(cohort_id);
    if (!name.next())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no cohort %1"), cohort_id},
                         QT_TRANSLATE_NOOP("errors", "list the cohorts and name one of them"));
    return name.text(0);
}

enum class Voided { left_out, read };

/// A cohort's members with their attempts and what was decided about them.
class CohortSource {
  public:
    CohortSource(const Store& store, const Session& session, const std::string& cohort_id,
                 const Curriculum* curriculum, ReportPurpose purpose, Voided voided);
    CohortTable table(const CohortTableOptions& options);
    /// As Reports::each_of_cohort.
    bool each(const PersonDataOptions& options, const std::function<bool(PersonData&&, double)>& visit);

  private:
    const Store& store_;
    std::string cohort_id_;
    ReportPurpose purpose_;
    std::set<std::string> copies_;  ///< of reassigned attempts
    std::int64_t as_of_ = store_.now();
    std::vector<PersonSource> people_;  ///< by name
    std::map<std::string, Decisions> decisions_;
};

CohortSource::CohortSource(const Store& store, const Session& session, const std::string& cohort_id,
                           const Curriculum* curriculum, ReportPurpose purpose, Voided voided)
    : store_(store),
      cohort_id_(cohort_id),
      purpose_(purpose),
      copies_(copies_among(store, belongs_to_cohort("a.person_id"), cohort_id)) {
    std::map<std::string, PersonSource*> by_id;
    std::vector<PersonName> members = members_of(store, cohort_id);
    people_.reserve(members.size());
    for (PersonName& member : members) {
        people_.emplace_back().person = std::move(member);
        by_id.emplace(people_.back().person.id, &people_.back());
    }
    AttemptFilter filter;
    filter.cohort_id = cohort_id;
    filter.include_voided = voided == Voided::read;
    filter.limit = -1;
    filter.for_table = true;
    for_each_attempt(store, session, filter, [&](AttemptSummary&& attempt) {
        const auto person = by_id.find(attempt.meta.person_id);
        if (person != by_id.end()) person->second->add(std::move(attempt));
    });
    const std::set<std::string> rated =
        purpose == ReportPurpose::exported ? rated_people(store) : std::set<std::string>();
    for (PersonSource& person : people_) {
        person.sort();
        if (rated.count(person.person.id) != 0)
            person.released = released_forms(store, session, person.person.id);
    }
    if (curriculum == nullptr) return;
    std::map<std::string, BegunWith> begun_with;
    for (const PersonSource& person : people_) {
        BegunWith& begun = begun_with[person.person.id];
        const auto first = std::find_if(person.attempts.begin(), person.attempts.end(), decides_curriculum);
        if (first != person.attempts.end()) {
            begun.curriculum = first->meta.curriculum;
            begun.since = first->meta.started;
        }
        begun.has_copies = std::any_of(
            person.attempts.begin(), person.attempts.end(),
            [this](const AttemptSummary& attempt) { return copies_.count(attempt.meta.id) != 0; });
    }
    decisions_ = decisions_in(store, session, cohort_id, *curriculum, begun_with);
}

CohortTable CohortSource::table(const CohortTableOptions& options) {
    CohortTable table;
    table.cohort_id = cohort_id_;
    table.cohort_name = cohort_name(store_, cohort_id_);
    table.as_of = as_of_;
    table.tasks = options.tasks;
    const bool with_synthetic = options.include_synthetic || store_.is_demo();
    std::vector<PersonSource*> shown;
    for (PersonSource& person : people_) {
        if (person.person.synthetic && !with_synthetic) {
            ++table.left_out_synthetic;
            continue;
        }
        shown.push_back(&person);
        ++(person.person.active ? table.people : table.deactivated);
        if (options.tasks.empty()) add_tasks(table.tasks, person.attempts);
    }
    // A screen names the sets, and a report every file.
    Provenance provenance(
        store_, belongs_to_cohort("a.person_id"), cohort_id_,
        purpose_ == ReportPurpose::exported ? Provenance::Kinds::all : Provenance::Kinds::benchmark_sets,
        copies_);
    for (PersonSource* person : shown) {
        if (options.curriculum != nullptr)
            table.standings.push_back(
                standings_of(*person, *options.curriculum, table.as_of, decisions_[person->person.id]));
        for (CohortRow& row : rows_of(*person, table.tasks)) table.rows.push_back(std::move(row));
        for (const AttemptSummary& attempt : person->attempts)
            if (attempt.counting) provenance.add(attempt);
    }
    if (options.curriculum != nullptr) table.curriculum = options.curriculum->name();
    provenance.write(table);
    return table;
}

bool CohortSource::each(const PersonDataOptions& options,
                        const std::function<bool(PersonData&&, double)>& visit) {
    const std::string head = Audit(store_).head();
    std::unordered_map<std::string, std::vector<MetricRow>> metrics;
    if (options.detail == PointDetail::metrics)
        metrics = read_metrics_in_force(store_.connection(), belongs_to_cohort("a.person_id"), {cohort_id_});
    for (std::size_t i = 0; i < people_.size(); ++i) {
        PersonSource& source = people_[i];
        const std::string& id = source.person.id;
        if (source.person.synthetic && !store_.is_demo()) continue;
        if (options.detail == PointDetail::all)
            source.scores = read_scores_in_force(store_.connection(), belongs_to("a.person_id"), {id});
        source.metrics = &metrics;
        Provenance provenance(store_, belongs_to("a.person_id"), id, Provenance::Kinds::all, copies_);
        PersonData data = data_of(source, options, decisions_[id], as_of_, provenance);
        if (options.with_rows) provenance.write(data, head);
        const double done = static_cast<double>(i + 1) / static_cast<double>(people_.size());
        if (!visit(std::move(data), done)) return false;
    }
    return true;
}

void require_people(const Store& store, const Session& session, const std::string& cohort_id) {
    store.require(session, Operation::export_cohort, Subject::cohort(cohort_id));
    store.require(session, Operation::export_person);
    if (scope_of(session.role(), Operation::export_person) != Scope::programme)
        throw AccessDenied(operation_name(Operation::export_person), role_name(session.role()),
                           DenialReason::outside_people);
}

}  // namespace

CohortTable Reports::cohort_table(const Session& session, const std::string& cohort_id,
                                  const CohortTableOptions& options, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_cohort : Operation::read_cohort_table;
    store_.require(session, operation, Subject::cohort(cohort_id));
    return CohortSource(store_, session, cohort_id, options.curriculum, purpose, Voided::left_out)
        .table(options);
}

bool Reports::each_of_cohort(const Session& session, const std::string& cohort_id,
                             const PersonDataOptions& options,
                             const std::function<bool(PersonData&&, double)>& visit) const {
    require_people(store_, session, cohort_id);
    return CohortSource(store_, session, cohort_id, options.curriculum, ReportPurpose::exported, Voided::read)
        .each(options, visit);
}

std::optional<CohortTable> Reports::table_with_people(
    const Session& session, const std::string& cohort_id, const CohortTableOptions& options,
    const PersonDataOptions& people,
    const std::function<bool(const CohortTable&, PersonData&&, double)>& visit) const {
    require_people(store_, session, cohort_id);
    CohortSource source(store_, session, cohort_id, options.curriculum, ReportPurpose::exported,
                        Voided::read);
    CohortTable table = source.table(options);
    const bool all = source.each(
        people, [&](PersonData&& data, double done) { return visit(table, std::move(data), done); });
    return all ? std::optional<CohortTable>(std::move(table)) : std::nullopt;
}

}  // namespace fulcrum::database
