// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/concern.h"

#include <algorithm>

#include "assessment/learning/learning_curve.h"

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

/// Sets the plateau of `concern` where the curve of `points` levels off below `pass_mark`; false where not.
bool levels_off(const std::vector<double>& points, double pass_mark, Concern& concern) {
    const std::vector<CurveFit> fits = fit_curves(points, false);
    if (fits.empty()) return false;
    const CurveFit& fit = best_curve(fits);
    if (fit.plateau >= pass_mark) return false;
    // A cohort's grid asks this of every person and task: the ends of the interval only where they decide.
    const std::optional<double> high = plateau_end(points, fit, PlateauEnd::high);
    if (!high || *high >= pass_mark) return false;
    const std::optional<double> low = plateau_end(points, fit, PlateauEnd::low);
    if (!low) return false;
    concern.plateau = fit.plateau;
    concern.low = *low;
    concern.high = *high;
    return true;
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
        concerns.push_back(concern);
    };
    bool left = false;
    for (const TaskStanding& one : standings) {
        left = left || is_left(one) || one.standing == Standing::due;
        if (one.standing == Standing::relapsed) add(ConcernKind::relapsed, one, one.last_attempt);
        if (one.standing == Standing::due && one.overdue)
            add(ConcernKind::check_overdue, one, one.next_check);
        if (one.stalled && is_left(one)) add(ConcernKind::stalled, one, one.last_attempt);
        const auto found = points.find(one.task);
        if (is_left(one) && found != points.end()) {
            Concern plateau;
            plateau.kind = ConcernKind::plateau;
            plateau.task = one.task;
            plateau.since = one.last_attempt;
            plateau.attempts = one.attempts;
            if (levels_off(found->second, pass_mark, plateau)) concerns.push_back(plateau);
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
