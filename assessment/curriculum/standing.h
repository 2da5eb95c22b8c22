// SPDX-License-Identifier: Apache-2.0
// Where a trainee stands in a curriculum: one pure function of what was recorded up to a moment. The order in
// which records were inserted changes nothing; a record changes no standing before its own time; a declared
// proficiency ends only by a relapse, or as if it had never been where an attempt that it counted is voided.
//
// Provisional limits allow a pass, never proficiency. Whoever meets the rule on them is shown as "passed
// (provisional)", and the next tasks unlock, so that a site without expert sets of its own can be used. Once
// the limits of the class of devices used last are firm, the standing shows what is left to proficiency. A
// failure where no set of limits applies is an attempt that neither meets a rule nor breaks it.
//
// Where a rule asks for ratings, the attempt that completes the passes is the one to be rated, and stays it
// for rating_days, whatever is performed while it waits: it may be one that nobody is left to rate. Too few
// ratings: awaiting rating. Enough and high enough: proficient from the release of the last one. Enough and
// too low: passed, and the next attempt that completes the rule is rated. docs/METRICS.md, Progress.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"

namespace fulcrum {

enum class Standing : std::uint8_t {
    locked,
    open,
    attempted,
    passed,
    awaiting_rating,
    proficient,
    maintained,
    due,
    relapsed
};
inline constexpr NameRow<Standing> standing_names[] = {
    {Standing::locked, "locked", QT_TRANSLATE_NOOP("fulcrum::standings", "locked")},
    {Standing::open, "open", QT_TRANSLATE_NOOP("fulcrum::standings", "open")},
    {Standing::attempted, "attempted", QT_TRANSLATE_NOOP("fulcrum::standings", "attempted")},
    {Standing::passed, "passed", QT_TRANSLATE_NOOP("fulcrum::standings", "passed")},
    {Standing::awaiting_rating, "awaiting_rating",
     QT_TRANSLATE_NOOP("fulcrum::standings", "awaiting rating")},
    {Standing::proficient, "proficient", QT_TRANSLATE_NOOP("fulcrum::standings", "proficient")},
    {Standing::maintained, "maintained", QT_TRANSLATE_NOOP("fulcrum::standings", "maintained")},
    {Standing::due, "due", QT_TRANSLATE_NOOP("fulcrum::standings", "check due")},
    {Standing::relapsed, "relapsed", QT_TRANSLATE_NOOP("fulcrum::standings", "relapsed")}};
static_assert(in_order(standing_names));

/// An attempt that was assessed and scored and ended by the trainee, the time limit or a failure.
struct CountedAttempt {
    std::string id, task;
    std::int64_t time = 0;       ///< UTC ms, when it began
    int utc_offset_minutes = 0;  ///< local time minus UTC
    DeviceClass device_class = DeviceClass::haptic;
    bool passed = false;
    bool provisional = false;    ///< passed or failed by limits that are provisional
    std::int64_t voided_at = 0;  ///< UTC ms; 0: not voided
    std::string variant = {};    ///< of the task
    /// Failed where no set of limits applies, by a critical error for example: neither firm nor provisional.
    bool without_limits = false;
};

/// An educator's decision, in place of the rule. `proficient` leaves a proficiency in force as it was
/// declared and completes a check that is due.
struct StandingOverride {
    enum class Kind : std::uint8_t { unlocked, proficient };
    std::string id, task;
    Kind kind = Kind::unlocked;
    std::int64_t time = 0;  ///< UTC ms
};

/// What a decision changed at its time.
enum class DecisionEffect : std::uint8_t {
    none,         ///< the task was not locked; or proficiency was in force and no check was due
    unlocked,     ///< the task
    declared,     ///< proficient, whether the task was locked or not
    check_passed  ///< one that was due
};

/// From `time` on attempts at the standard variant of the task with this class of devices are judged by a
/// set of these limits.
struct LimitsPutInForce {
    std::string id, task;
    DeviceClass device_class = DeviceClass::haptic;
    std::int64_t time = 0;  ///< UTC ms
    bool provisional = false;
};

/// From `time` on the trainee follows this curriculum.
struct CurriculumAssignment {
    std::int64_t time = 0;  ///< UTC ms
    const Curriculum* curriculum = nullptr;
    std::string missing = {};  ///< followed version that is not installed, `curriculum` is in its place
};

struct PersonRecord {
    std::vector<CurriculumAssignment> assignments;
    std::vector<CountedAttempt> attempts;
    std::vector<StandingOverride> overrides;
    std::vector<ReleasedRating> ratings = {};   ///< of these attempts
    std::vector<LimitsPutInForce> limits = {};  ///< as far as is known; attempts show which judged them
};

struct TaskStanding {
    std::string task;
    Standing standing = Standing::locked;
    /// Passed: every pass so far is by provisional limits. Due, relapsed: of no class that counts the limits
    /// are known to be firm, and provisional ones neither complete a check nor restore proficiency.
    bool provisional = false;
    /// Classes that the task counts with provisional limits, with firm ones: those that were put in force
    /// last, or that judged the latest attempt since.
    std::vector<DeviceClass> provisional_with = {}, firm_with = {};
    bool met_provisionally = false;     ///< the rule is met by provisional limits, still those in use
    bool one_more_day = false;          ///< the rule is met but for passes on a second day
    bool one_more_pass = false;         ///< enough passes before a move; the new rule is met by one to come
    bool never_met = false;             ///< nobody can ever meet the rule: can_be_met()
    int more_variants = 0;              ///< the rule is met but for passes on so many more variants
    bool rating_late = false;           ///< awaiting rating for rating_days: the next that meets it is rated
    bool rated_low = false;             ///< enough ratings, too low: another attempt has to complete the rule
    std::string rated_attempt;          ///< the one whose ratings the rule asks for; empty: none
    std::int64_t rated_time = 0;        ///< UTC ms, when that attempt began
    int raters = 0, raters_needed = 0;  ///< whose ratings of it count; that the rule asks for
    bool stalled = false;               ///< 60 attempts without a declaration: the educator is asked
    bool by_override = false;           ///< unlocked or declared proficient by an educator
    bool overdue = false;               ///< due for more than 14 days
    int attempts = 0, passes = 0;       ///< that count
    double progress = 0;                ///< 0 to 1 towards the rule, before it is met
    std::vector<std::string> waits_for;  ///< locked: prerequisites that are missing
    std::int64_t declared_at = 0;        ///< UTC ms; 0: not proficient
    std::int64_t first_declared_at = 0;  ///< UTC ms; a relapse does not end it; 0: never
    std::int64_t next_check = 0;         ///< UTC ms; 0: none
    std::int64_t first_attempt = 0;      ///< UTC ms, of those that count; 0: none
    std::int64_t first_pass = 0;         ///< UTC ms; 0: none
    std::int64_t last_attempt = 0;       ///< UTC ms, of those that count; 0: none
    std::vector<std::size_t> counted;    ///< places in PersonRecord::attempts of those that count, by time

    /// The proficiency in force is an educator's decision, not what the rule gave.
    bool declared_by_decision() const { return by_override && declared_at != 0; }
};

/// Days after the declaration on which a retention check is due; after the last one every 182 days.
inline constexpr int retention_days[] = {14, 30, 91, 182};
inline constexpr int overdue_days = 14;
/// An attempt waits for its ratings so long; then the next one that meets the rule is rated in its place.
inline constexpr int rating_days = 28;
inline constexpr int most_attempts = 60;  ///< without a declaration, before the educator is asked

/// The curriculum in force at `at`, whose tasks standing_of() gives: a move may carry a time ahead of this
/// station's clock. Before the first assignment that of the first one; null without any. `at`: UTC ms.
const Curriculum* curriculum_at(const std::vector<CurriculumAssignment>& assignments, std::int64_t at);

/// Of every task of the curriculum in force at `at`, in its order; empty before an assignment. `at`: UTC ms.
std::vector<TaskStanding> standing_of(const PersonRecord& record, std::int64_t at);
/// The same of the tasks of `version`, which the person followed at some time: a proficiency in a task that
/// the curriculum in force no longer has stays as it was.
std::vector<TaskStanding> standing_in(const PersonRecord& record, std::int64_t at, const Curriculum& version);

/// What each decision up to `at` changed, by its id.
std::map<std::string, DecisionEffect> effects_of(const PersonRecord& record, std::int64_t at);
/// What one more decision would change, after everything that was recorded up to its time.
DecisionEffect effect_of(const PersonRecord& record, const StandingOverride& decision);

}  // namespace fulcrum
