// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/concern.h"

#include <algorithm>

#include "assessment/curriculum/plateau.h"

namespace fulcrum {
namespace {

constexpr std::int64_t ms_of_a_day = 86'400'000;

bool is_proficient(const TaskStanding& one) {
    return one.standing == Standing::proficient || one.standing == Standing::maintained ||
           one.standing == Standing::due || one.met_provisionally;
}

/// Something that the trainee can do now and has not finished.
bool is_left(const TaskStanding& one) {
    return one.standing != Standing::locked && one.standing != Standing::awaiting_rating &&
           !is_proficient(one);
}

}  // namespace

std::vector<Concern> concerns_of(const std::vector<TaskStanding>& standings, const PointsByTask& points,
                                 std::int64_t last_practice, double pass_mark, std::int64_t at) {
    std::vector<Concern> concerns;
    const auto add = [&](ConcernKind kind, const TaskStanding& one, std::int64_t since) {
        Concern concern;
        concern.kind = kind;
        concern.task = one.task;
        concern.since = since;
        concern.attempts = one.attempts;
        concern.provisional = one.provisional;
        concerns.push_back(concern);
    };
    bool left = false;
    for (const TaskStanding& one : standings) {
        left = left || is_left(one) || one.standing == Standing::due;
        if (one.standing == Standing::relapsed) add(ConcernKind::relapsed, one, one.last_attempt);
        if (one.standing == Standing::due && one.overdue)
            add(ConcernKind::check_overdue, one, one.next_check);
        if (one.rating_late) add(ConcernKind::rating_late, one, one.rated_time);
        if (one.stalled && is_left(one)) add(ConcernKind::stalled, one, one.last_attempt);
        const auto found = points.find(one.task);
        if (!is_left(one) || found == points.end()) continue;
        if (const auto plateau = plateau_below(found->second, pass_mark)) {
            add(ConcernKind::plateau, one, one.last_attempt);
            concerns.back().attempts = static_cast<int>(found->second.size());
            concerns.back().plateau = plateau->level;
            concerns.back().low = plateau->low;
            concerns.back().high = plateau->high;
        }
    }
    if (left && last_practice > 0 && at - last_practice > stopped_days * ms_of_a_day) {
        Concern concern;
        concern.since = last_practice;
        concerns.push_back(concern);
    }
    std::stable_sort(concerns.begin(), concerns.end(),
                     [](const Concern& a, const Concern& b) { return a.kind < b.kind; });
    return concerns;
}

}  // namespace fulcrum
