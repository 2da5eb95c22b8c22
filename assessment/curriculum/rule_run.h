// SPDX-License-Identifier: Apache-2.0
// Internal to the standings: a pass rule over a trainee's outcomes at one task, and the ratings of the
// attempt that completes it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"

namespace fulcrum {

inline constexpr std::int64_t day_ms = 86'400'000;

struct Outcome {
    bool passed = false;
    std::int64_t day = 0;
    std::string variant;
};

struct RuleState {
    bool met = false, one_more_day = false;
    int more_variants = 0;
    double progress = 0, of_one_pass = 0;  ///< of_one_pass: what one pass adds to it
};

/// The rule with the conditions that the passes it counts lie on two local dates and on enough variants.
RuleState judge(const CurriculumTask& task, const std::vector<Outcome>& outcomes);

/// Released ratings by attempt.
using RatingsByAttempt = std::map<std::string, std::vector<ReleasedRating>>;

/// The rule over a series of outcomes, and the ratings of the attempt that completed it.
class RuleRun {
  public:
    /// Whether the rule is met with this outcome.
    bool attempt(const CurriculumTask& task, const Outcome& outcome, const CountedAttempt& one,
                 const RatingsByAttempt& ratings) {
        outcomes_.push_back(outcome);
        state_ = judge(task, outcomes_);
        const bool late = rating_late(task, ratings, one.time);
        if (state_.met &&
            (rated_.empty() || (outcome.passed && (late || rated_low(task, ratings, one.time))))) {
            if (late) late_.push_back(rated_);
            rated_ = one.id;
            rated_time_ = one.time;
            rated_count_ = static_cast<std::ptrdiff_t>(outcomes_.size());
        }
        return look(task, ratings, one.time);
    }
    /// Another rule is in force: what completed the passes of the one before need not complete those of this.
    void follow(const CurriculumTask& task) {
        state_ = judge(task, outcomes_);
        // Without what was performed while the attempt waited for its ratings: failures do not lose it.
        const std::vector<Outcome> until(outcomes_.begin(), outcomes_.begin() + rated_count_);
        if (judge(task, until).met) return;
        rated_.clear();
        late_.clear();
    }
    /// The passes from before a move are enough for the rule in force since, which no attempt has met yet.
    bool asks_for_one_more() const { return state_.met && rated_.empty(); }
    /// Whether it is met at `at`, with the ratings released until then.
    bool look(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at) const {
        if (rated_.empty()) return false;
        if (!task.ratings || verdict(task, ratings, at, rated_).met) return true;
        return std::any_of(late_.begin(), late_.end(),
                           [&](const std::string& id) { return verdict(task, ratings, at, id).met; });
    }
    bool awaits(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at) const {
        return !rated_.empty() && task.ratings && !verdict(task, ratings, at, rated_).enough;
    }
    bool rating_late(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at) const {
        return awaits(task, ratings, at) && at >= rated_time_ + rating_days * day_ms;
    }
    bool rated_low(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at) const {
        if (rated_.empty() || !task.ratings) return false;
        const RatingVerdict said = verdict(task, ratings, at, rated_);
        return said.enough && !said.met;
    }
    void show_ratings(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at,
                      TaskStanding& standing) const {
        standing.rated_attempt = rated_;
        standing.rated_time = rated_time_;
        standing.raters = verdict(task, ratings, at, rated_).raters;
        standing.raters_needed = task.ratings->raters;
    }
    const RuleState& state() const { return state_; }

  private:
    static RatingVerdict verdict(const CurriculumTask& task, const RatingsByAttempt& ratings, std::int64_t at,
                                 const std::string& attempt) {
        const auto found = ratings.find(attempt);
        return judge_ratings(*task.ratings,
                             found == ratings.end() ? std::vector<ReleasedRating>() : found->second, at);
    }

    std::vector<Outcome> outcomes_;
    RuleState state_;
    std::string rated_;  ///< the attempt that completed the passes; empty: none did
    std::int64_t rated_time_ = 0;
    std::ptrdiff_t rated_count_ = 0;  ///< outcomes up to that attempt
    std::vector<std::string> late_;   ///< rated in its place before; their ratings count whenever they come
};

}  // namespace fulcrum
