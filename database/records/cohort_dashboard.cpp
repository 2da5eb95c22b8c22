// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/cohort_dashboard.h"

#include <algorithm>

#include "database/records/goals.h"

namespace fulcrum::database {
namespace {

void add_plan(CohortDashboard& dashboard, const std::vector<PersonStandings>& people, std::int64_t today) {
    for (std::size_t p = 0; p < people.size(); ++p) {
        const PersonStandings& person = people[p];
        if (!person.active) continue;
        if (person.not_here) continue;  // how many tasks are done is not known
        if (!person.begun) {
            dashboard.not_begun.push_back({p});
            continue;
        }
        PlanPoint point;
        point.person = p;
        point.weeks = static_cast<double>(std::max<std::int64_t>(0, today - *person.begun)) / 7;
        point.done = static_cast<int>(std::count_if(person.tasks.begin(), person.tasks.end(), is_done));
        point.planned = dashboard.tasks * std::min(1.0, point.weeks / dashboard.plan_weeks);
        dashboard.plan.push_back(point);
    }
}

void add_weeks(CohortDashboard& dashboard, const std::vector<PersonStandings>& people, std::int64_t today) {
    const std::int64_t first = monday_of(today) - 7 * (dashboard_weeks - 1);
    for (int w = 0; w < dashboard_weeks; ++w) dashboard.weeks.push_back({first + 7 * w, 0, {}});
    for (std::size_t p = 0; p < people.size(); ++p) {
        for (const PracticeDay& day : people[p].days) {
            const std::int64_t offset = day.day - first;
            if (offset < 0 || offset >= 7 * dashboard_weeks) continue;
            PracticeWeek& week = dashboard.weeks[static_cast<std::size_t>(offset / 7)];
            week.attempts += day.attempts;
            if (week.people.empty() || week.people.back().person != p) week.people.push_back({p});
            week.people.back().count += day.attempts;
        }
    }
}

void add_checks(CohortDashboard& dashboard, const std::vector<PersonStandings>& people, std::int64_t today,
                int utc_offset_min) {
    dashboard.checks.push_back({CheckSlot::Kind::overdue, 0, 0, {}});
    dashboard.checks.push_back({CheckSlot::Kind::due, 0, 0, {}});
    for (int w = 0; w < dashboard_weeks_ahead; ++w)
        dashboard.checks.push_back({CheckSlot::Kind::ahead, today + 7 * w, today + 7 * w + 6, {}});
    dashboard.checks.push_back({CheckSlot::Kind::later, today + 7 * dashboard_weeks_ahead, 0, {}});
    const auto add = [&](std::size_t p, const TaskStanding& standing) {
        if (standing.next_check == 0) return;
        const std::int64_t ahead = day_at(standing.next_check, utc_offset_min) - today;
        std::size_t slot = 0;
        if (standing.standing == Standing::due)
            slot = standing.overdue ? 0 : 1;
        else
            slot =
                2 + static_cast<std::size_t>(std::clamp<std::int64_t>(ahead / 7, 0, dashboard_weeks_ahead));
        dashboard.checks[slot].checks.push_back({p, standing.task, standing.next_check, 0});
    };
    for (std::size_t p = 0; p < people.size(); ++p) {
        if (!people[p].active) continue;
        for (const PersonTask& task : people[p].tasks) add(p, task.standing);
        // Of the version that the person follows: a newer one that lacks the task does not end its checks.
        for (const PersonTask& task : people[p].own_tasks) add(p, task.standing);
    }
    for (CheckSlot& slot : dashboard.checks)
        std::stable_sort(slot.checks.begin(), slot.checks.end(),
                         [](const DashboardPerson& a, const DashboardPerson& b) { return a.at < b.at; });
}

void add_stages(CohortDashboard& dashboard, const std::vector<PersonStandings>& people,
                const Curriculum& curriculum) {
    for (const CurriculumStage& stage : curriculum.stages) {
        StageStep begun{stage.id, false, {}}, done{stage.id, true, {}};
        for (std::size_t p = 0; p < people.size(); ++p) {
            if (!people[p].active) continue;
            int tasks = 0, tried = 0, finished = 0;
            for (const PersonTask& task : people[p].tasks) {
                const CurriculumTask* of = curriculum.find(task.standing.task);
                if (of == nullptr || of->stage != stage.id) continue;
                ++tasks;
                tried += task.first_attempt > 0 || is_done(task) ? 1 : 0;
                finished += is_done(task) ? 1 : 0;
            }
            if (tried > 0) begun.people.push_back({p});
            if (tasks > 0 && finished == tasks) done.people.push_back({p});
        }
        dashboard.stages.push_back(std::move(begun));
        dashboard.stages.push_back(std::move(done));
    }
}

void add_waiting(CohortDashboard& dashboard, const std::vector<PersonStandings>& people) {
    dashboard.waiting_to_pass.resize(dashboard.overview.size());
    dashboard.waiting_for_proficiency.resize(dashboard.overview.size());
    for (std::size_t t = 0; t < dashboard.overview.size(); ++t) {
        for (std::size_t p = 0; p < people.size(); ++p) {
            const PersonTask& task = people[p].tasks[t];
            if (task.first_attempt == 0) continue;
            const DashboardPerson one{p, task.standing.task, task.first_attempt, task.standing.attempts};
            if (task.first_pass == 0) dashboard.waiting_to_pass[t].push_back(one);
            if (task.standing.first_declared_at == 0) dashboard.waiting_for_proficiency[t].push_back(one);
        }
    }
}

}  // namespace

CohortDashboard dashboard_of(const std::vector<PersonStandings>& people, const Curriculum& curriculum,
                             const DashboardOptions& options) {
    CohortDashboard dashboard;
    dashboard.plan_weeks = std::clamp(options.plan_weeks, 1, longest_plan_weeks);
    if (people.empty()) return dashboard;
    dashboard.people = static_cast<int>(
        std::count_if(people.begin(), people.end(), [](const PersonStandings& one) { return one.active; }));
    dashboard.tasks = static_cast<int>(people.front().tasks.size());
    dashboard.overview = overview_of(people, options.at);
    const std::int64_t today = day_at(options.at, options.utc_offset_min);
    add_plan(dashboard, people, today);
    add_weeks(dashboard, people, today);
    add_checks(dashboard, people, today, options.utc_offset_min);
    add_stages(dashboard, people, curriculum);
    add_waiting(dashboard, people);
    return dashboard;
}

}  // namespace fulcrum::database
