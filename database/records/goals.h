// SPDX-License-Identifier: GPL-3.0-or-later
// Goals that trainees set for themselves, and how far they are: a number of attempts a week, or the value of
// a metric of a task by a day. Seen by the trainee and their educators, by nobody else. A goal changes no
// score and no standing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/store/store.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

enum class GoalOf : std::uint8_t { attempts, metric };
inline constexpr NameRow<GoalOf> goal_kinds[] = {{GoalOf::attempts, "attempts", ""},
                                                 {GoalOf::metric, "metric", ""}};
static_assert(in_order(goal_kinds));

/// What a trainee sets out to do.
struct GoalWish {
    GoalOf kind = GoalOf::attempts;
    std::string task;          ///< empty: any task (attempts)
    std::string metric;        ///< its id; attempts: empty
    double target = 0;         ///< attempts a week; or the metric's value, in its unit
    std::int64_t due_day = 0;  ///< metric: the last day, as day_at() counts; attempts: 0
};

struct PersonalGoal {
    std::string id, person_id;
    GoalWish wish;
    std::int64_t time = 0;  ///< UTC ms, when it was set
};

/// An attempt as a goal counts it.
struct GoalAttempt {
    std::int64_t started = 0, day = 0;  ///< UTC ms; local day
    /// Of the goal's metric, the worst of both hands and all tissues, its size where only that counts; only
    /// of an attempt that was completed.
    std::optional<double> value;
};

struct GoalProgress {
    PersonalGoal goal;
    int done = 0;                       ///< attempts of this week, Monday to Sunday
    std::optional<double> start, best;  ///< metric: the latest value before it was set; the best since
    double share = 0;                   ///< 0 to 1, 1 once it is reached
    bool reached = false;
    bool missed = false;         ///< the day has passed without it
    std::int64_t days_left = 0;  ///< today included; 0: over
};

inline constexpr std::size_t most_goals = 5;  ///< at a time
inline constexpr int most_attempts_a_week = 100;
inline constexpr int longest_goal_days = 366;

/// Days since 1 January 1970 on the calendar of a place.
std::int64_t day_at(std::int64_t utc_ms, int utc_offset_min);
/// The Monday of the week of such a day.
std::int64_t monday_of(std::int64_t day);
/// `attempts`: of the goal's task, in any order. `higher`: the metric's better values are the higher ones.
GoalProgress goal_progress(const PersonalGoal& goal, const std::vector<GoalAttempt>& attempts,
                           std::int64_t today, bool higher);

class Goals {
  public:
    explicit Goals(const Store& store) : store_(store) {}

    /// For the session's own person. Throws AccessDenied; StoreError bad_value for a number or day outside
    /// its range, conflict where there are most_goals already. `today`: local. Returns the id.
    std::string set(const Session& trainee, const GoalWish& wish, std::int64_t today) const;
    /// Ends an own goal and sets another in its place, both or none.
    std::string change(const Session& trainee, const std::string& goal_id, const GoalWish& wish,
                       std::int64_t today) const;
    void drop(const Session& trainee, const std::string& goal_id) const;
    /// Those that were not ended, in the order in which they were set.
    std::vector<PersonalGoal> of_person(const Session& session, const std::string& person_id) const;
    std::vector<GoalProgress> progress(const Session& session, const std::string& person_id,
                                       std::int64_t today) const;
    /// Of the newest completed attempt with this metric, the worst of both hands. Checked as read_goals.
    std::optional<double> latest_value(const Session& session, const std::string& person_id,
                                       const std::string& task, const std::string& metric) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
