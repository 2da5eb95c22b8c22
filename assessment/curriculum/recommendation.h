// SPDX-License-Identifier: Apache-2.0
// The next thing to do and why: a check that is due, a task that has relapsed, then what is unlocked and not
// yet done in the lowest stage. Deterministic: the same standing gives the same recommendation.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"

namespace fulcrum {

enum class RecommendationReason : std::uint8_t {
    nothing,        ///< the curriculum has no task that is unlocked
    check_due,      ///< a retention check is due
    relapsed,       ///< proficiency was lost
    not_tried,      ///< unlocked, never attempted
    longest_ago,    ///< unlocked, of those in its stage the one not practised longest
    practice_only,  ///< what is left cannot be assessed with this device
    awaits_rating,  ///< what is left waits for ratings by educators; practice keeps the skill
    all_done        ///< every task is done; this one was performed longest ago
};

struct Recommendation {
    RecommendationReason reason = RecommendationReason::nothing;
    std::string task, stage;  ///< empty for nothing
    std::int64_t last = 0;    ///< UTC ms of the latest attempt, practice included; 0: none
    std::int64_t check = 0;   ///< UTC ms, check_due: since when
};

/// `standings`: of `curriculum`, in its order. `last_attempts`: by task, UTC ms, practice included.
/// `device`: what the trainee would use now.
Recommendation recommend(const Curriculum& curriculum, const std::vector<TaskStanding>& standings,
                         const std::map<std::string, std::int64_t>& last_attempts, DeviceClass device);

}  // namespace fulcrum
