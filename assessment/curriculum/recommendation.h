// SPDX-License-Identifier: Apache-2.0
// The next thing to do and why: a check that is due, a task that has relapsed, then what is unlocked and not
// yet done in the lowest stage; what the trainee cannot complete comes after what can be done; where its
// curve levels off below the pass mark, the remedy that the curriculum names for it. Deterministic: the same
// standing gives the same recommendation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/remedy.h"
#include "assessment/curriculum/standing.h"

namespace fulcrum {

enum class RecommendationReason : std::uint8_t {
    nothing,             ///< the curriculum has no task that is unlocked
    check_due,           ///< a retention check is due
    relapsed,            ///< proficiency was lost
    not_tried,           ///< unlocked, never attempted
    longest_ago,         ///< unlocked, of those in its stage the one not practised longest
    check_elsewhere,     ///< a retention check is due, which cannot be completed with this device
    relapsed_elsewhere,  ///< proficiency was lost, and cannot be restored with this device
    practice_only,       ///< what is left cannot be assessed with this device
    check_provisional,   ///< a check, or to regain proficiency, is left, which provisional limits cannot do
    rule_never_met,      ///< nobody can meet the rule of what is left
    awaits_rating,       ///< what is left waits for ratings by educators; practice keeps the skill
    remedy,              ///< as longest_ago, on a plateau: what the curriculum names for its worst metric
    all_done             ///< every task is done; this one was performed longest ago
};

/// A remedy that is recommended, and why.
struct ChosenRemedy {
    Remedy remedy;
    double value = 0;  ///< of its metric: median of the latest attempts
    int attempts = 0;  ///< so many
};

struct Recommendation {
    RecommendationReason reason = RecommendationReason::nothing;
    std::string task, stage;                  ///< empty for nothing
    std::int64_t last = 0;                    ///< UTC ms of the latest attempt, practice included; 0: none
    std::int64_t check = 0;                   ///< UTC ms, of a check that is due: since when
    std::optional<ChosenRemedy> remedy = {};  ///< remedy
    /// Whose attempts count for the task; elsewhere: those that may complete the check, restore proficiency.
    std::vector<DeviceClass> devices = {};
    bool provisional_here = false;  ///< elsewhere: with this device, whose attempts count, the limits are
};

/// `standings`: of `curriculum`, in its order. `last_attempts`: by task, UTC ms, practice included.
/// `device`: what the trainee would use now.
Recommendation recommend(const Curriculum& curriculum, const std::vector<TaskStanding>& standings,
                         const std::map<std::string, std::int64_t>& last_attempts, DeviceClass device);

/// The attempts of a trainee in one task that count, of the device class used last, oldest first.
struct TaskHistory {
    std::vector<double> points;
    /// Of each attempt the values of its metrics, by id; of both hands the worse one.
    std::vector<std::map<std::string, double>> values;
    std::string last_variant;
    std::int64_t last = 0;  ///< UTC ms, of the latest one; 0: none
};
inline constexpr std::size_t attempts_of_a_remedy = 5;  ///< the latest; the median of their values counts

/// Of the remedies of `task` whose bound the median is beyond, the one that is furthest beyond it for its
/// size; the first of equals. None where the curve does not level off below `pass_mark`.
std::optional<ChosenRemedy> choose_remedy(const CurriculumTask& task, const TaskHistory& history,
                                          double pass_mark);
/// `next` with the remedy in place of the task that was not practised longest. As it is for any other reason,
/// without a remedy, and where the remedy was taken since the latest attempt that counts: then the task
/// itself shows whether it helped.
Recommendation with_remedy(Recommendation next, const Curriculum& curriculum, const TaskHistory& history,
                           const std::map<std::string, std::int64_t>& last_attempts, double pass_mark);

}  // namespace fulcrum
