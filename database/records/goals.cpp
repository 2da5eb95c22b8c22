// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/goals.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/metrics/metric.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

constexpr std::int64_t goal_day_ms = 86'400'000;

[[noreturn]] void refuse_goal(const Sentence& problem, const Sentence& hint) {
    throw StoreError(StoreErrorKind::bad_value, problem, hint);
}

void check_wish(const GoalWish& wish, std::int64_t today) {
    if (wish.task.size() > 32 || wish.metric.size() > 64)
        refuse_goal(QT_TRANSLATE_NOOP("errors", "the goal names a task or metric that is too long"),
                    QT_TRANSLATE_NOOP("errors", "name a task and one of its metrics"));
    if (wish.kind == GoalOf::attempts) {
        if (!(wish.target >= 1 && wish.target <= most_attempts_a_week) ||
            wish.target != std::floor(wish.target))
            refuse_goal(
                QT_TRANSLATE_NOOP("errors", "the number of attempts a week is out of range"),
                {QT_TRANSLATE_NOOP("errors", "give a whole number from 1 to %1"), most_attempts_a_week});
        if (!wish.metric.empty() || wish.due_day != 0)
            refuse_goal(QT_TRANSLATE_NOOP("errors", "a goal of attempts a week has no metric and no day"),
                        QT_TRANSLATE_NOOP("errors", "leave them out"));
        return;
    }
    const MetricDescriptor* metric = find_metric(wish.metric);
    if (wish.task.empty() || metric == nullptr || metric->direction == Direction::context)
        refuse_goal(
            {QT_TRANSLATE_NOOP("errors", "'%1' is not a metric that a goal can be set for"), wish.metric},
            QT_TRANSLATE_NOOP("errors", "choose a task and one of its metrics"));
    if (!std::isfinite(wish.target))
        refuse_goal(QT_TRANSLATE_NOOP("errors", "the value of the goal is not a number"),
                    QT_TRANSLATE_NOOP("errors", "give a number in the unit of the metric"));
    if (wish.due_day < today || wish.due_day > today + longest_goal_days)
        refuse_goal(
            QT_TRANSLATE_NOOP("errors", "the day of the goal is in the past or too far away"),
            {QT_TRANSLATE_NOOP("errors", "choose a day from today to %1 days from now"), longest_goal_days});
}

PersonalGoal read_goal(const Query& row) {
    PersonalGoal goal;
    goal.id = row.text(0);
    goal.person_id = row.text(1);
    goal.wish = {enum_of(row.text(2), goal_kinds, "kind of goal " + goal.id), row.text(3), row.text(4),
                 row.real(5), row.integer(6)};
    goal.time = row.integer(7);
    return goal;
}

const QString goal_columns =
    QString(
        "SELECT g.id, %1, g.kind, g.task_id, g.metric, g.target, g.due_day, g.time FROM personal_goal g "
        "WHERE NOT EXISTS (SELECT 1 FROM personal_goal_end e WHERE e.goal_id = g.id) AND ")
        .arg(owner_of("g.person_id"));

std::vector<PersonalGoal> open_goals(Connection& connection, const std::string& person_id) {
    Query rows(connection, goal_columns + belongs_to("g.person_id") + " ORDER BY g.time, g.id");
    rows.bind(person_id);
    std::vector<PersonalGoal> goals;
    while (rows.next()) goals.push_back(read_goal(rows));
    return goals;
}

PersonalGoal require_own_goal(const Store& store, const Session& trainee, const std::string& goal_id) {
    store.require(trainee, Operation::set_goal, Subject::person(trainee.person_id()));
    Query row(store.connection(), goal_columns + "g.id = ?");
    row.bind(goal_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found,
                         QT_TRANSLATE_NOOP("errors", "the goal was dropped or changed already"),
                         QT_TRANSLATE_NOOP("errors", "open the page again"));
    PersonalGoal goal = read_goal(row);
    store.require(trainee, Operation::set_goal, Subject::person(goal.person_id));
    return goal;
}

// What a goal says stays out of the chain's payload: the administrator reads the chain, not the goals.
std::string add_goal(const Store& store, const Session& trainee, const GoalWish& wish) {
    std::string id = random_uuid();
    Query(store.connection(),
          "INSERT INTO personal_goal (id, person_id, kind, task_id, metric, target, due_day, time) VALUES "
          "(?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(trainee.person_id())
        .bind(row_of(goal_kinds, wish.kind).name)
        .bind(wish.task)
        .bind(wish.metric)
        .bind(wish.target)
        .bind(wish.due_day)
        .bind(store.now())
        .run();
    Audit(store).append(trainee, id, "goal.set", json_object({{"person", trainee.person_id()}}),
                        {{RecordKind::goal, id}});
    return id;
}

void end_goal(const Store& store, const Session& trainee, const std::string& goal_id) {
    Query(store.connection(), "INSERT INTO personal_goal_end (goal_id, time) VALUES (?, ?)")
        .bind(goal_id)
        .bind(store.now())
        .run();
    Audit(store).append(trainee, goal_id, "goal.drop", json_object({{"person", trainee.person_id()}}),
                        {{RecordKind::goal_end, goal_id}});
}

/// Attempts that have ended and are not voided; with the metric, those that were completed have its worst
/// row as their value, as a gate would judge it: of some metrics with a sign the size. Values of two versions
/// of a metric are not of one measure: those of the newest one that occurs by the day of the goal count.
std::vector<GoalAttempt> attempts_for(Connection& connection, const PersonalGoal& goal, bool higher) {
    Query rows(
        connection,
        "SELECT a.id, a.started, a.utc_offset_min, m.value, m.version FROM attempt a LEFT JOIN score s ON "
        "s.attempt_id = a.id AND s.in_force = 1 AND a.state = 'completed' LEFT JOIN metric m ON "
        "m.score_id = s.id AND m.id = ? WHERE " +
            belongs_to("a.person_id") +
            " AND ? IN ('', a.task_id) AND a.state <> "
            "'running' AND NOT EXISTS (SELECT 1 FROM attempt_void v WHERE v.attempt_id = a.id) ORDER BY "
            "a.started, a.id");
    rows.bind(goal.wish.metric).bind(goal.person_id).bind(goal.wish.task);
    const MetricDescriptor* metric = find_metric(goal.wish.metric);
    std::vector<GoalAttempt> attempts;
    std::string last;
    std::int64_t newest = 0;
    while (rows.next()) {
        if (attempts.empty() || rows.text(0) != last) {
            last = rows.text(0);
            attempts.push_back(
                {rows.integer(1), day_at(rows.integer(1), static_cast<int>(rows.integer(2))), {}});
        }
        std::optional<double>& value = attempts.back().value;
        const bool in_time = goal.wish.due_day == 0 || attempts.back().day <= goal.wish.due_day;
        if (rows.is_null(3) || !in_time || rows.integer(4) < newest) continue;
        if (rows.integer(4) > newest)
            for (GoalAttempt& older : attempts) older.value.reset();
        newest = rows.integer(4);
        const double one = metric == nullptr ? rows.real(3) : gated_value(*metric, rows.real(3));
        value = !value ? one : higher ? std::min(*value, one) : std::max(*value, one);
    }
    return attempts;
}

bool higher_is_better(const GoalWish& wish) {
    const MetricDescriptor* metric = find_metric(wish.metric);
    return metric != nullptr && metric->direction == Direction::higher;
}

}  // namespace

std::int64_t monday_of(std::int64_t day) {
    const std::int64_t weekday = ((day + 3) % 7 + 7) % 7;  // day 0 was a Thursday
    return day - weekday;
}

std::int64_t day_at(std::int64_t utc_ms, int utc_offset_min) {
    const std::int64_t local = utc_ms + std::int64_t{60000} * utc_offset_min;
    return local >= 0 ? local / goal_day_ms : -((-local + goal_day_ms - 1) / goal_day_ms);
}

GoalProgress goal_progress(const PersonalGoal& goal, const std::vector<GoalAttempt>& attempts,
                           std::int64_t today, bool higher) {
    GoalProgress progress;
    progress.goal = goal;
    const double target = goal.wish.target;
    if (goal.wish.kind == GoalOf::attempts) {
        const std::int64_t monday = monday_of(today);
        for (const GoalAttempt& one : attempts)
            if (one.day >= monday && one.day < monday + 7) ++progress.done;
        progress.days_left = monday + 7 - today;
        progress.reached = progress.done >= target;
        progress.share = std::min(1.0, progress.done / target);
        return progress;
    }
    std::int64_t latest_before = 0, first_since = 0;
    std::optional<double> first;
    for (const GoalAttempt& one : attempts) {
        if (!one.value) continue;
        if (one.started < goal.time) {
            if (!progress.start || one.started >= latest_before) progress.start = one.value;
            latest_before = std::max(latest_before, one.started);
        } else if (one.day <= goal.wish.due_day) {
            if (!first || one.started < first_since) {
                first = one.value;
                first_since = one.started;
            }
            if (!progress.best || (higher ? *one.value > *progress.best : *one.value < *progress.best))
                progress.best = one.value;
        }
    }
    progress.days_left = std::max<std::int64_t>(0, goal.wish.due_day - today + 1);
    progress.reached = progress.best && (higher ? *progress.best >= target : *progress.best <= target);
    progress.missed = !progress.reached && progress.days_left == 0;
    if (progress.reached) {
        progress.share = 1;
    } else if (progress.best) {
        // The part of the way from where the trainee was; 1 is kept for a goal that is reached.
        const double from = progress.start.value_or(*first), whole = target - from;
        const double part = whole == 0 ? 0 : (*progress.best - from) / whole;
        progress.share = std::clamp(part, 0.0, 0.99);
    }
    return progress;
}

std::string Goals::set(const Session& trainee, const GoalWish& wish, std::int64_t today) const {
    store_.require(trainee, Operation::set_goal, Subject::person(trainee.person_id()));
    check_wish(wish, today);
    Transaction transaction(store_.connection());
    if (open_goals(store_.connection(), trainee.person_id()).size() >= most_goals)
        throw StoreError(
            StoreErrorKind::conflict,
            {QT_TRANSLATE_NOOP("errors", "you have %1 goals already"), static_cast<int>(most_goals)},
            QT_TRANSLATE_NOOP("errors", "change or drop one of them"));
    std::string id = add_goal(store_, trainee, wish);
    transaction.commit();
    return id;
}

std::string Goals::change(const Session& trainee, const std::string& goal_id, const GoalWish& wish,
                          std::int64_t today) const {
    check_wish(wish, today);
    Transaction transaction(store_.connection());
    require_own_goal(store_, trainee, goal_id);
    end_goal(store_, trainee, goal_id);
    std::string id = add_goal(store_, trainee, wish);
    transaction.commit();
    return id;
}

void Goals::drop(const Session& trainee, const std::string& goal_id) const {
    Transaction transaction(store_.connection());
    require_own_goal(store_, trainee, goal_id);
    end_goal(store_, trainee, goal_id);
    transaction.commit();
}

std::vector<PersonalGoal> Goals::of_person(const Session& session, const std::string& person_id) const {
    store_.require(session, Operation::read_goals, Subject::person(person_id));
    return open_goals(store_.connection(), person_id);
}

std::vector<GoalProgress> Goals::progress(const Session& session, const std::string& person_id,
                                          std::int64_t today) const {
    std::vector<GoalProgress> result;
    for (const PersonalGoal& goal : of_person(session, person_id)) {
        const bool higher = higher_is_better(goal.wish);
        result.push_back(goal_progress(goal, attempts_for(store_.connection(), goal, higher), today, higher));
    }
    return result;
}

std::optional<double> Goals::latest_value(const Session& session, const std::string& person_id,
                                          const std::string& task, const std::string& metric) const {
    store_.require(session, Operation::read_goals, Subject::person(person_id));
    PersonalGoal asked;
    asked.person_id = person_id;
    asked.wish.task = task;
    asked.wish.metric = metric;
    std::optional<double> latest;
    for (const GoalAttempt& one : attempts_for(store_.connection(), asked, higher_is_better(asked.wish)))
        if (one.value) latest = one.value;
    return latest;
}

}  // namespace fulcrum::database
