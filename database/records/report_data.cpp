// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_data.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "database/records/attempt_query.h"
#include "database/records/attempts.h"
#include "database/records/curricula.h"
#include "database/records/ratings.h"
#include "database/records/report_provenance.h"
#include "database/rows/person_kind.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {
namespace {

struct PersonName {
    std::string id, login, name;
    bool synthetic = false;
};

PersonName name_of(const Store& store, const std::string& person_id) {
    Query row(store.connection(), "SELECT id, login, display_name, kind FROM person WHERE id = ?");
    row.bind(person_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no person %1"), person_id},
                         QT_TRANSLATE_NOOP("errors", "list the people and name one of them"));
    return {row.text(0), row.text(1), row.text(2),
            person_kind_of(row.text(3), row.text(0)) != PersonKind::real};
}

void count(CohortRow& row, const AttemptSummary& attempt) {
    row.last_attempt = std::max(row.last_attempt, attempt.meta.started);
    if (!attempt.counting) {
        ++row.not_counting;
        return;
    }
    ++row.attempts;
    if (row.state == TaskState::open) row.state = TaskState::attempted;
    if (*attempt.passed) {
        row.provisional = attempt.provisional && (row.passes == 0 || row.provisional);
        row.state = TaskState::passed;
        ++row.passes;
    }
    if (attempt.points && (!row.best_points || *attempt.points > *row.best_points)) {
        row.best_points = attempt.points;
        row.best_attempt_id = attempt.meta.id;
    }
}

/// Device classes in the order of their names, as exports list them; none first.
struct ByName {
    bool operator()(const std::optional<DeviceClass>& a, const std::optional<DeviceClass>& b) const {
        const auto name = [](const std::optional<DeviceClass>& one) {
            return std::string(one ? row_of(device_classes, *one).name : "");
        };
        return name(a) < name(b);
    }
};

/// The released forms that the session may see, by attempt.
using ReleasedForms = std::map<std::string, std::vector<RatingRow>>;
ReleasedForms released_forms(const Store& store, const Session& session, const std::string& person_id,
                             const std::string& task_id = {}) {
    ReleasedForms released;
    if (!store.allowed(session, Operation::read_ratings, Subject::person(person_id))) return released;
    for (auto& [attempt, shown] : Ratings(store).of_person(session, person_id, task_id))
        for (RatingRow& row : shown.rows)
            if (row.released > 0) released[attempt].push_back(std::move(row));
    return released;
}

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

/// One person's rows, tasks in the order given; every task has at least one row.
std::vector<CohortRow> rows_of(const PersonName& person, const std::vector<std::string>& tasks,
                               const std::vector<AttemptSummary>& attempts, const ReleasedForms& released) {
    std::vector<CohortRow> rows;
    for (const std::string& task : tasks) {
        std::map<std::optional<DeviceClass>, CohortRow, ByName> by_class;
        std::map<std::optional<DeviceClass>, std::vector<const std::vector<RatingRow>*>> rated;
        for (const AttemptSummary& attempt : attempts) {
            if (attempt.meta.task_id != task || attempt.recorded_state == AttemptState::running) continue;
            count(by_class[attempt.meta.device_class], attempt);
            const auto found = released.find(attempt.meta.id);
            if (found != released.end()) rated[attempt.meta.device_class].push_back(&found->second);
        }
        if (by_class.empty()) by_class[std::nullopt];
        for (auto& [device_class, row] : by_class) {
            row.person_id = person.id;
            row.login = person.login;
            row.name = person.name;
            row.task_id = task;
            row.device_class = device_class;
            row.ratings = rated_forms(rated[device_class]);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

AttemptFilter all_of_person(const std::string& person_id) {
    AttemptFilter filter;
    filter.person_id = person_id;
    filter.include_voided = false;
    filter.limit = -1;
    return filter;
}

/// What decides about standings apart from attempts.
struct Decisions {
    std::vector<CurriculumAssignment> followed;
    std::vector<OverrideRow> overrides;
    std::vector<ReleasedRating> ratings;  ///< empty where the curriculum asks for none
};

Decisions decisions_of(const Store& store, const Session& session, const std::string& person_id,
                       const Curriculum& curriculum) {
    Decisions decisions = {Curricula(store).assignments(session, person_id, curriculum),
                           read_overrides(store.connection(), person_id),
                           {}};
    if (asks_for_ratings(curriculum)) decisions.ratings = released_ratings(store.connection(), person_id);
    return decisions;
}

PersonStandings standings_of(const PersonName& person, const std::vector<AttemptSummary>& attempts,
                             const Curriculum& curriculum, std::int64_t at, const Decisions& decisions) {
    PersonStandings standings = person_standings(attempts, decisions.overrides, curriculum, at,
                                                 decisions.followed, decisions.ratings);
    standings.person_id = person.id;
    standings.login = person.login;
    standings.name = person.name;
    return standings;
}

/// Of all members of a cohort, in as many queries as for one, and one more each where ratings are asked for.
std::map<std::string, Decisions> decisions_in(const Store& store, const Session& session,
                                              const std::string& cohort_id, const Curriculum& curriculum) {
    std::map<std::string, Decisions> result;
    for (auto& [person, followed] : Curricula(store).assignments_in(session, cohort_id, curriculum))
        result[person].followed = std::move(followed);
    for (OverrideRow& row : read_overrides(store.connection(), {})) {
        const auto person = result.find(row.owner_id);
        if (person != result.end()) person->second.overrides.push_back(std::move(row));
    }
    if (asks_for_ratings(curriculum))
        for (auto& [person, decisions] : result)
            decisions.ratings = released_ratings(store.connection(), person);
    return result;
}

/// By person, newest first.
std::map<std::string, std::vector<AttemptSummary>> attempts_in(const Store& store, const Session& session,
                                                               const std::string& cohort_id,
                                                               bool include_voided) {
    AttemptFilter filter = all_of_person({});
    filter.cohort_id = cohort_id;
    filter.include_voided = include_voided;
    filter.for_table = true;
    std::map<std::string, std::vector<AttemptSummary>> result;
    for (AttemptSummary& attempt : query_attempts(store, session, filter)) {
        std::vector<AttemptSummary>& list = result[attempt.meta.person_id];
        list.push_back(std::move(attempt));
    }
    return result;
}

/// Members by name.
std::vector<PersonName> members_of(const Store& store, const std::string& cohort_id) {
    Query rows(
        store.connection(),
        "SELECT p.id, p.login, p.display_name, p.kind FROM cohort_member m "
        "JOIN person p ON p.id = m.person_id WHERE m.cohort_id = ? ORDER BY p.display_name, p.login_key");
    rows.bind(cohort_id);
    std::vector<PersonName> people;
    while (rows.next())
        people.push_back({rows.text(0), rows.text(1), rows.text(2),
                          person_kind_of(rows.text(3), rows.text(0)) != PersonKind::real});
    return people;
}

void add_tasks(std::vector<std::string>& tasks, const std::vector<AttemptSummary>& attempts) {
    std::set<std::string> found(tasks.begin(), tasks.end());
    for (const AttemptSummary& attempt : attempts) found.insert(attempt.meta.task_id);
    tasks.assign(found.begin(), found.end());
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

CohortTable Reports::cohort_table(const Session& session, const std::string& cohort_id,
                                  const CohortTableOptions& options, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_cohort : Operation::read_cohort_table;
    store_.require(session, operation, Subject::cohort(cohort_id));
    CohortTable table;
    table.cohort_id = cohort_id;
    table.as_of = store_.now();
    table.tasks = options.tasks;
    {
        Query name(store_.connection(), "SELECT name FROM cohort WHERE id = ?");
        name.bind(cohort_id);
        if (!name.next())
            throw StoreError(StoreErrorKind::not_found,
                             {QT_TRANSLATE_NOOP("errors", "no cohort %1"), cohort_id},
                             QT_TRANSLATE_NOOP("errors", "list the cohorts and name one of them"));
        table.cohort_name = name.text(0);
    }
    std::vector<PersonName> people = members_of(store_, cohort_id);
    const bool with_synthetic = options.include_synthetic || store_.is_demo();
    std::vector<PersonName> shown;
    std::vector<std::vector<AttemptSummary>> attempts;
    std::map<std::string, std::vector<AttemptSummary>> of_person =
        attempts_in(store_, session, cohort_id, false);
    std::map<std::string, Decisions> decisions;
    if (options.curriculum != nullptr)
        decisions = decisions_in(store_, session, cohort_id, *options.curriculum);
    MetricVersions versions(store_);
    Provenance provenance(store_, versions, belongs_to_cohort("a.person_id"), cohort_id);
    const std::set<std::string> rated =
        purpose == ReportPurpose::exported ? rated_people(store_) : std::set<std::string>();
    for (PersonName& person : people) {
        if (person.synthetic && !with_synthetic) {
            ++table.left_out_synthetic;
            continue;
        }
        attempts.push_back(std::move(of_person[person.id]));
        shown.push_back(std::move(person));
        if (options.tasks.empty()) add_tasks(table.tasks, attempts.back());
    }
    table.people = static_cast<int>(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const ReleasedForms released =
            rated.count(shown[i].id) != 0 ? released_forms(store_, session, shown[i].id) : ReleasedForms();
        for (CohortRow& row : rows_of(shown[i], table.tasks, attempts[i], released))
            table.rows.push_back(std::move(row));
        for (const AttemptSummary& attempt : attempts[i]) {
            if (attempt.counting) provenance.add(attempt);
        }
        if (options.curriculum != nullptr)
            table.standings.push_back(standings_of(shown[i], attempts[i], *options.curriculum, table.as_of,
                                                   decisions[shown[i].id]));
    }
    if (options.curriculum != nullptr) table.curriculum = options.curriculum->name();
    provenance.write(table);
    return table;
}

PersonStandings Reports::standings(const Session& session, const std::string& person_id,
                                   const Curriculum& curriculum, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    return standings_of(name_of(store_, person_id), query_attempts(store_, session, all_of_person(person_id)),
                        curriculum, store_.now(), decisions_of(store_, session, person_id, curriculum));
}

namespace {

/// What stays the same for all tasks of a person.
struct PersonSource {
    PersonName person;
    std::vector<AttemptSummary> attempts;    ///< oldest first
    std::map<std::string, ScoreRow> scores;  ///< in force, by attempt; empty: the report shows no metrics
    /// In place of scores: the metrics alone, by attempt, of more people than this one.
    std::unordered_map<std::string, std::vector<MetricRow>>* metrics = nullptr;
    ReleasedForms released;  ///< empty where the report is not to be exported
};

void sort_by_start(std::vector<AttemptSummary>& attempts) {
    std::sort(attempts.begin(), attempts.end(), [](const AttemptSummary& a, const AttemptSummary& b) {
        return std::tie(a.meta.started, a.meta.id) < std::tie(b.meta.started, b.meta.id);
    });
}

PersonProgress progress_of(PersonSource& source, const std::string& task_id, Provenance& provenance) {
    const PersonName& person = source.person;
    PersonProgress progress;
    progress.person_id = person.id;
    progress.login = person.login;
    progress.name = person.name;
    progress.synthetic = person.synthetic;
    progress.task_id = task_id;
    std::map<DeviceClass, ProgressSeries, ByName> by_class;
    CohortRow overall;
    for (const AttemptSummary& attempt : source.attempts) {
        if (attempt.meta.task_id != task_id || attempt.recorded_state == AttemptState::running) continue;
        if (attempt.voided_at > 0) {
            progress.voided.push_back({attempt.meta.id, attempt.meta.started, attempt.voided_at});
            for (const RatingRow& rating : source.released[attempt.meta.id])
                progress.voided.back().ratings.push_back(rating.id);
            continue;
        }
        count(overall, attempt);
        provenance.add(attempt);
        ProgressSeries& series = by_class[attempt.meta.device_class];
        series.device_class = attempt.meta.device_class;
        ProgressPoint point;
        point.attempt_id = attempt.meta.id;
        point.number = static_cast<int>(series.points.size()) + 1;
        point.started = attempt.meta.started;
        point.utc_offset_min = attempt.meta.utc_offset_min;
        point.mode = attempt.meta.mode;
        point.state = attempt.state;
        point.variant = attempt.meta.variant;
        point.fidelity = attempt.meta.fidelity;
        point.limits = attempt.meta.limits;
        point.counting = attempt.counting;
        point.duration_s = attempt.duration_s;
        point.passed = attempt.passed;
        point.provisional = attempt.provisional;
        point.not_scored_because = attempt.not_scored_because;
        point.points = attempt.points;
        const auto found = source.scores.find(attempt.meta.id);
        if (found != source.scores.end()) {
            ScoreRow& score = found->second;
            point.pathology = pathology_of(score);
            point.metrics = std::move(score.metrics);
            point.gates = std::move(score.gates);
        }
        if (source.metrics != nullptr) {
            const auto of_point = source.metrics->find(attempt.meta.id);
            if (of_point != source.metrics->end()) point.metrics = std::move(of_point->second);
        }
        if (const auto rated = source.released.find(attempt.meta.id); rated != source.released.end())
            point.ratings = std::move(rated->second);
        series.points.push_back(std::move(point));
    }
    progress.state = overall.state;
    for (auto& [device_class, series] : by_class) progress.series.push_back(std::move(series));
    return progress;
}

/// The tasks of a report, and after them what the person performed elsewhere.
std::vector<std::string> tasks_with_external(const std::vector<std::string>& tasks,
                                             const std::vector<AttemptSummary>& attempts) {
    std::set<std::string> external;
    for (const AttemptSummary& attempt : attempts)
        if (is_external_task(attempt.meta.task_id)) external.insert(attempt.meta.task_id);
    std::vector<std::string> all = tasks;
    all.insert(all.end(), external.begin(), external.end());
    return all;
}

/// Rows, progress and standings of one person from the same attempts.
PersonData data_of(PersonSource& source, const PersonDataOptions& options, const Decisions& decisions,
                   std::int64_t at, Provenance& provenance) {
    PersonData data;
    data.person_id = source.person.id;
    data.login = source.person.login;
    data.name = source.person.name;
    data.synthetic = source.person.synthetic;
    const std::vector<std::string> tasks = tasks_with_external(options.tasks, source.attempts);
    if (options.with_rows) {
        std::vector<AttemptSummary> standing;
        for (const AttemptSummary& attempt : source.attempts)
            if (attempt.voided_at == 0) standing.push_back(attempt);
        data.rows = rows_of(source.person, tasks, standing, source.released);
        if (options.curriculum != nullptr)
            data.standings = standings_of(source.person, standing, *options.curriculum, at, decisions);
    }
    for (const std::string& task : tasks) data.progress.push_back(progress_of(source, task, provenance));
    return data;
}

}  // namespace

PersonProgress Reports::person_progress(const Session& session, const std::string& person_id,
                                        const std::string& task_id, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    AttemptFilter filter = all_of_person(person_id);
    filter.task_id = task_id;
    filter.include_voided = true;
    PersonSource source;
    source.person = name_of(store_, person_id);
    source.attempts = query_attempts(store_, session, filter);
    source.scores = read_scores_in_force(
        store_.connection(), belongs_to("a.person_id") + " AND a.task_id = ?", {person_id, task_id});
    if (purpose == ReportPurpose::exported)
        source.released = released_forms(store_, session, person_id, task_id);
    sort_by_start(source.attempts);
    MetricVersions versions(store_);
    Provenance provenance(store_, versions, belongs_to("a.person_id"), person_id);
    PersonProgress progress = progress_of(source, task_id, provenance);
    provenance.write(progress);
    return progress;
}

PersonData Reports::person_data(const Session& session, const std::string& person_id,
                                const PersonDataOptions& options) const {
    store_.require(session, Operation::export_person, Subject::person(person_id));
    AttemptFilter filter = all_of_person(person_id);
    filter.include_voided = true;
    PersonSource source;
    source.person = name_of(store_, person_id);
    source.attempts = query_attempts(store_, session, filter);
    source.released = released_forms(store_, session, person_id);
    sort_by_start(source.attempts);
    if (options.detail != PointDetail::none)
        source.scores = read_scores_in_force(store_.connection(), belongs_to("a.person_id"), {person_id});
    Decisions decisions;
    if (options.curriculum != nullptr)
        decisions = decisions_of(store_, session, person_id, *options.curriculum);
    MetricVersions versions(store_);
    Provenance provenance(store_, versions, belongs_to("a.person_id"), person_id);
    PersonData data = data_of(source, options, decisions, store_.now(), provenance);
    provenance.write(data);
    return data;
}

bool Reports::each_of_cohort(const Session& session, const std::string& cohort_id,
                             const PersonDataOptions& options,
                             const std::function<bool(PersonData&&, double)>& visit) const {
    store_.require(session, Operation::export_cohort, Subject::cohort(cohort_id));
    store_.require(session, Operation::export_person);
    if (scope_of(session.role(), Operation::export_person) != Scope::programme)
        throw AccessDenied(operation_name(Operation::export_person), role_name(session.role()),
                           QT_TRANSLATE_NOOP("errors", "outside this role's people"));
    std::map<std::string, std::vector<AttemptSummary>> of_person =
        attempts_in(store_, session, cohort_id, true);
    std::map<std::string, Decisions> decisions;
    if (options.curriculum != nullptr)
        decisions = decisions_in(store_, session, cohort_id, *options.curriculum);
    const std::string head = Audit(store_).head();
    const std::vector<PersonName> people = members_of(store_, cohort_id);
    const std::set<std::string> rated = rated_people(store_);
    std::unordered_map<std::string, std::vector<MetricRow>> metrics;
    if (options.detail == PointDetail::metrics)
        metrics = read_metrics_in_force(store_.connection(), belongs_to_cohort("a.person_id"), {cohort_id});
    MetricVersions versions(store_);
    for (std::size_t i = 0; i < people.size(); ++i) {
        if (people[i].synthetic && !store_.is_demo()) continue;
        PersonSource source;
        source.person = people[i];
        source.attempts = std::move(of_person[people[i].id]);
        if (rated.count(people[i].id) != 0) source.released = released_forms(store_, session, people[i].id);
        sort_by_start(source.attempts);
        if (options.detail == PointDetail::all)
            source.scores =
                read_scores_in_force(store_.connection(), belongs_to("a.person_id"), {people[i].id});
        source.metrics = &metrics;
        Provenance provenance(store_, versions, belongs_to("a.person_id"), people[i].id);
        PersonData data = data_of(source, options, decisions[people[i].id], store_.now(), provenance);
        if (options.with_rows) provenance.write(data, head);
        const double done = static_cast<double>(i + 1) / static_cast<double>(people.size());
        if (!visit(std::move(data), done)) return false;
    }
    return true;
}

std::optional<PathologyReport> pathology_of(const ScoreRow& score) {
    if (score.pathology.empty()) return std::nullopt;
    return parse_pathology(score.pathology, "score " + score.id);
}

AttemptReport Reports::attempt_report(const Session& session, const std::string& attempt_id,
                                      ReportPurpose purpose) const {
    const Attempts attempts(store_);
    AttemptReport report;
    report.attempt = attempts.read(session, attempt_id);
    if (purpose == ReportPurpose::exported)
        store_.require(session, Operation::export_person, Subject::person(report.attempt.meta.person_id));
    report.score = attempts.score(session, attempt_id);
    if (report.score) report.pathology = pathology_of(*report.score);
    MetricVersions versions(store_);
    Provenance provenance(store_, versions, "a.id = ?", attempt_id);
    provenance.add(report.attempt);
    provenance.write(report);
    return report;
}

std::vector<CohortRow> Reports::person_table(const Session& session, const std::string& person_id,
                                             const std::vector<std::string>& tasks,
                                             ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    const std::vector<AttemptSummary> attempts = query_attempts(store_, session, all_of_person(person_id));
    std::vector<std::string> columns = tasks;
    if (columns.empty()) add_tasks(columns, attempts);
    const ReleasedForms released =
        purpose == ReportPurpose::exported ? released_forms(store_, session, person_id) : ReleasedForms();
    return rows_of(name_of(store_, person_id), columns, attempts, released);
}

}  // namespace fulcrum::database
