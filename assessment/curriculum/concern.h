// SPDX-License-Identifier: Apache-2.0
// Why an educator should look at a trainee now: proficiency lost, a check overdue, ratings missing, a
// learning curve that levels off below the pass mark, 60 attempts without proficiency, practice that stopped.
// Pure: the same record gives the same list.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"

namespace fulcrum {

enum class ConcernKind : std::uint8_t {
    relapsed,       ///< failed a retention check, or too many failures after it
    check_overdue,  ///< a retention check is more than overdue_days late
    rating_late,    ///< an attempt still lacks ratings that the rule asks for after rating_days
    plateau,        ///< the whole 95 % interval of the curve's plateau is below the pass mark
    stalled,        ///< most_attempts without proficiency
    stopped         ///< no attempt of any kind for stopped_days although tasks are left
};
inline constexpr NameRow<ConcernKind> concern_names[] = {
    {ConcernKind::relapsed, "relapsed", QT_TRANSLATE_NOOP("fulcrum::concerns", "relapsed")},
    {ConcernKind::check_overdue, "check_overdue", QT_TRANSLATE_NOOP("fulcrum::concerns", "check overdue")},
    {ConcernKind::rating_late, "rating_late", QT_TRANSLATE_NOOP("fulcrum::concerns", "ratings missing")},
    {ConcernKind::plateau, "plateau", QT_TRANSLATE_NOOP("fulcrum::concerns", "plateau below the pass mark")},
    {ConcernKind::stalled, "stalled",
     QT_TRANSLATE_NOOP("fulcrum::concerns", "many attempts, not proficient")},
    {ConcernKind::stopped, "stopped", QT_TRANSLATE_NOOP("fulcrum::concerns", "stopped practising")}};
static_assert(in_order(concern_names));

/// A trainee who has not practised for this long has stopped.
inline constexpr int stopped_days = 21;

struct Concern {
    ConcernKind kind = ConcernKind::stopped;
    std::string task;          ///< empty: all tasks (stopped)
    std::int64_t since = 0;    ///< UTC ms: due date, latest attempt; 0: not known
    bool provisional = false;  ///< relapsed, check_overdue: the limits are, so that attempts do not end it
    int attempts = 0;          ///< that count, in the task; plateau: those that its curve is through
    double plateau = 0;        ///< plateau: points, 0 to 100
    double low = 0, high = 0;  ///< plateau: its 95 % interval, points
};

/// Points of the attempts that count in a task, oldest first, of one device class.
using PointsByTask = std::map<std::string, std::vector<double>>;

/// In the order of ConcernKind, then of the curriculum. `standings`: at `at`. `last_practice`: UTC ms of the
/// latest attempt of any kind at a task of ours, 0: none (a trainee who never began is not one who stopped).
/// `pass_mark`: points that a passed attempt has at least.
std::vector<Concern> concerns_of(const std::vector<TaskStanding>& standings, const PointsByTask& points,
                                 std::int64_t last_practice, double pass_mark, std::int64_t at);

}  // namespace fulcrum
