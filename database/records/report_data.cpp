// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "database/records/attempt_query.h"
#include "database/records/attempts.h"
#include "database/records/curricula.h"
#include "database/records/ratings.h"
#include "database/rows/person_kind.h"
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

/// Versions that the values are based on, gathered over the attempts that enter them.
class Provenance {
  public:
    explicit Provenance(const Store& store) : store_(store) {}
    void add(const AttemptSummary& attempt) {
        const AttemptMeta& meta = attempt.meta;
        programs_.insert(meta.program_version);
        if (!meta.limits.empty()) sets_.insert(meta.limits);
        // One program gives one set of metric versions for a task: asked once, not for every attempt.
        const std::array<std::string, 4> key{meta.program_version, meta.task_id,
                                             std::to_string(meta.task_version),
                                             row_of(device_classes, meta.device_class).name};
        if (seen_.count(key) > 0) return;
        Query rows(store_.connection(),
                   "SELECT DISTINCT m.id, m.version FROM metric m JOIN score s ON s.id = m.score_id "
                   "WHERE s.attempt_id = ? AND s.in_force = 1");
        rows.bind(attempt.meta.id);
        while (rows.next()) {
            metrics_.insert(rows.text(0) + "@" + rows.text(1));
            seen_.insert(key);
        }
    }
    template <typename Report>
    void write(Report& report) const {
        report.metric_versions.assign(metrics_.begin(), metrics_.end());
        report.benchmark_sets = named_sets();
        report.program_versions.assign(programs_.begin(), programs_.end());
        report.audit_head = Audit(store_).head();
    }

  private:
    /// With the beginning of the SHA-256 of each set's file, as assessed attempts used it: a name alone says
    /// nothing about the limits.
    std::vector<std::string> named_sets() const {
        std::map<std::string, std::set<std::string>> digests;
        Query rows(store_.connection(),
                   "SELECT DISTINCT a.limits, f.digest FROM attempt_asset f JOIN attempt a ON a.id = "
                   "f.attempt_id WHERE a.mode = 'assessed' AND substr(f.file, 1, 11) = 'benchmarks/'");
        while (rows.next()) digests[rows.text(0)].insert(rows.text(1).substr(0, 16));
        std::vector<std::string> sets;
        for (const std::string& name : sets_) {
            const auto known = digests.find(name);
            if (known == digests.end()) {
                sets.push_back(name);
                continue;
            }
            for (const std::string& digest : known->second) sets.push_back(name + " sha256:" + digest);
        }
        return sets;
    }

    const Store& store_;
    std::set<std::string> metrics_, sets_, programs_;
    std::set<std::array<std::string, 4>> seen_;
};

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

PersonStandings standings_of(const Store& store, const Session& session, const PersonName& person,
                             const std::vector<AttemptSummary>& attempts, const Curriculum& curriculum,
                             std::int64_t at) {
    const std::vector<CurriculumAssignment> followed =
        Curricula(store).assignments(session, person.id, curriculum);
    PersonStandings standings =
        person_standings(attempts, read_overrides(store.connection(), person.id), curriculum, at, followed,
                         asks_for_ratings(curriculum) ? released_ratings(store.connection(), person.id)
                                                      : std::vector<ReleasedRating>());
    standings.person_id = person.id;
    standings.login = person.login;
    standings.name = person.name;
    return standings;
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
    std::vector<PersonName> people;
    {
        Query name(store_.connection(), "SELECT name FROM cohort WHERE id = ?");
        name.bind(cohort_id);
        if (!name.next())
            throw StoreError(StoreErrorKind::not_found,
                             {QT_TRANSLATE_NOOP("errors", "no cohort %1"), cohort_id},
                             QT_TRANSLATE_NOOP("errors", "list the cohorts and name one of them"));
        table.cohort_name = name.text(0);
        Query rows(
            store_.connection(),
            "SELECT p.id, p.login, p.display_name, p.kind FROM cohort_member m "
            "JOIN person p ON p.id = m.person_id WHERE m.cohort_id = ? ORDER BY p.display_name, p.login_key");
        rows.bind(cohort_id);
        while (rows.next())
            people.push_back({rows.text(0), rows.text(1), rows.text(2),
                              person_kind_of(rows.text(3), rows.text(0)) != PersonKind::real});
    }
    const bool with_synthetic = options.include_synthetic || store_.is_demo();
    std::vector<PersonName> shown;
    std::vector<std::vector<AttemptSummary>> attempts;
    Provenance provenance(store_);
    for (PersonName& person : people) {
        if (person.synthetic && !with_synthetic) {
            ++table.left_out_synthetic;
            continue;
        }
        attempts.push_back(query_attempts(store_, session, all_of_person(person.id)));
        shown.push_back(std::move(person));
        if (options.tasks.empty()) add_tasks(table.tasks, attempts.back());
    }
    table.people = static_cast<int>(shown.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const ReleasedForms released = purpose == ReportPurpose::exported
                                           ? released_forms(store_, session, shown[i].id)
                                           : ReleasedForms();
        for (CohortRow& row : rows_of(shown[i], table.tasks, attempts[i], released))
            table.rows.push_back(std::move(row));
        for (const AttemptSummary& attempt : attempts[i]) {
            if (attempt.counting) provenance.add(attempt);
        }
        if (options.curriculum != nullptr)
            table.standings.push_back(
                standings_of(store_, session, shown[i], attempts[i], *options.curriculum, table.as_of));
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
    return standings_of(store_, session, name_of(store_, person_id),
                        query_attempts(store_, session, all_of_person(person_id)), curriculum, store_.now());
}

PersonProgress Reports::person_progress(const Session& session, const std::string& person_id,
                                        const std::string& task_id, ReportPurpose purpose) const {
    const Operation operation =
        purpose == ReportPurpose::exported ? Operation::export_person : Operation::read_progress;
    store_.require(session, operation, Subject::person(person_id));
    const PersonName person = name_of(store_, person_id);
    PersonProgress progress;
    progress.person_id = person.id;
    progress.login = person.login;
    progress.name = person.name;
    progress.synthetic = person.synthetic;
    progress.task_id = task_id;
    AttemptFilter filter = all_of_person(person_id);
    filter.task_id = task_id;
    filter.include_voided = true;
    std::vector<AttemptSummary> attempts = query_attempts(store_, session, filter);
    std::sort(attempts.begin(), attempts.end(), [](const AttemptSummary& a, const AttemptSummary& b) {
        return std::tie(a.meta.started, a.meta.id) < std::tie(b.meta.started, b.meta.id);
    });
    Provenance provenance(store_);
    std::map<DeviceClass, ProgressSeries, ByName> by_class;
    CohortRow overall;
    ReleasedForms released;
    if (purpose == ReportPurpose::exported) released = released_forms(store_, session, person_id, task_id);
    for (const AttemptSummary& attempt : attempts) {
        if (attempt.recorded_state == AttemptState::running) continue;
        if (attempt.voided_at > 0) {
            progress.voided.push_back({attempt.meta.id, attempt.meta.started, attempt.voided_at});
            for (const RatingRow& rating : released[attempt.meta.id])
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
        std::string score_id;
        {
            Query row(store_.connection(), "SELECT id FROM score WHERE attempt_id = ? AND in_force = 1");
            row.bind(attempt.meta.id);
            if (row.next()) score_id = row.text(0);
        }
        if (!score_id.empty()) {
            ScoreRow score = read_score(store_.connection(), score_id);
            point.pathology = pathology_of(score);
            point.metrics = std::move(score.metrics);
            point.gates = std::move(score.gates);
        }
        point.ratings = std::move(released[attempt.meta.id]);
        series.points.push_back(std::move(point));
    }
    progress.state = overall.state;
    for (auto& [device_class, series] : by_class) progress.series.push_back(std::move(series));
    provenance.write(progress);
    return progress;
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
    Provenance provenance(store_);
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
