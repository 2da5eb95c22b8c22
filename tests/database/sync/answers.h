// SPDX-License-Identifier: GPL-3.0-or-later
// What a store answers, as a text that has every field of it: two answers are the same where their texts are.
// An empty list has no text, so that a test sees whether there was anything to compare.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "database/records/certificates.h"
#include "database/records/checked_attempts.h"
#include "database/records/cohort_dashboard.h"
#include "database/records/curricula.h"
#include "database/records/error_reviews.h"
#include "database/records/goals.h"
#include "database/records/people.h"
#include "database/records/report_data.h"
#include "database/scoring/expert_attempts.h"
#include "database/scoring/limit_trial.h"
#include "database/store/accepted_assets.h"

namespace fulcrum::database::test::reads {

/// say() of each type is found by this class: in its namespace, also those that are declared further down.
class Answer {
  public:
    Answer() { text_.precision(17); }
    template <typename... Fields>
    void all(const Fields&... fields) {
        (one(fields), ...);
    }
    template <typename Value>
    void put(const Value& value) {
        text_ << value;
    }
    std::string text() const { return text_.str(); }

  private:
    template <typename Field>
    void one(const Field& field) {
        say(*this, field);
        text_ << '|';
    }
    std::ostringstream text_;
};

inline void say(Answer& to, const std::string& text) {
    to.put(text);
}
template <typename Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
void say(Answer& to, Number value) {
    to.put(+value);
}
template <typename Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
void say(Answer& to, Enum value) {
    to.put(static_cast<int>(value));
}
template <typename Value>
void say(Answer& to, const std::optional<Value>& value) {
    if (value)
        to.all(*value);
    else
        to.put('-');
}
template <typename Value>
void say(Answer& to, const std::vector<Value>& values) {
    for (auto&& value : values) {
        to.all(value);
        to.put('\n');
    }
}
template <typename Value, std::size_t size>
void say(Answer& to, const std::array<Value, size>& values) {
    for (const Value& value : values) to.all(value);
}
template <typename First, typename Second>
void say(Answer& to, const std::pair<First, Second>& pair) {
    to.all(pair.first, pair.second);
}
template <typename Key, typename Value>
void say(Answer& to, const std::map<Key, Value>& values) {
    for (const auto& [key, value] : values) {
        to.all(key, value);
        to.put('\n');
    }
}
inline void say(Answer& to, const Statement& statement) {
    to.put(stored_text(statement));
}
inline void say(Answer& to, const PathologyReport& report) {
    to.put(pathology_json(report));
}

inline void say(Answer& to, const AssetFile& file) {
    to.all(file.name, file.digest);
}
inline void say(Answer& to, const ForceOutput& force) {
    to.all(force.damping, force.peak, force.continuous, force.stiffness, force.torque, force.scale,
           force.slew);
}
inline void say(Answer& to, const RigUse& use) {
    to.all(use.stated, use.measured, use.motion, use.part, use.pedal);
}
inline void say(Answer& to, const AttemptOrigin& origin) {
    to.all(origin.source_id, origin.tick, origin.goal, origin.build, origin.state);
}
inline void say(Answer& to, const AttemptMeta& meta) {
    to.all(meta.id, meta.person_id, meta.task_id, meta.task_version, meta.mode, meta.device_class,
           meta.device, meta.operator_name, meta.variant, meta.force_devices, meta.rig_use, meta.seed,
           meta.fidelity, meta.scene, meta.scene_digest, meta.curriculum, meta.limits, meta.program_version,
           meta.cpu_features, meta.started, meta.utc_offset_min, meta.origin, meta.keep_trace);
}
inline void say(Answer& to, const AttemptSummary& one) {
    to.all(one.meta, one.station_id, one.person_login, one.person_name, one.synthetic, one.state,
           one.recorded_state, one.duration_s, one.wall_s, one.missed_ticks, one.lost_samples, one.events,
           one.state_hash, one.passed, one.provisional, one.without_limits, one.points,
           one.not_scored_because, one.counting, one.void_reason, one.voided_by, one.voided_at,
           one.reassigned_from, one.reassigned_to, one.unread_comments, one.comments);
}
inline void say(Answer& to, const MetricRow& row) {
    to.all(row.id, row.version, row.hand, row.tissue, row.value, row.absent_because, row.unit, row.direction,
           row.evidence);
}
inline void say(Answer& to, const GateRow& row) {
    to.all(row.metric, row.hand, row.tissue, row.kind, row.value, row.unit, row.limit, row.limit_source,
           row.z, row.points, row.passed, row.provisional, row.not_passed_because);
}
inline void say(Answer& to, const CriticalErrorRow& row) {
    to.all(row.time_s, row.kind, row.hand, row.tissue, row.text);
}
inline void say(Answer& to, const ScoreRow& score) {
    to.all(score.id, score.computed, score.program_version, score.limits, score.in_force, score.passed,
           score.not_scored_because, score.points, score.advice, score.gates, score.metrics,
           score.critical_errors, score.pathology);
}
inline void say(Answer& to, const ProductBlob& product) {
    to.all(product.kind, product.data);
}
inline void say(Answer& to, const Event& event) {
    to.all(event.tick, event.kind, event.hand, event.tissue, event.detail, event.value);
}
/// Of samples and inputs how many: their chunks are compared by Attempts::record_digest().
inline void say(Answer& to, const Trace& trace) {
    to.all(trace.tick_count(), trace.steps.size(), trace.events);
    for (const TickSample& sample : trace.samples) to.all(sample.tick, sample.hand[1].tip[2]);
}
inline void say(Answer& to, const VariantPractice& practice) {
    to.all(practice.attempts, practice.passes);
}
inline void say(Answer& to, const CutOffSeries& series) {
    to.all(series.attempts);
}
inline void say(Answer& to, const CorrectionRequest& request) {
    to.all(request.id, request.attempt_id, request.person_id, request.person_name, request.text,
           request.asked, request.settled);
}
inline void say(Answer& to, const Comment& comment) {
    to.all(comment.id, comment.attempt_id, comment.author_id, comment.author_name, comment.time_s,
           comment.text, comment.created, comment.sent, comment.read);
}
inline void say(Answer& to, const ErrorReview& review) {
    to.all(review.id, review.attempt_id, review.author_id, review.author_name, review.tick, review.kind,
           review.hand, review.tissue, review.detail, review.verdict, review.reason, review.time);
}
/// Without the last sign-in, which is not exchanged (docs/FORMATS.md, Sync).
inline void say(Answer& to, const Person& person) {
    to.all(person.id, person.login, person.display_name, person.kind, person.active, person.roles,
           person.created, person.merged_into);
}
inline void say(Answer& to, const Cohort& cohort) {
    to.all(cohort.id, cohort.name, cohort.members, cohort.educators);
}
inline void say(Answer& to, const GoalWish& wish) {
    to.all(wish.kind, wish.task, wish.metric, wish.target, wish.due_day);
}
inline void say(Answer& to, const PersonalGoal& goal) {
    to.all(goal.id, goal.person_id, goal.wish, goal.time);
}
inline void say(Answer& to, const GoalProgress& progress) {
    to.all(progress.goal, progress.done, progress.start, progress.best, progress.share, progress.reached,
           progress.missed, progress.days_left);
}

inline void say(Answer& to, const RatingRow& row) {
    to.all(row.id, row.attempt_id, row.rater_id, row.rater_name, row.form.name(), row.form.text, row.blinding,
           row.begun, row.handed_in, row.released, row.remark, row.answers, row.answered);
}
inline void say(Answer& to, const RatedForm& form) {
    to.all(form.form, form.title, form.attempts, form.forms, form.scaled, form.items);
}
inline void say(Answer& to, const ReleasedRating& rating) {
    to.all(rating.id, rating.attempt, rating.rater, rating.form, rating.time, rating.blind, rating.answers);
}

inline void say(Answer& to, const StandingOverride& decision) {
    to.all(decision.id, decision.task, decision.kind, decision.time);
}
inline void say(Answer& to, const OverrideRow& row) {
    to.all(row.decision, row.person_id, row.author_id, row.reason, row.author_name, row.owner_id, row.own);
}
inline void say(Answer& to, const CountedAttempt& one) {
    to.all(one.id, one.task, one.time, one.utc_offset_minutes, one.device_class, one.passed, one.provisional,
           one.voided_at, one.variant, one.without_limits);
}
inline void say(Answer& to, const CurriculumAssignment& assignment) {
    to.all(assignment.time, assignment.curriculum->name(), assignment.missing);
}
inline void say(Answer& to, const LimitsPutInForce& one) {
    to.all(one.id, one.task, one.device_class, one.time, one.provisional);
}
inline void say(Answer& to, const PersonRecord& record) {
    to.all(record.assignments, record.attempts, record.overrides, record.ratings, record.limits);
}
inline void say(Answer& to, const TaskStanding& at) {
    to.all(at.task, at.standing, at.provisional, at.provisional_with, at.firm_with, at.met_provisionally,
           at.one_more_day, at.one_more_pass, at.never_met, at.more_variants, at.rating_late, at.rated_low,
           at.rated_attempt, at.rated_time, at.raters, at.raters_needed, at.stalled, at.by_override,
           at.overdue, at.attempts, at.passes, at.progress, at.waits_for, at.declared_at,
           at.first_declared_at, at.next_check, at.first_attempt, at.first_pass, at.last_attempt, at.counted);
}
inline void say(Answer& to, const RecentAttempt& one) {
    to.all(one.attempt_id, one.started, one.passed, one.provisional, one.points);
}
inline void say(Answer& to, const PersonTask& task) {
    to.all(task.standing, task.device_class, task.recent, task.first_attempt, task.first_pass);
}
inline void say(Answer& to, const PracticeDay& day) {
    to.all(day.day, day.attempts);
}
inline void say(Answer& to, const Concern& one) {
    to.all(one.kind, one.task, one.since, one.provisional, one.attempts, one.plateau, one.low, one.high);
}
inline void say(Answer& to, const PersonStandings& person) {
    to.all(person.person_id, person.login, person.name, person.curriculum, person.not_here, person.tasks,
           person.own_tasks, person.days, person.begun, person.concerns, person.last_attempt,
           person.uncounted, person.active);
}
inline void say(Answer& to, const FollowedCurriculum& one) {
    to.all(one.name, one.since, one.moved_by, one.reason);
}
inline void say(Answer& to, const CurriculumChange& change) {
    to.all(change.task, change.before, change.after, change.only_before, change.only_after);
}
inline void say(Answer& to, const CertificateTask& task) {
    to.all(task.task, task.declared_at, task.by_override, task.curriculum);
}
inline void say(Answer& to, const Certificate& one) {
    to.all(one.programme, one.person_id, one.person_name, one.curriculum, one.curriculum_title, one.stage,
           one.stage_title, one.tasks, one.completed_at, one.code, one.follows);
}

inline void say(Answer& to, const CohortRow& row) {
    to.all(row.person_id, row.login, row.name, row.task_id, row.device_class, row.state, row.provisional,
           row.attempts, row.passes, row.not_counting, row.best_points, row.best_attempt_id, row.last_attempt,
           row.ratings, row.active);
}
/// What the values of a report are based on.
template <typename Report>
void say_basis(Answer& to, const Report& report) {
    to.all(report.metric_versions, report.benchmark_sets, report.program_versions, report.assets,
           report.audit_head);
}
inline void say(Answer& to, const CohortTable& table) {
    to.all(table.cohort_id, table.cohort_name, table.as_of, table.tasks, table.people, table.deactivated,
           table.left_out_synthetic, table.rows, table.curriculum, table.standings);
    say_basis(to, table);
}
inline void say(Answer& to, const ProgressPoint& point) {
    to.all(point.attempt_id, point.number, point.started, point.utc_offset_min, point.mode, point.state,
           point.variant, point.fidelity, point.limits, point.counting, point.left_out, point.continues,
           point.duration_s, point.passed, point.provisional, point.not_scored_because, point.points,
           point.metrics, point.gates, point.pathology, point.ratings);
}
inline void say(Answer& to, const ProgressSeries& series) {
    to.all(series.device_class, series.points);
}
inline void say(Answer& to, const VoidedAttempt& one) {
    to.all(one.attempt_id, one.started, one.at, one.ratings);
}
inline void say(Answer& to, const PersonProgress& progress) {
    to.all(progress.person_id, progress.login, progress.name, progress.task_id, progress.synthetic,
           progress.state, progress.series, progress.voided);
    say_basis(to, progress);
}
inline void say(Answer& to, const PersonData& data) {
    to.all(data.person_id, data.login, data.name, data.synthetic, data.rows, data.progress, data.standings);
    say_basis(to, data);
}
inline void say(Answer& to, const AttemptReport& report) {
    to.all(report.attempt, report.score, report.pathology);
    say_basis(to, report);
}
inline void say(Answer& to, const CheckableAttempts& found) {
    to.all(found.ids, found.others);
}
inline void say(Answer& to, const CheckedAttempt& one) {
    to.all(one.summary, one.scene_text, one.assets, one.trace, one.score);
}

inline void say(Answer& to, const DashboardPerson& one) {
    to.all(one.person, one.task, one.at, one.count);
}
inline void say(Answer& to, const PlanPoint& point) {
    to.all(point.person, point.weeks, point.done, point.planned);
}
inline void say(Answer& to, const PracticeWeek& week) {
    to.all(week.monday, week.attempts, week.people);
}
inline void say(Answer& to, const CheckSlot& slot) {
    to.all(slot.kind, slot.from, slot.to, slot.checks);
}
inline void say(Answer& to, const StageStep& step) {
    to.all(step.stage, step.done, step.people);
}
inline void say(Answer& to, const SurvivalMedian& median) {
    to.all(median.median, median.low, median.high);
}
inline void say(Answer& to, const SurvivalStep& step) {
    to.all(step.time, step.waiting, step.low, step.high);
}
inline void say(Answer& to, const TaskOverview& one) {
    to.all(one.task, one.people, one.provisional, one.attempted, one.passed, one.share.share, one.share.low,
           one.share.high, one.days_to_pass, one.days_to_proficiency, one.pass_curve, one.proficiency_curve,
           one.longest_days);
}
inline void say(Answer& to, const CohortDashboard& dashboard) {
    to.all(dashboard.people, dashboard.tasks, dashboard.plan_weeks, dashboard.plan, dashboard.not_begun,
           dashboard.overview, dashboard.weeks, dashboard.checks, dashboard.stages, dashboard.waiting_to_pass,
           dashboard.waiting_for_proficiency);
}

inline void say(Answer& to, const AcceptedAsset& one) {
    to.all(one.file, one.person_name, one.reason, one.time);
}
inline void say(Answer& to, const AcceptedText& one) {
    to.all(one.file, one.time, one.text);
}
inline void say(Answer& to, const ExpertCandidate& one) {
    to.all(one.person_id, one.login, one.name, one.performed);
}
inline void say(Answer& to, const CriticalError& error) {
    to.all(error.event, error.hand, error.tissue, error.time_s);
}
inline void say(Answer& to, const StaleScore& one) {
    to.all(one.attempt_id, one.person_id, one.person_name, one.task_id, one.why, one.passed);
}
inline void say(Answer& to, const TimeInterval& interval) {
    to.all(interval.begin, interval.end);
}
inline void say(Answer& to, const MetricResult& one) {
    to.all(one.id, one.version, one.hand, one.tissue, one.value, one.unit, one.direction, one.absence,
           one.absent_because, one.evidence, one.count);
}
inline void say(Answer& to, const BenchmarkAttempt& one) {
    to.all(one.person, one.metrics, one.state, one.critical_errors, one.simulated);
}
inline void say(Answer& to, const TriedAttempt& one) {
    to.all(one.attempt_id, one.person_id, one.person_name, one.gates, one.metric_versions, one.critical,
           one.completed, one.passed, one.cutting, one.scene_cutting);
}

template <typename Value>
std::string said(const Value& value) {
    Answer answer;
    say(answer, value);
    return answer.text();
}

}  // namespace fulcrum::database::test::reads
