// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort in six pictures: progress against a plan, pass rates, time to proficiency, practice volume, due
// checks and stages. Computed from the standings of the cohort table (database/records/report_data.h), for
// the screen, paper and data, so that their values agree. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "database/records/cohort_standings.h"

namespace fulcrum::database {

/// Someone behind a number.
struct DashboardPerson {
    std::size_t person = 0;  ///< index among the standings
    std::string task = {};   ///< where the number is of one task
    std::int64_t at = 0;     ///< UTC ms, where it is of a moment
    int count = 0;           ///< attempts, where it counts them
};

/// How far someone is who has begun.
struct PlanPoint {
    std::size_t person = 0;
    double weeks = 0;    ///< since the first day of practice here
    int done = 0;        ///< tasks
    double planned = 0;  ///< tasks by the plan
    bool behind() const { return done < static_cast<int>(planned); }
};

struct PracticeWeek {
    std::int64_t monday = 0;  ///< days since 1 January 1970
    int attempts = 0;         ///< of any kind
    std::vector<DashboardPerson> people;
};

/// Retention checks that come due within some days.
struct CheckSlot {
    enum class Kind { overdue, due, ahead, later };
    Kind kind = Kind::ahead;
    std::int64_t from = 0, to = 0;  ///< days since 1 January 1970, the last one included; of `ahead`
    std::vector<DashboardPerson> checks;
};

/// The people who got so far: began a stage, or are done with all its tasks.
struct StageStep {
    std::string stage;
    bool done = false;
    std::vector<DashboardPerson> people;
};

/// People whose account is deactivated are in pass rates, times and practice, and in nothing else.
struct CohortDashboard {
    int people = 0, tasks = 0, plan_weeks = 0;
    std::vector<PlanPoint> plan;             ///< in the order of the standings
    std::vector<DashboardPerson> not_begun;  ///< nothing practised here so far
    std::vector<TaskOverview> overview;      ///< pass rates and times, task by task
    std::vector<PracticeWeek> weeks;         ///< the last dashboard_weeks, oldest first
    std::vector<CheckSlot> checks;           ///< overdue, due, the weeks ahead, later
    std::vector<StageStep> stages;           ///< each stage begun, then done, in its order
    /// Of a task of `overview`: who has tried it and is not there yet.
    std::vector<std::vector<DashboardPerson>> waiting_to_pass, waiting_for_proficiency;
};

inline constexpr int dashboard_weeks = 12, dashboard_weeks_ahead = 6;
/// The whole curriculum at an even pace from a person's first day of practice on.
inline constexpr int usual_plan_weeks = 26, longest_plan_weeks = 260;

struct DashboardOptions {
    std::int64_t at = 0;  ///< UTC ms
    int utc_offset_min = 0;
    int plan_weeks = usual_plan_weeks;  ///< at least 1
};
/// Nothing but `plan_weeks` without people.
CohortDashboard dashboard_of(const std::vector<PersonStandings>& people, const Curriculum& curriculum,
                             const DashboardOptions& options);

}  // namespace fulcrum::database
