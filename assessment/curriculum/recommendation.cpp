// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/recommendation.h"

#include <algorithm>

namespace fulcrum {
namespace {

bool is_done(const TaskStanding& one) {
    return one.standing == Standing::proficient || one.standing == Standing::maintained ||
           one.standing == Standing::due || one.met_provisionally;
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
        return {reason, one.task, stage_of(one), last_of(one), one.next_check};
    }

  private:
    const Curriculum& curriculum_;
    const std::vector<TaskStanding>& standings_;
    const std::map<std::string, std::int64_t>& last_attempts_;
    DeviceClass device_;
};

}  // namespace

Recommendation recommend(const Curriculum& curriculum, const std::vector<TaskStanding>& standings,
                         const std::map<std::string, std::int64_t>& last_attempts, DeviceClass device) {
    const Chooser choose(curriculum, standings, last_attempts, device);
    const TaskStanding* due = nullptr;
    for (const TaskStanding& one : standings)
        if (one.standing == Standing::due && choose.assessable(one) &&
            (due == nullptr || one.next_check < due->next_check))
            due = &one;
    if (due != nullptr) return choose.say(RecommendationReason::check_due, *due);
    if (const TaskStanding* one = choose.longest_ago([&](const TaskStanding& each) {
            return each.standing == Standing::relapsed && choose.assessable(each);
        }))
        return choose.say(RecommendationReason::relapsed, *one);
    const auto waits = [](const TaskStanding& one) {
        return one.standing != Standing::locked && one.standing != Standing::awaiting_rating && !is_done(one);
    };
    if (const TaskStanding* one = choose.lowest_stage(
            [&](const TaskStanding& each) { return waits(each) && choose.assessable(each); }))
        return choose.say(
            choose.last_of(*one) == 0 ? RecommendationReason::not_tried : RecommendationReason::longest_ago,
            *one);
    if (const TaskStanding* one = choose.lowest_stage(waits))
        return choose.say(RecommendationReason::practice_only, *one);
    if (const TaskStanding* one = choose.lowest_stage(
            [](const TaskStanding& each) { return each.standing == Standing::awaiting_rating; }))
        return choose.say(RecommendationReason::awaits_rating, *one);
    if (const TaskStanding* one =
            choose.longest_ago([](const TaskStanding& each) { return each.standing != Standing::locked; }))
        return choose.say(RecommendationReason::all_done, *one);
    return {};
}

}  // namespace fulcrum
