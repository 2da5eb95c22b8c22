// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/recommendation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assessment/curriculum/plateau.h"

namespace fulcrum {
namespace {

bool is_done(const TaskStanding& one) {
    return one.standing == Standing::proficient || one.standing == Standing::maintained ||
           one.standing == Standing::due || one.met_provisionally;
}

/// Something that the trainee has not finished, and does not wait for others.
bool is_unfinished(const TaskStanding& one) {
    const bool waits = one.standing == Standing::awaiting_rating && !one.rating_late;
    return one.standing != Standing::locked && !waits && !is_done(one);
}

/// What provisional limits cannot do: a check, or a proficiency to regain.
bool needs_firm_limits(const TaskStanding& one) {
    return one.standing == Standing::due || one.standing == Standing::relapsed;
}
bool contains(const std::vector<DeviceClass>& classes, DeviceClass one) {
    return std::find(classes.begin(), classes.end(), one) != classes.end();
}

/// Chooses among the tasks of a curriculum.
class Chooser {
  public:
    Chooser(const Curriculum& curriculum, const std::vector<TaskStanding>& standings,
            const std::map<std::string, std::int64_t>& last_attempts, DeviceClass device)
        : curriculum_(curriculum), standings_(standings), last_attempts_(last_attempts), device_(device) {}

    /// Of those that `fits`, the one not practised longest; the first of equals. Null: none.
    template <typename Fits>
    const TaskStanding* longest_ago(const Fits& fits) const {
        const TaskStanding* chosen = nullptr;
        for (const TaskStanding& one : standings_)
            if (fits(one) && (chosen == nullptr || last_of(one) < last_of(*chosen))) chosen = &one;
        return chosen;
    }
    /// The same in the lowest stage that has one.
    template <typename Fits>
    const TaskStanding* lowest_stage(const Fits& fits) const {
        for (const CurriculumStage& stage : curriculum_.stages)
            if (const TaskStanding* found = longest_ago(
                    [&](const TaskStanding& one) { return stage_of(one) == stage.id && fits(one); }))
                return found;
        return nullptr;
    }
    /// The check that has been due longest of those that can be taken with the device, or of the others.
    const TaskStanding* longest_due(bool with_device) const {
        const TaskStanding* due = nullptr;
        for (const TaskStanding& one : standings_)
            if (one.standing == Standing::due && can_be_done(one, with_device) &&
                (due == nullptr || one.next_check < due->next_check))
                due = &one;
        return due;
    }
    /// Of the tasks whose proficiency was lost.
    const TaskStanding* relapsed(bool with_device) const {
        return longest_ago([&](const TaskStanding& one) {
            return one.standing == Standing::relapsed && can_be_done(one, with_device);
        });
    }
    /// A check or a proficiency that attempts with the device cannot complete or restore: they do not count,
    /// or the limits are provisional as far as is known.
    bool is_left_to_others(const TaskStanding& one) const {
        return needs_firm_limits(one) && (!assessable(one) || provisional_here(one));
    }
    bool assessable(const TaskStanding& one) const {
        const CurriculumTask* task = curriculum_.find(one.task);
        return task != nullptr && counts(*task, device_);
    }
    std::int64_t last_of(const TaskStanding& one) const {
        const auto found = last_attempts_.find(one.task);
        return std::max(one.last_attempt, found == last_attempts_.end() ? 0 : found->second);
    }
    std::string stage_of(const TaskStanding& one) const {
        const CurriculumTask* task = curriculum_.find(one.task);
        return task == nullptr ? std::string() : task->stage;
    }
    Recommendation say(RecommendationReason reason, const TaskStanding& one) const {
        const bool elsewhere = reason == RecommendationReason::check_elsewhere ||
                               reason == RecommendationReason::relapsed_elsewhere;
        return {reason,
                one.task,
                stage_of(one),
                last_of(one),
                one.next_check,
                {},
                elsewhere ? others(one) : classes_of(one),
                elsewhere && provisional_here(one)};
    }

  private:
    /// Whether it can be done with the device, or if not `with_device`, with another one only.
    bool can_be_done(const TaskStanding& one, bool with_device) const {
        return is_left_to_others(one) != with_device && (with_device || !others(one).empty());
    }
    bool provisional_here(const TaskStanding& one) const {
        return contains(one.provisional_with, curriculum_class(device_));
    }
    std::vector<DeviceClass> classes_of(const TaskStanding& one) const {
        const CurriculumTask* task = curriculum_.find(one.task);
        return task == nullptr ? std::vector<DeviceClass>() : task->device_classes;
    }
    /// With which it can be done: where attempts with the device count, those that are known to have firm
    /// limits, otherwise all that are not known to have provisional ones.
    std::vector<DeviceClass> others(const TaskStanding& one) const {
        if (provisional_here(one)) return one.firm_with;
        std::vector<DeviceClass> classes = classes_of(one);
        classes.erase(std::remove_if(classes.begin(), classes.end(),
                                     [&](DeviceClass each) { return contains(one.provisional_with, each); }),
                      classes.end());
        return classes;
    }

    const Curriculum& curriculum_;
    const std::vector<TaskStanding>& standings_;
    const std::map<std::string, std::int64_t>& last_attempts_;
    DeviceClass device_;
};

/// Of the latest attempts that have a value of the metric.
std::vector<double> latest_values(const TaskHistory& history, const std::string& metric) {
    std::vector<double> values;
    for (auto one = history.values.rbegin();
         one != history.values.rend() && values.size() < attempts_of_a_remedy; ++one) {
        const auto found = one->find(metric);
        if (found != one->end()) values.push_back(found->second);
    }
    return values;
}

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// How far the value is beyond the bound for the bound's size; 0 or less: it is not.
double beyond(const Remedy& remedy, double value) {
    const double excess = remedy.above ? value - remedy.bound : remedy.bound - value;
    if (excess <= 0 || remedy.bound != 0) return excess <= 0 ? 0 : excess / std::fabs(remedy.bound);
    return std::numeric_limits<double>::infinity();
}

/// Whether the trainee has done what the remedy asks for since the latest attempt that counts.
bool was_taken(const Remedy& remedy, const std::string& task, const TaskHistory& history,
               const std::map<std::string, std::int64_t>& last_attempts) {
    const auto found = last_attempts.find(remedy.kind == RemedyKind::other_task ? remedy.task : task);
    return (found != last_attempts.end() && found->second > history.last) ||
           (remedy.kind == RemedyKind::other_variant && history.last_variant == remedy.variant);
}

}  // namespace

std::optional<ChosenRemedy> choose_remedy(const CurriculumTask& task, const TaskHistory& history,
                                          double pass_mark) {
    std::optional<ChosenRemedy> chosen;
    double furthest = 0;
    for (const Remedy& remedy : task.remedies) {
        const std::vector<double> values = latest_values(history, remedy.metric);
        if (values.empty()) continue;
        const double value = median_of(values), how_far = beyond(remedy, value);
        if (how_far <= furthest) continue;
        furthest = how_far;
        chosen = ChosenRemedy{remedy, value, static_cast<int>(values.size())};
    }
    if (chosen && !plateau_below(history.points, pass_mark)) return {};
    return chosen;
}

Recommendation with_remedy(Recommendation next, const Curriculum& curriculum, const TaskHistory& history,
                           const std::map<std::string, std::int64_t>& last_attempts, double pass_mark) {
    const CurriculumTask* task = curriculum.find(next.task);
    if (next.reason != RecommendationReason::longest_ago || task == nullptr) return next;
    const auto chosen = choose_remedy(*task, history, pass_mark);
    if (!chosen || was_taken(chosen->remedy, next.task, history, last_attempts)) return next;
    next.reason = RecommendationReason::remedy;
    next.remedy = chosen;
    return next;
}

Recommendation recommend(const Curriculum& curriculum, const std::vector<TaskStanding>& standings,
                         const std::map<std::string, std::int64_t>& last_attempts, DeviceClass device) {
    const Chooser choose(curriculum, standings, last_attempts, device);
    if (const TaskStanding* one = choose.longest_due(true))
        return choose.say(RecommendationReason::check_due, *one);
    if (const TaskStanding* one = choose.relapsed(true))
        return choose.say(RecommendationReason::relapsed, *one);
    const auto waits = [&](const TaskStanding& one) {
        return is_unfinished(one) && !one.never_met && !choose.is_left_to_others(one);
    };
    if (const TaskStanding* one = choose.lowest_stage(
            [&](const TaskStanding& each) { return waits(each) && choose.assessable(each); }))
        return choose.say(
            choose.last_of(*one) == 0 ? RecommendationReason::not_tried : RecommendationReason::longest_ago,
            *one);
    if (const TaskStanding* one = choose.longest_due(false))
        return choose.say(RecommendationReason::check_elsewhere, *one);
    if (const TaskStanding* one = choose.relapsed(false))
        return choose.say(RecommendationReason::relapsed_elsewhere, *one);
    if (const TaskStanding* one = choose.lowest_stage(waits))
        return choose.say(RecommendationReason::practice_only, *one);
    if (const TaskStanding* one = choose.lowest_stage(
            [](const TaskStanding& each) { return each.standing == Standing::awaiting_rating; }))
        return choose.say(RecommendationReason::awaits_rating, *one);
    if (const TaskStanding* one =
            choose.longest_ago([&](const TaskStanding& each) { return choose.is_left_to_others(each); }))
        return choose.say(RecommendationReason::check_provisional, *one);
    if (const TaskStanding* one = choose.lowest_stage(is_unfinished))
        return choose.say(RecommendationReason::rule_never_met, *one);
    if (const TaskStanding* one =
            choose.longest_ago([](const TaskStanding& each) { return each.standing != Standing::locked; }))
        return choose.say(RecommendationReason::all_done, *one);
    return {};
}

}  // namespace fulcrum
