// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/comparison.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "assessment/assets/assets.h"
#include "database/records/people.h"
#include "database/records/ratings.h"
#include "ui/language/error_text.h"
#include "ui/review/remote_trace.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr std::size_t band_parts = 400;  // of an attempt's time

struct ComparisonTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::ComparisonTexts)
};

/// Short: it has to be readable in a line of large text.
QString choice_text(const database::AttemptSummary& attempt, bool with_result, const TaskDefinition* task) {
    QStringList parts{local_time(attempt.meta.started)};
    if (with_result)
        parts << (attempt.points && attempt.passed ? points_text(*attempt.points)
                                                   : verdict(attempt.passed, attempt.provisional));
    if (!attempt.meta.variant.empty() && attempt.meta.variant != "standard")
        parts << variant_title(task, attempt.meta.variant);
    return parts.join(QStringLiteral(", "));
}

using CohortValues = std::map<std::pair<std::string, std::string>, std::vector<double>>;

/// Those values of `score` that the same versions of the metrics measured as those of `own`. Metrics of which
/// others did are added to `other_versions`.
void add_values(CohortValues& values, std::set<std::string>& other_versions, const database::ScoreRow& score,
                const AttemptModel& own) {
    if (!own.score) return;
    for (const database::MetricRow& row : score.metrics) {
        if (!row.value || !row.tissue.empty()) continue;
        const auto like = std::find_if(
            own.score->metrics.begin(), own.score->metrics.end(), [&](const database::MetricRow& one) {
                return one.id == row.id && one.hand == row.hand && one.tissue.empty();
            });
        if (like == own.score->metrics.end()) continue;
        if (like->version == row.version)
            values[{row.id, row.hand}].push_back(*row.value);
        else
            other_versions.insert(row.id);
    }
}

bool is_comparable(const database::AttemptSummary& one, const database::AttemptSummary& own) {
    return one.meta.id != own.meta.id && one.state != AttemptState::running &&
           one.state != AttemptState::voided && !one.meta.origin;
}

}  // namespace

std::vector<ComparisonChoice> comparison_choices(const database::Store& store,
                                                 const database::Session& session,
                                                 const database::AttemptSummary& own,
                                                 const TaskDefinition* task) {
    using Kind = ComparisonChoice::Kind;
    std::vector<ComparisonChoice> choices;
    database::AttemptFilter filter;
    filter.person_id = own.meta.person_id;
    filter.task_id = own.meta.task_id;
    filter.include_voided = false;
    std::vector<database::AttemptSummary> others = database::Attempts(store).list(session, filter);
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](const auto& one) { return !is_comparable(one, own); }),
                 others.end());
    const database::AttemptSummary* best = nullptr;
    const database::AttemptSummary* last = nullptr;
    for (const database::AttemptSummary& one : others) {  // newest first
        const bool same_device = one.meta.device_class == own.meta.device_class;
        if (same_device && one.passed.value_or(false) && one.points &&
            (best == nullptr || *one.points > *best->points))
            best = &one;
        if (last == nullptr && one.meta.started < own.meta.started) last = &one;
    }
    const database::Ratings ratings(store);
    const bool rates =
        store.allowed(session, database::Operation::rate, database::Subject::person(own.meta.person_id));
    const auto is_offered = [&](const database::AttemptSummary& one) {
        return !rates || !ratings.is_blind(session, one.meta.id);
    };
    if (best != nullptr && is_offered(*best))
        choices.push_back({Kind::attempt, best->meta.id,
                           ComparisonTexts::tr("Best attempt: %1").arg(choice_text(*best, false, task))});
    if (last != nullptr && is_offered(*last))
        choices.push_back({Kind::attempt, last->meta.id,
                           ComparisonTexts::tr("Latest attempt: %1").arg(choice_text(*last, false, task))});
    if (!database::is_external_task(own.meta.task_id))
        choices.push_back({Kind::expert, {}, ComparisonTexts::tr("An expert of the benchmark (simulated)")});
    if (session.role() != database::Role::trainee) {
        for (const database::Cohort& cohort : database::People(store).cohorts(session))
            choices.push_back(
                {Kind::cohort, cohort.id, ComparisonTexts::tr("Cohort %1 as a band").arg(text(cohort.name))});
    }
    for (const database::AttemptSummary& one : others)
        if (&one != best && &one != last && is_offered(one))
            choices.push_back({Kind::attempt, one.meta.id, choice_text(one, true, task)});
    return choices;
}

std::optional<ComparedSide> load_side(const database::Store& store, const database::Session& session,
                                      const std::string& attempt_id, const std::optional<Scene>& scene,
                                      const Progress& progress) {
    const database::Attempts attempts(store);
    const database::AttemptSummary summary = attempts.read(session, attempt_id);
    ComparedSide side;
    side.scene = scene;
    auto trace = std::make_shared<database::Trace>();
    const Progress share_of = [&](double done, const std::string& line) {
        return !progress || progress(0.6 * done, line);
    };
    try {
        if (!bring_trace(store.path(), session, attempt_id, share_of)) return std::nullopt;
        std::optional<AttemptModel> model = load_attempt(store, session, attempt_id, scene, share_of);
        if (!model) return std::nullopt;
        side.model = std::move(*model);
        if (summary.meta.keep_trace) *trace = attempts.read_packed_trace(session, attempt_id);
    } catch (const database::StoreError& error) {
        if (error.kind() != database::StoreErrorKind::not_found &&
            error.kind() != database::StoreErrorKind::unreachable)
            throw;
        side.why_no_trace = error_text(error);  // it is at the station that recorded it, or on the server
        side.model = model_of_trace(summary, attempts.score(session, attempt_id), trace, scene);
    }
    if (!summary.meta.keep_trace)
        side.why_no_trace = database::is_external_task(summary.meta.task_id)
                                ? external_trace_text(summary.meta.device)
                                : trace_not_kept_text();
    if (progress && !progress(0.9, {})) return std::nullopt;
    if (side.has_trace() && trace->tick_count() == 0)
        side.why_no_trace = ComparisonTexts::tr("Nothing was recorded.");
    side.model.trace = trace;
    side.moments = phase_moments(trace->events, side.model.tick, side.model.duration);
    if (summary.meta.origin) side.moments.first_goal = summary.meta.origin->goal;
    return side;
}

ComparedSide expert_side(const ExpertAttempt& expert, const std::optional<Scene>& scene) {
    ComparedSide side;
    side.scene = scene;
    if (expert.trace->samples.empty()) side.why_no_trace = ComparisonTexts::tr("Nothing was recorded.");
    side.model = model_of_trace(expert.summary, expert.score, expert.trace, scene);
    side.moments = phase_moments(expert.trace->events, side.model.tick, side.model.duration);
    return side;
}

ComparedPair align(const ComparedSide& own, const ComparedSide& other) {
    ComparedPair pair;
    pair.map = PhaseMap(own.moments, other.moments);
    // What the other one did before and after the own record has no place in it.
    constexpr double same_moment_s = 1e-6;
    const auto place = [&](double t) -> std::optional<double> {
        const double here = pair.map.to_first(t);
        if (here < own.model.begin || std::abs(pair.map.to_second(here) - t) > same_moment_s)
            return std::nullopt;
        return here;
    };
    for (std::size_t h = 0; h < hand_count; ++h) {
        pair.force[h] = std::make_shared<const MinMaxPyramid>(other.model.force[h]->moved(place));
        pair.speed[h] = std::make_shared<const MinMaxPyramid>(other.model.speed[h]->moved(place));
    }
    return pair;
}

std::optional<CohortSide> load_cohort(const database::Store& store, const database::Session& session,
                                      const std::string& cohort_id, const ComparedSide& own,
                                      const Progress& progress) {
    const database::Attempts attempts(store);
    const database::AttemptMeta& meta = own.model.summary.meta;
    CohortSide side;
    if (const auto cohort = database::People(store).find_cohort(session, cohort_id))
        side.name = text(cohort->name);
    database::AttemptFilter filter;
    filter.cohort_id = cohort_id;
    filter.task_id = meta.task_id;
    filter.include_voided = false;
    filter.include_synthetic = store.is_demo();
    filter.limit = 100000;
    std::vector<std::string> chosen;
    std::set<std::string> seen{meta.person_id};
    for (const database::AttemptSummary& one : attempts.list(session, filter)) {  // newest first
        if (!one.counting || one.state != AttemptState::completed || one.meta.variant != meta.variant ||
            one.meta.device_class != meta.device_class || !seen.insert(one.meta.person_id).second)
            continue;
        chosen.push_back(one.meta.id);
        if (!one.meta.keep_trace) ++side.without_trace;
    }
    side.people = chosen.size();
    if (side.people < least_in_band) return side;
    CohortValues values;
    std::array<std::vector<std::vector<float>>, hand_count> force, speed;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(chosen.size()), {}))
            return std::nullopt;
        if (const auto score = attempts.score(session, chosen[i]))
            add_values(values, side.other_versions, *score, own.model);
        if (!own.has_trace()) continue;
        std::optional<AttemptModel> model;
        std::vector<Event> events;
        try {
            model = load_attempt(store, session, chosen[i], own.scene, {});
            if (!model->summary.meta.keep_trace || model->samples == 0) continue;
            events = attempts.read_events(session, chosen[i]);
        } catch (const database::StoreError& error) {
            if (error.kind() != database::StoreErrorKind::not_found) throw;
            ++side.without_trace;
            continue;
        }
        const PhaseMap map(own.moments, phase_moments(events, model->tick, model->duration));
        for (std::size_t h = 0; h < hand_count; ++h) {
            const auto means = [&](const MinMaxPyramid& of) {
                return aligned_means(map, own.model.duration, band_parts, of.x(), of.y());
            };
            force[h].push_back(means(*model->force[h]));
            speed[h].push_back(means(*model->speed[h]));
        }
    }
    for (std::size_t h = 0; h < hand_count; ++h) {
        side.force[h] = band_of(force[h], own.model.duration, least_in_band);
        side.speed[h] = band_of(speed[h], own.model.duration, least_in_band);
    }
    for (auto& [key, of] : values)
        if (of.size() >= least_in_band) side.metrics[key] = spread_of(std::move(of));
    return side;
}

QStringList comparison_notes(const ComparedSide& own, const ComparedSide& other, const ComparedPair& pair,
                             const TaskDefinition* task) {
    const database::AttemptMeta &a = own.model.summary.meta, &b = other.model.summary.meta;
    QStringList notes;
    if (a.variant != b.variant)
        notes << ComparisonTexts::tr(
                     "Different variants: %1 and %2. The scenes differ; the attempts are aligned by steps.")
                     .arg(variant_title(task, a.variant), variant_title(task, b.variant));
    if (a.task_version != b.task_version)
        notes << ComparisonTexts::tr("Different versions of the task: %1 and %2.")
                     .arg(a.task_version)
                     .arg(b.task_version);
    if (b.device_class != DeviceClass::synthetic && a.device_class != b.device_class)
        notes << ComparisonTexts::tr(
                     "Different devices: %1 and %2. Their values cannot be compared directly.")
                     .arg(device_class_text(a.device_class), device_class_text(b.device_class));
    if (!own.has_trace()) notes << ComparisonTexts::tr("This attempt: %1").arg(own.why_no_trace);
    if (!other.has_trace()) notes << ComparisonTexts::tr("Other attempt: %1").arg(other.why_no_trace);
    if (own.has_trace() && other.has_trace()) {
        const auto steps = static_cast<int>(pair.map.common_goals().size());
        if (steps > 0)
            notes << ComparisonTexts::tr("Aligned by the %n steps that were completed in both.", nullptr,
                                         steps);
        else if (pair.map.first_goal() > 0)
            notes << ComparisonTexts::tr(
                         "No step was completed in both attempts, so they are aligned at the "
                         "beginning of step %1.")
                         .arg(pair.map.first_goal() + 1);
        else
            notes << ComparisonTexts::tr(
                "No step was completed in both attempts, so they are aligned at the first movement.");
    }
    return notes;
}

QStringList comparison_notes(const ComparedSide& own, const CohortSide& cohort) {
    QStringList notes;
    const auto people = static_cast<int>(cohort.people);
    if (cohort.people < least_in_band) {
        notes << ComparisonTexts::tr(
                     "%1: %n other people have completed this task with this variant and class of device. A "
                     "band needs at least 5.",
                     nullptr, people)
                     .arg(cohort.name);
        return notes;
    }
    notes << ComparisonTexts::tr(
                 "%1: the latest counting attempt of %n other people. Line: median; band: the middle half.",
                 nullptr, people)
                 .arg(cohort.name);
    if (cohort.without_trace > 0)
        notes << ComparisonTexts::tr(
            "The recording of %n of them was not kept here: only their metrics are compared.", nullptr,
            static_cast<int>(cohort.without_trace));
    if (!cohort.other_versions.empty()) {
        QStringList names;
        for (const std::string& id : cohort.other_versions) names << metric_text(id);
        notes << ComparisonTexts::tr("Values that another version of the metric measured are left out: %1.")
                     .arg(names.join(QStringLiteral(", ")));
    }
    if (!own.has_trace()) notes << ComparisonTexts::tr("This attempt: %1").arg(own.why_no_trace);
    return notes;
}

}  // namespace fulcrum::ui
