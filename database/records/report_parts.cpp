// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/report_parts.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "database/records/attempt_query.h"
#include "database/records/curricula.h"
#include "database/records/limits_in_force.h"
#include "database/records/ratings.h"
#include "database/rows/person_kind.h"

namespace fulcrum::database {

PersonName name_of(const Store& store, const std::string& person_id) {
    Query row(store.connection(), "SELECT id, login, display_name, kind, active FROM person WHERE id = ?");
    row.bind(person_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no person %1"), person_id},
                         QT_TRANSLATE_NOOP("errors", "list the people and name one of them"));
    return {row.text(0), row.text(1), row.text(2),
            person_kind_of(row.text(3), row.text(0)) != PersonKind::real, row.flag(4)};
}

namespace {

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
    // Of two equal ones the later: attempts come oldest first.
    if (attempt.points && (!row.best_points || *attempt.points >= *row.best_points)) {
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

}  // namespace

ReleasedForms released_forms(const Store& store, const Session& session, const std::string& person_id,
                             const std::string& task_id) {
    ReleasedForms released;
    if (!store.allowed(session, Operation::read_ratings, Subject::person(person_id))) return released;
    for (auto& [attempt, shown] : Ratings(store).of_person(session, person_id, task_id))
        for (RatingRow& row : shown.rows)
            if (row.released > 0) released[attempt].push_back(std::move(row));
    return released;
}

void PersonSource::add(AttemptSummary&& attempt) {
    (attempt.voided_at > 0 ? voided : attempts).push_back(std::move(attempt));
}

namespace {

/// An attempt is large: each is moved once.
void sort_by_start(std::vector<AttemptSummary>& attempts) {
    std::vector<AttemptSummary*> order;
    for (AttemptSummary& attempt : attempts) order.push_back(&attempt);
    std::sort(order.begin(), order.end(), [](const AttemptSummary* a, const AttemptSummary* b) {
        return std::tie(a->meta.started, a->meta.id) < std::tie(b->meta.started, b->meta.id);
    });
    std::vector<AttemptSummary> sorted;
    sorted.reserve(attempts.size());
    for (AttemptSummary* attempt : order) sorted.push_back(std::move(*attempt));
    attempts.swap(sorted);
}

}  // namespace

void PersonSource::sort() {
    sort_by_start(attempts);
    sort_by_start(voided);
}

std::vector<CohortRow> rows_of(const PersonSource& source, const std::vector<std::string>& tasks) {
    const PersonName& person = source.person;
    std::vector<CohortRow> rows;
    for (const std::string& task : tasks) {
        std::map<std::optional<DeviceClass>, CohortRow, ByName> by_class;
        std::map<std::optional<DeviceClass>, std::vector<const std::vector<RatingRow>*>> rated;
        for (const AttemptSummary& attempt : source.attempts) {
            if (attempt.meta.task_id != task || attempt.recorded_state == AttemptState::running) continue;
            count(by_class[attempt.meta.device_class], attempt);
            const auto found = source.released.find(attempt.meta.id);
            if (found != source.released.end()) rated[attempt.meta.device_class].push_back(&found->second);
        }
        if (by_class.empty()) by_class[std::nullopt];
        for (auto& [device_class, row] : by_class) {
            row.person_id = person.id;
            row.login = person.login;
            row.name = person.name;
            row.active = person.active;
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

Decisions decisions_of(const Store& store, const Session& session, const std::string& person_id,
                       const Curriculum& curriculum) {
    Decisions decisions = {Curricula(store).assignments(session, person_id, curriculum),
                           read_overrides(store.connection(), person_id),
                           {},
                           limits_put_in_force(store.connection())};
    if (asks_for_ratings(curriculum)) decisions.ratings = released_ratings(store.connection(), person_id);
    return decisions;
}

PersonStandings standings_of(PersonSource& source, const Curriculum& curriculum, std::int64_t at,
                             const Decisions& decisions) {
    PersonStandings standings = person_standings(source.attempts, decisions.overrides, curriculum, at,
                                                 decisions.followed, decisions.ratings, decisions.limits);
    const std::set<std::string> uncounted(standings.uncounted.begin(), standings.uncounted.end());
    for (AttemptSummary& attempt : source.attempts)
        if (attempt.counting && uncounted.count(attempt.meta.id) != 0) attempt.counting = false;
    standings.person_id = source.person.id;
    standings.login = source.person.login;
    standings.name = source.person.name;
    standings.active = source.person.active;
    // A person who cannot sign in can end none of them.
    if (!standings.active) standings.concerns.clear();
    return standings;
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
        count(overall, attempt);
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
        point.left_out = !attempt.counting && is_counting(attempt);
        point.continues = attempt.meta.origin.has_value();
        point.duration_s = attempt.duration_s;
        point.passed = attempt.passed;
        point.provisional = attempt.provisional;
        point.not_scored_because = attempt.not_scored_because;
        point.points = attempt.points;
        const auto found = source.scores.find(attempt.meta.id);
        if (found != source.scores.end()) {
            ScoreRow& score = found->second;
            provenance.add(attempt, score.metrics);
            point.pathology = pathology_of(score);
            point.metrics = std::move(score.metrics);
            point.gates = std::move(score.gates);
        } else {
            provenance.add(attempt);
        }
        if (source.metrics != nullptr) {
            const auto of_point = source.metrics->find(attempt.meta.id);
            if (of_point != source.metrics->end()) point.metrics = std::move(of_point->second);
        }
        if (const auto rated = source.released.find(attempt.meta.id); rated != source.released.end())
            point.ratings = std::move(rated->second);
        series.points.push_back(std::move(point));
    }
    for (const AttemptSummary& attempt : source.voided) {
        if (attempt.meta.task_id != task_id || attempt.recorded_state == AttemptState::running) continue;
        progress.voided.push_back({attempt.meta.id, attempt.meta.started, attempt.voided_at});
        for (const RatingRow& rating : source.released[attempt.meta.id])
            progress.voided.back().ratings.push_back(rating.id);
    }
    progress.state = overall.state;
    for (auto& [device_class, series] : by_class) progress.series.push_back(std::move(series));
    return progress;
}

namespace {

/// The tasks of a report, and after them what the person performed elsewhere.
std::vector<std::string> tasks_with_external(const std::vector<std::string>& tasks,
                                             const PersonSource& source) {
    std::set<std::string> external;
    for (const std::vector<AttemptSummary>* list : {&source.attempts, &source.voided})
        for (const AttemptSummary& attempt : *list)
            if (is_external_task(attempt.meta.task_id)) external.insert(attempt.meta.task_id);
    std::vector<std::string> all = tasks;
    all.insert(all.end(), external.begin(), external.end());
    return all;
}

}  // namespace

PersonData data_of(PersonSource& source, const PersonDataOptions& options, const Decisions& decisions,
                   std::int64_t at, Provenance& provenance) {
    PersonData data;
    data.person_id = source.person.id;
    data.login = source.person.login;
    data.name = source.person.name;
    data.synthetic = source.person.synthetic;
    const std::vector<std::string> tasks = tasks_with_external(options.tasks, source);
    if (options.curriculum != nullptr) {
        PersonStandings standings = standings_of(source, *options.curriculum, at, decisions);
        if (options.with_rows) data.standings = std::move(standings);
    }
    if (options.with_rows) data.rows = rows_of(source, tasks);
    for (const std::string& task : tasks) data.progress.push_back(progress_of(source, task, provenance));
    return data;
}

void add_tasks(std::vector<std::string>& tasks, const std::vector<AttemptSummary>& attempts) {
    std::set<std::string> found(tasks.begin(), tasks.end());
    for (const AttemptSummary& attempt : attempts) found.insert(attempt.meta.task_id);
    tasks.assign(found.begin(), found.end());
}

}  // namespace fulcrum::database
