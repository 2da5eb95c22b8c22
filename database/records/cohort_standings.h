// SPDX-License-Identifier: GPL-3.0-or-later
// Where the people of a cohort stand in a curriculum: the standing of each task with its latest attempts,
// days of practice, and why an educator should look at them now. Screens and exports read it from the cohort
// table (database/records/report_data.h), so that their values agree.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/concern.h"
#include "assessment/learning/survival.h"
#include "database/rows/attempt_records.h"
#include "database/store/override_rows.h"

namespace fulcrum::database {

/// An attempt that counts for the curriculum.
struct RecentAttempt {
    std::string attempt_id;
    std::int64_t started = 0;  ///< UTC ms
    bool passed = false, provisional = false;
    std::optional<double> points;  ///< 0..100
};

struct PersonTask {
    TaskStanding standing;
    /// Of the device class used last: classes are never pooled. Empty without attempts.
    std::optional<DeviceClass> device_class;
    std::vector<RecentAttempt> recent;  ///< oldest first, at most most_recent
    std::int64_t first_attempt = 0;     ///< UTC ms of the first that counts, of any device class; 0: none
    std::int64_t first_pass = 0;        ///< UTC ms; 0: none
};
inline constexpr std::size_t most_recent = 12;
/// Proficient, whether a check is due or not, or the rule is met by provisional limits.
bool is_done(const PersonTask& task);

/// Attempts of any kind on one local date.
struct PracticeDay {
    std::int64_t day = 0;  ///< days since 1 January 1970, on the calendar of the place where it was
    int attempts = 0;
};

struct PersonStandings {
    std::string person_id, login, name;
    std::string curriculum;  ///< version that the person follows, "rectal@2"
    /// That version is not at this station: nothing can be said of the standing. `tasks` are all locked then,
    /// and there are no concerns.
    bool not_here = false;
    std::vector<PersonTask> tasks;  ///< of the curriculum, in its order
    /// Of the version that the person follows, those that the curriculum lacks: shown in reports and checks,
    /// in no value over people.
    std::vector<PersonTask> own_tasks;
    std::vector<PracticeDay> days;  ///< oldest first
    /// The first day with an attempt at a task of ours, as PracticeDay::day; none: not begun. What was
    /// recorded elsewhere and imported is in `days`, and moves neither the plan nor the concerns.
    std::optional<std::int64_t> begun;
    std::vector<Concern> concerns;  ///< in the order of ConcernKind
    std::int64_t last_attempt = 0;  ///< UTC ms, of any kind; 0: none
    /// Attempts that count by themselves, but for no standing of the version that was followed then:
    /// performed while the task was locked, or with another class of devices. In no value of the task.
    std::vector<std::string> uncounted;
    /// False: the account is deactivated. In no figure of the present: n, plan, stages, checks, concerns.
    bool active = true;
};

/// What a person's attempts and decisions of educators give at `at`. `attempts`: of any kind, not voided, in
/// any order. `followed`: the versions of the curriculum that the person has followed, empty: `curriculum`
/// from the beginning. `ratings`: released ones of these attempts. `limits`: as PersonRecord. The tasks are
/// those of `curriculum`; one that the person's own version lacks is locked; one that only the own version
/// has is in `own_tasks`. Pure.
PersonStandings person_standings(const std::vector<AttemptSummary>& attempts,
                                 const std::vector<OverrideRow>& overrides, const Curriculum& curriculum,
                                 std::int64_t at, const std::vector<CurriculumAssignment>& followed = {},
                                 std::vector<ReleasedRating> ratings = {},
                                 std::vector<LimitsPutInForce> limits = {});

/// One task over the people of a cohort.
struct TaskOverview {
    std::string task;
    std::map<Standing, int> people;  ///< active, in each standing, provisional passes among the passed
    int provisional = 0;             ///< active people whose every pass is by provisional limits
    /// People with an attempt that counts, with a pass; also those who were deactivated since, as in the
    /// curves: what they performed stays.
    int attempted = 0, passed = 0;
    Share share;  ///< passed of attempted
    /// Days from the first attempt that counts to the first pass and the first declaration, whatever relapse
    /// came later; who is not there yet is censored at `at`.
    SurvivalMedian days_to_pass, days_to_proficiency;
    std::vector<SurvivalStep> pass_curve, proficiency_curve;  ///< behind the medians
    double longest_days = 0;                                  ///< that anybody was observed
};
/// In the order of the curriculum; empty without people. `at`: UTC ms. Pure.
std::vector<TaskOverview> overview_of(const std::vector<PersonStandings>& people, std::int64_t at);

/// The attempt as the curriculum counts it.
CountedAttempt counted_attempt(const AttemptSummary& attempt);

}  // namespace fulcrum::database
