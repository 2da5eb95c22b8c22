// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/standing.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "assessment/curriculum/rule_run.h"
#include "assessment/learning/relapse_cusum.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {
namespace {

// A retention check is passed at the second pass of a day and failed at the second failure.
constexpr int decides_a_check = 2;
// After a relapse: 3 of the last 4.
constexpr int regained_passes = 3, regained_window = 4;

std::int64_t floor_day(std::int64_t ms) {
    return ms >= 0 ? ms / day_ms : -((-ms + day_ms - 1) / day_ms);
}
std::int64_t local_day(const CountedAttempt& attempt) {
    return floor_day(attempt.time + std::int64_t{60000} * attempt.utc_offset_minutes);
}

bool is_standard(const CountedAttempt& attempt) {
    return attempt.variant.empty() || attempt.variant == standard_variant;
}

/// One task of one trainee, event by event.
class TaskRun {
  public:
    bool unlocked = false, unlocked_by_override = false;
    std::vector<std::size_t> counted;  ///< as TaskStanding::counted

    bool met_ever() const { return first_declared_at_ != 0 || met_provisionally_; }

    void attempt(const CurriculumTask& task, const CountedAttempt& one, const RatingsByAttempt& ratings) {
        last_ = one.time;
        if (attempts_ == 0) first_ = one.time;
        ++attempts_;
        // There it could not have been passed either.
        if (one.without_limits) return;
        last_class_ = curriculum_class(one.device_class);
        // A variant can have limits of its own; standard attempts complete a check.
        if (is_standard(one) || judged_with_.count(*last_class_) == 0)
            judge_with(one.device_class, one.provisional);
        if (one.passed) {
            provisional_ = passes_ == 0 ? one.provisional : provisional_ && one.provisional;
            if (passes_ == 0) first_pass_ = one.time;
            ++passes_;
        }
        const Outcome outcome{one.passed, local_day(one), one.variant};
        met_provisionally_ = met_provisionally_ || all_.attempt(task, outcome, one, ratings);
        // What provisional limits say neither makes nor ends proficiency.
        if (one.provisional) return;
        if (relapsed_) {
            regain(outcome, one.time);
        } else if (declared_at_ != 0) {
            keep(outcome, one.time);
        } else if (firm_.attempt(task, outcome, one, ratings)) {
            declare(one.time, false);
        }
    }

    /// Attempts with the class are judged by these limits, provisional or firm.
    void judge_with(DeviceClass device, bool provisional) {
        judged_with_[curriculum_class(device)] = provisional;
    }

    void follow(const CurriculumTask& task) {
        all_.follow(task);
        firm_.follow(task);
    }

    /// Ratings were released, or the rule is another one.
    void look(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at) {
        met_provisionally_ = met_provisionally_ || all_.look(task, ratings, at);
        if (!relapsed_ && declared_at_ == 0 && firm_.look(task, ratings, at)) declare(at, false);
    }

    /// An educator's. What is in force stays declared since the same day: a check that is due is passed by
    /// it.
    void declare_by_decision(std::int64_t time) {
        if (declared_at_ == 0) return declare(time, true);
        if (time < next_check_) return;
        maintained_ = true;
        next_check_ = scheduled_after(time);
        check_ = {};
    }

    /// Of an educator's decision that comes now.
    DecisionEffect effect_of(const StandingOverride& decision) const {
        if (decision.kind == StandingOverride::Kind::proficient) {
            if (declared_at_ == 0) return DecisionEffect::declared;
            if (decision.time >= next_check_) return DecisionEffect::check_passed;
        }
        return unlocked ? DecisionEffect::none : DecisionEffect::unlocked;
    }

    void declare(std::int64_t time, bool by_override) {
        declared_at_ = time;
        if (first_declared_at_ == 0) first_declared_at_ = time;
        declared_by_override_ = by_override;
        relapsed_ = maintained_ = false;
        cusum_ = RelapseCusum();
        check_ = {};
        next_check_ = scheduled_after(time);
    }

    TaskStanding standing(const CurriculumTask& task, const RatingsByAttempt& ratings,
                          std::int64_t at) const {
        TaskStanding result;
        result.task = task.task;
        result.attempts = attempts_;
        result.passes = passes_;
        result.last_attempt = last_;
        result.first_attempt = first_;
        result.first_pass = first_pass_;
        result.first_declared_at = first_declared_at_;
        result.by_override = declared_at_ != 0 ? declared_by_override_ : unlocked_by_override;
        for (const auto& [device, provisional] : judged_with_)
            if (counts(task, device))
                (provisional ? result.provisional_with : result.firm_with).push_back(device);
        const bool none_firm = result.firm_with.empty() && !result.provisional_with.empty();
        if (relapsed_) {
            result.standing = Standing::relapsed;
            result.provisional = none_firm;
            return result;
        }
        if (declared_at_ != 0) {
            result.declared_at = declared_at_;
            result.next_check = next_check_;
            result.overdue = at >= next_check_ + overdue_days * day_ms;
            result.standing = at >= next_check_ ? Standing::due
                              : maintained_     ? Standing::maintained
                                                : Standing::proficient;
            result.provisional = none_firm && result.standing == Standing::due;
            return result;
        }
        result.standing = passes_ > 0     ? Standing::passed
                          : attempts_ > 0 ? Standing::attempted
                                          : Standing::open;
        if (!unlocked) result.standing = Standing::locked;
        const bool waits = show_ratings(task, ratings, at, result);
        const bool met = shown_as_met();
        result.provisional = provisional_;
        result.met_provisionally = met;
        const RuleState& state = shown().state();
        result.one_more_day = state.one_more_day && !met;
        result.more_variants = met ? 0 : state.more_variants;
        result.never_met = !met && !can_be_met(task.rule, task.variants);
        result.one_more_pass = !waits && !met && shown().asks_for_one_more();
        result.progress = met ? 1 : state.progress;
        if (result.one_more_pass) result.progress /= 1 + state.of_one_pass;
        result.stalled = !waits && !met && attempts_ >= most_attempts;
        return result;
    }

  private:
    struct Check {
        std::int64_t day = 0;
        int passes = 0, failures = 0;
    };

    /// Whether the limits of the class used last are firm now.
    bool by_firm_limits() const {
        return std::any_of(judged_with_.begin(), judged_with_.end(),
                           [&](const auto& one) { return one.first == last_class_ && !one.second; });
    }
    /// Met, until firm limits judge: from then on proficiency can be reached, and is left to reach.
    bool shown_as_met() const { return met_provisionally_ && !by_firm_limits(); }
    const RuleRun& shown() const { return provisional_ && !by_firm_limits() ? all_ : firm_; }

    /// Whether ratings are missing, by limits that are firm or by provisional ones.
    bool show_ratings(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at,
                      TaskStanding& result) const {
        for (const RuleRun* run : {&firm_, &all_}) {
            if (run == &all_ && met_provisionally_) continue;
            if (!run->awaits(task, ratings, at)) continue;
            run->show_ratings(task, ratings, at, result);
            result.standing = Standing::awaiting_rating;
            result.rating_late = run->rating_late(task, ratings, at);
            return true;
        }
        if (shown_as_met() || !shown().rated_low(task, ratings, at)) return false;
        shown().show_ratings(task, ratings, at, result);
        result.rated_low = true;
        return false;
    }

    std::int64_t scheduled_after(std::int64_t time) const {
        std::int64_t date = 0;
        for (const int days : retention_days) {
            date = declared_at_ + days * day_ms;
            if (date > time) return date;
        }
        while (date <= time) date += retention_days[3] * day_ms;
        return date;
    }

    void keep(const Outcome& outcome, std::int64_t time) {
        bool lost = cusum_.step(outcome.passed);
        if (time >= next_check_) {
            if (check_.day != outcome.day) check_ = {outcome.day, 0, 0};
            ++(outcome.passed ? check_.passes : check_.failures);
            if (check_.failures >= decides_a_check) lost = true;
            if (check_.passes >= decides_a_check && !lost) {
                maintained_ = true;
                next_check_ = scheduled_after(time);
                check_ = {};
            }
        }
        if (!lost) return;
        relapsed_ = true;
        declared_at_ = 0;
        since_relapse_.clear();
    }

    void regain(const Outcome& outcome, std::int64_t time) {
        since_relapse_.push_back(outcome);
        int passes = 0;
        const std::size_t first =
            since_relapse_.size() - std::min<std::size_t>(since_relapse_.size(), regained_window);
        for (std::size_t i = first; i < since_relapse_.size(); ++i)
            passes += since_relapse_[i].passed ? 1 : 0;
        if (passes >= regained_passes) declare(time, false);
    }

    int attempts_ = 0, passes_ = 0;
    bool provisional_ = false, met_provisionally_ = false;
    std::optional<DeviceClass> last_class_;    ///< of the latest attempt that limits judged
    std::map<DeviceClass, bool> judged_with_;  ///< by class: whether the limits are provisional
    std::int64_t first_ = 0, first_pass_ = 0, last_ = 0;
    RuleRun all_, firm_;
    std::vector<Outcome> since_relapse_;
    std::int64_t declared_at_ = 0, first_declared_at_ = 0, next_check_ = 0;
    bool declared_by_override_ = false, relapsed_ = false, maintained_ = false;
    RelapseCusum cusum_;
    Check check_;
};

/// What was recorded, in the order in which it happened.
struct Entry {
    std::int64_t time = 0;
    int kind = 0;  // at the same time: assignments, then overrides, attempts, ratings, limits
    std::string_view id;
    const CurriculumAssignment* assignment = nullptr;
    const StandingOverride* decision = nullptr;
    const CountedAttempt* attempt = nullptr;
    const ReleasedRating* rating = nullptr;
    const LimitsPutInForce* limits = nullptr;
};

std::vector<Entry> entries_of(const PersonRecord& record, std::int64_t at) {
    std::vector<Entry> entries;
    entries.reserve(record.assignments.size() + record.overrides.size() + record.attempts.size() +
                    record.ratings.size() + record.limits.size());
    for (const CurriculumAssignment& one : record.assignments)
        if (one.time <= at) entries.push_back({one.time, 0, {}, &one, nullptr, nullptr, nullptr});
    for (const StandingOverride& one : record.overrides)
        if (one.time <= at) entries.push_back({one.time, 1, one.id, nullptr, &one, nullptr, nullptr});
    for (const CountedAttempt& one : record.attempts) {
        const bool voided = one.voided_at != 0 && one.voided_at <= at;
        if (one.time <= at && !voided)
            entries.push_back({one.time, 2, one.id, nullptr, nullptr, &one, nullptr});
    }
    for (const ReleasedRating& one : record.ratings)
        if (one.time <= at) entries.push_back({one.time, 3, one.id, nullptr, nullptr, nullptr, &one});
    for (const LimitsPutInForce& one : record.limits)
        if (one.time <= at)
            entries.push_back({one.time, 4, one.id, nullptr, nullptr, nullptr, nullptr, &one});
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        if (std::tie(a.time, a.kind) != std::tie(b.time, b.kind))
            return std::tie(a.time, a.kind) < std::tie(b.time, b.kind);
        if (a.assignment != nullptr)
            return a.assignment->curriculum->name() < b.assignment->curriculum->name();
        return a.id < b.id;
    });
    return entries;
}

class Programme {
  public:
    explicit Programme(const PersonRecord& record) : attempts_(record.attempts.data()) {
        for (const ReleasedRating& one : record.ratings) ratings_[one.attempt].push_back(one);
    }

    void take(const Entry& entry) {
        if (entry.assignment != nullptr) follow(*entry.assignment->curriculum);
        if (entry.decision != nullptr) decide(*entry.decision);
        if (entry.limits != nullptr)
            runs_[entry.limits->task].judge_with(entry.limits->device_class, entry.limits->provisional);
        if (entry.attempt != nullptr) {
            const auto found = std::find_if(tasks_.begin(), tasks_.end(), [&](const Followed& one) {
                return one.task->task == entry.attempt->task;
            });
            if (found != tasks_.end() && found->run->unlocked &&
                counts(*found->task, entry.attempt->device_class)) {
                found->run->attempt(*found->task, *entry.attempt, ratings_);
                found->run->counted.push_back(static_cast<std::size_t>(entry.attempt - attempts_));
            }
        }
        if (entry.assignment != nullptr || entry.rating != nullptr)
            for (const Followed& one : tasks_) {
                if (entry.assignment != nullptr) one.run->follow(*one.task);
                one.run->look(*one.task, ratings_, entry.time);
            }
        unlock();
    }

    DecisionEffect effect_of(const StandingOverride& decision) {
        return runs_[decision.task].effect_of(decision);
    }

    void follow(const Curriculum& curriculum) {
        tasks_.clear();
        for (const CurriculumTask& task : curriculum.tasks) tasks_.push_back({&task, &runs_[task.task]});
    }

    std::vector<TaskStanding> standings_at(std::int64_t at) {
        std::vector<TaskStanding> result;
        for (const Followed& one : tasks_) {
            result.push_back(one.run->standing(*one.task, ratings_, at));
            result.back().counted = one.run->counted;
            if (result.back().standing == Standing::locked) result.back().waits_for = missing(*one.task);
        }
        return result;
    }

  private:
    /// A task of the curriculum in force, and what was performed of it under any.
    struct Followed {
        const CurriculumTask* task;
        TaskRun* run;
    };

    void decide(const StandingOverride& decision) {
        TaskRun& run = runs_[decision.task];
        if (decision.kind == StandingOverride::Kind::proficient) run.declare_by_decision(decision.time);
        // Whoever is declared proficient may also perform the task.
        run.unlocked_by_override = run.unlocked_by_override || !run.unlocked;
        run.unlocked = true;
    }

    std::vector<std::string> missing(const CurriculumTask& task) {
        std::vector<std::string> names;
        for (const std::string& before : task.after)
            if (!runs_[before].met_ever()) names.push_back(before);
        return names;
    }

    /// Once unlocked, a task is never locked again.
    void unlock() {
        for (const Followed& one : tasks_)
            one.run->unlocked = one.run->unlocked || missing(*one.task).empty();
    }

    const CountedAttempt* attempts_;  ///< of the record
    std::vector<Followed> tasks_;
    RatingsByAttempt ratings_;
    std::map<std::string, TaskRun> runs_;
};

}  // namespace

const Curriculum* curriculum_at(const std::vector<CurriculumAssignment>& assignments, std::int64_t at) {
    // As entries_of() orders them.
    const auto earlier = [](const CurriculumAssignment* a, const CurriculumAssignment* b) {
        return std::make_tuple(a->time, a->curriculum->name()) <
               std::make_tuple(b->time, b->curriculum->name());
    };
    const CurriculumAssignment *first = nullptr, *last = nullptr;
    for (const CurriculumAssignment& one : assignments) {
        if (first == nullptr || earlier(&one, first)) first = &one;
        if (one.time <= at && (last == nullptr || !earlier(&one, last))) last = &one;
    }
    const CurriculumAssignment* found = last != nullptr ? last : first;
    return found == nullptr ? nullptr : found->curriculum;
}

std::vector<TaskStanding> standing_of(const PersonRecord& record, std::int64_t at) {
    Programme programme(record);
    for (const Entry& entry : entries_of(record, at)) programme.take(entry);
    return programme.standings_at(at);
}

std::vector<TaskStanding> standing_in(const PersonRecord& record, std::int64_t at,
                                      const Curriculum& version) {
    Programme programme(record);
    for (const Entry& entry : entries_of(record, at)) programme.take(entry);
    programme.follow(version);
    return programme.standings_at(at);
}

std::map<std::string, DecisionEffect> effects_of(const PersonRecord& record, std::int64_t at) {
    std::map<std::string, DecisionEffect> effects;
    Programme programme(record);
    for (const Entry& entry : entries_of(record, at)) {
        if (entry.decision != nullptr) effects[entry.decision->id] = programme.effect_of(*entry.decision);
        programme.take(entry);
    }
    return effects;
}

DecisionEffect effect_of(const PersonRecord& record, const StandingOverride& decision) {
    Programme programme(record);
    for (const Entry& entry : entries_of(record, decision.time)) programme.take(entry);
    return programme.effect_of(decision);
}

}  // namespace fulcrum
