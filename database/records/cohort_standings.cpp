// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/cohort_standings.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "assessment/scoring/score.h"
#include "database/records/curricula.h"

namespace fulcrum::database {
namespace {

constexpr std::int64_t minute_ms = 60000, day_ms = 86'400'000;

std::int64_t local_day(const AttemptMeta& meta) {
    const std::int64_t local = meta.started + minute_ms * meta.utc_offset_min;
    return local >= 0 ? local / day_ms : -((-local + day_ms - 1) / day_ms);
}

/// `counting`: as PersonRecord::attempts. `points`: gets those of the device class used last. By the attempts
/// that the standing counted when they were performed: a move changes neither bars nor plateau.
PersonTask person_task(const TaskStanding& standing, const std::vector<const AttemptSummary*>& counting,
                       std::vector<double>& points) {
    PersonTask task;
    task.standing = standing;
    task.first_attempt = standing.first_attempt;
    task.first_pass = standing.first_pass;
    if (standing.counted.empty()) return task;
    const DeviceClass last = counting[standing.counted.back()]->meta.device_class;
    task.device_class = last;
    for (const std::size_t place : standing.counted) {
        const AttemptSummary& attempt = *counting[place];
        if (attempt.meta.device_class != last) continue;
        if (attempt.points) points.push_back(*attempt.points);
        task.recent.push_back(
            {attempt.meta.id, attempt.meta.started, *attempt.passed, attempt.provisional, attempt.points});
    }
    if (task.recent.size() > most_recent)
        task.recent.erase(task.recent.begin(), task.recent.end() - static_cast<std::ptrdiff_t>(most_recent));
    return task;
}

/// Of `counting`, as PersonRecord::attempts: those at tasks of `followed` that no standing counts.
std::vector<std::string> uncounted_in(const std::vector<const AttemptSummary*>& counting,
                                      const std::vector<TaskStanding>& standings,
                                      const Curriculum& followed) {
    std::vector<bool> counted(counting.size(), false);
    for (const TaskStanding& one : standings)
        for (const std::size_t place : one.counted) counted[place] = true;
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < counting.size(); ++i)
        if (!counted[i] && followed.find(counting[i]->meta.task_id) != nullptr)
            ids.push_back(counting[i]->meta.id);
    return ids;
}

}  // namespace

bool is_done(const PersonTask& task) {
    const Standing standing = task.standing.standing;
    return standing == Standing::proficient || standing == Standing::maintained ||
           standing == Standing::due || task.standing.met_provisionally;
}

CountedAttempt counted_attempt(const AttemptSummary& attempt) {
    return {
        attempt.meta.id,           attempt.meta.task_id,  attempt.meta.started, attempt.meta.utc_offset_min,
        attempt.meta.device_class, *attempt.passed,       attempt.provisional,  attempt.voided_at,
        attempt.meta.variant,      attempt.without_limits};
}

PersonStandings person_standings(const std::vector<AttemptSummary>& attempts,
                                 const std::vector<OverrideRow>& overrides, const Curriculum& curriculum,
                                 std::int64_t at, const std::vector<CurriculumAssignment>& followed,
                                 std::vector<ReleasedRating> ratings, std::vector<LimitsPutInForce> limits) {
    PersonStandings person;
    std::vector<const AttemptSummary*> by_time;
    for (const AttemptSummary& attempt : attempts)
        if (attempt.recorded_state != AttemptState::running) by_time.push_back(&attempt);
    std::sort(by_time.begin(), by_time.end(), [](const AttemptSummary* a, const AttemptSummary* b) {
        return std::tie(a->meta.started, a->meta.id) < std::tie(b->meta.started, b->meta.id);
    });
    PersonRecord record;
    record.ratings = std::move(ratings);
    record.limits = std::move(limits);
    record.assignments = followed;
    if (followed.empty()) record.assignments.push_back({0, &curriculum});
    const Curriculum& own = *curriculum_at(record.assignments, at);
    const std::string missing = missing_in(record.assignments, at);
    person.curriculum = missing.empty() ? own.name() : missing;
    person.not_here = !missing.empty();
    std::map<std::int64_t, int> days;
    std::int64_t last_practice = 0;
    std::vector<const AttemptSummary*> counting;  // as record.attempts
    for (const AttemptSummary* attempt : by_time) {
        if (attempt->counting) {
            record.attempts.push_back(counted_attempt(*attempt));
            counting.push_back(attempt);
        }
        const std::int64_t day = local_day(attempt->meta);
        ++days[day];
        person.last_attempt = attempt->meta.started;
        if (is_external_task(attempt->meta.task_id)) continue;
        person.begun = std::min(day, person.begun.value_or(day));
        last_practice = attempt->meta.started;
    }
    for (const auto& [day, count] : days) person.days.push_back({day, count});
    for (const OverrideRow& row : overrides)
        if (!row.own) record.overrides.push_back(row.decision);
    if (person.not_here) record = {};  // what another version would say of it is not the standing
    const std::vector<TaskStanding> standings = standing_of(record, at);
    PointsByTask points;
    const auto task_of = [&](const std::string& id) {
        const auto found = std::find_if(standings.begin(), standings.end(),
                                        [&](const TaskStanding& one) { return one.task == id; });
        if (found != standings.end()) return person_task(*found, counting, points[found->task]);
        PersonTask lacking;
        lacking.standing.task = id;
        return lacking;
    };
    for (const CurriculumTask& shown : curriculum.tasks) person.tasks.push_back(task_of(shown.task));
    for (const TaskStanding& one : standings)
        if (!person.not_here && curriculum.find(one.task) == nullptr)
            person.own_tasks.push_back(task_of(one.task));
    if (person.not_here) return person;
    person.uncounted = uncounted_in(counting, standings, own);
    person.concerns = concerns_of(standings, points, last_practice, pass_mark, at);
    return person;
}

std::vector<TaskOverview> overview_of(const std::vector<PersonStandings>& people, std::int64_t at) {
    std::vector<TaskOverview> overview;
    const std::size_t tasks = people.empty() ? 0 : people.front().tasks.size();
    for (std::size_t t = 0; t < tasks; ++t) {
        TaskOverview one;
        one.task = people.front().tasks[t].standing.task;
        std::vector<Observation> to_pass, to_proficiency;
        const auto observe = [at](std::vector<Observation>& to, const PersonTask& task, std::int64_t event) {
            const std::int64_t end = event > 0 ? event : at;
            to.push_back({static_cast<double>(std::max<std::int64_t>(0, end - task.first_attempt)) /
                              static_cast<double>(day_ms),
                          event > 0});
        };
        for (const PersonStandings& person : people) {
            if (person.not_here) continue;
            const PersonTask& task = person.tasks[t];
            const bool declared_before =
                task.standing.standing == Standing::due || task.standing.standing == Standing::relapsed;
            if (person.active) ++one.people[task.standing.standing];
            if (person.active && task.standing.provisional && !declared_before) ++one.provisional;
            if (task.first_attempt == 0) continue;
            ++one.attempted;
            if (task.first_pass > 0) ++one.passed;
            observe(to_pass, task, task.first_pass);
            observe(to_proficiency, task, task.standing.first_declared_at);
        }
        one.share = wilson(one.passed, one.attempted);
        one.pass_curve = survival_curve(to_pass);
        one.proficiency_curve = survival_curve(to_proficiency);
        one.days_to_pass = survival_median(one.pass_curve);
        one.days_to_proficiency = survival_median(one.proficiency_curve);
        for (const auto& observed : {to_pass, to_proficiency})
            for (const Observation& person : observed)
                one.longest_days = std::max(one.longest_days, person.time);
        overview.push_back(std::move(one));
    }
    return overview;
}

}  // namespace fulcrum::database
