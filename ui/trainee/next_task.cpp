// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/next_task.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/metrics/registry.h"
#include "ui/style/remedy_words.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/trainee/metric_versions.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source, int count = -1) {
    return QCoreApplication::translate("fulcrum::ui::next_task", source, nullptr, count);
}

/// By local dates: what was practised in the evening is yesterday's in the morning.
QString ago_text(std::int64_t last, std::int64_t now_ms) {
    const auto day_of = [](std::int64_t ms) { return QDateTime::fromMSecsSinceEpoch(ms).date(); };
    const auto days = static_cast<int>(day_of(last).daysTo(day_of(now_ms)));
    return days <= 0   ? words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "today"))
           : days == 1 ? words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "yesterday"))
                       : words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "%n days ago"), days);
}

QString classes_text(const std::vector<DeviceClass>& classes) {
    QStringList names;
    for (const DeviceClass one : classes) names << device_class_text(one);
    return names.join(QStringLiteral(", "));
}

/// Those that count, of the device class used last; empty: none.
std::vector<const database::ProgressPoint*> counting_points(const database::PersonProgress& progress) {
    std::vector<const database::ProgressPoint*> newest;
    for (const database::ProgressSeries& series : progress.series) {
        std::vector<const database::ProgressPoint*> found;
        for (const database::ProgressPoint& point : series.points)
            if (point.counting) found.push_back(&point);
        if (found.empty()) continue;
        if (newest.empty() || found.back()->started >= newest.back()->started) newest = std::move(found);
    }
    return newest;
}

/// Of both hands the worse value, by metric, as the metrics are defined now.
std::map<std::string, double> worse_values(const std::vector<database::MetricRow>& rows) {
    std::map<std::string, double> values;
    for (const database::MetricRow& row : rows) {
        if (!row.value || !row.tissue.empty() || !is_of_present_version(row)) continue;
        const MetricDescriptor* metric = find_metric(row.id);
        const double value = metric != nullptr && metric->absolute_value ? std::fabs(*row.value) : *row.value;
        const auto [known, is_new] = values.emplace(row.id, value);
        if (!is_new)
            known->second = row.direction == Direction::higher ? std::min(known->second, value)
                                                               : std::max(known->second, value);
    }
    return values;
}

/// What the device in use cannot do, and which ones can.
QString elsewhere_text(const Recommendation& next, DeviceClass device) {
    if (next.reason == RecommendationReason::check_elsewhere) {
        if (next.provisional_here)
            return words(QT_TRANSLATE_NOOP(
                             "fulcrum::ui::next_task",
                             "A retention check of this task has been due since %1. The limits for %2 "
                             "are provisional and cannot complete it; passes with these count: %3. "
                             "Until then you can practise it."))
                .arg(date_text(next.check), device_class_text(device), classes_text(next.devices));
        return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                       "A retention check of this task has been due since %1. It cannot "
                                       "be taken with %2, but with: %3. Until then you can practise it."))
            .arg(date_text(next.check), device_class_text(device), classes_text(next.devices));
    }
    if (next.provisional_here)
        return words(QT_TRANSLATE_NOOP(
                         "fulcrum::ui::next_task",
                         "Your results in this task have fallen below proficiency. The limits for "
                         "%1 are provisional and cannot restore it; passes with these count: %2. "
                         "Until then you can practise it."))
            .arg(device_class_text(device), classes_text(next.devices));
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                   "Your results in this task have fallen below proficiency, which cannot be "
                                   "restored with %1, but with: %2. Until then you can practise it."))
        .arg(device_class_text(device), classes_text(next.devices));
}

}  // namespace

TaskHistory history_of(const database::PersonProgress& progress) {
    TaskHistory history;
    for (const database::ProgressPoint* point : counting_points(progress)) {
        if (point->points) history.points.push_back(*point->points);
        history.values.push_back(worse_values(point->metrics));
        history.last_variant = point->variant;
        history.last = point->started;
    }
    return history;
}

std::string latest_counting(const database::PersonProgress& progress) {
    const auto points = counting_points(progress);
    return points.empty() ? std::string() : points.back()->attempt_id;
}

QString remedy_reason_text(const Recommendation& next, const QString& task_title,
                           const std::vector<TaskDefinition>& tasks) {
    const ChosenRemedy& chosen = *next.remedy;
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                   "Your curve in %1 levels off below the pass mark, and %2 is %3 (median of "
                                   "your latest attempts: %4): %5."))
        .arg(task_title, metric_text(chosen.remedy.metric), remedy_bound_words(chosen.remedy),
             figure_with_unit(chosen.value, chosen.remedy.unit),
             remedy_action_words(chosen.remedy, next.task, tasks));
}

std::map<std::string, TaskSummary> summarise(const std::vector<database::CohortRow>& rows) {
    std::map<std::string, TaskSummary> summaries;
    for (const database::CohortRow& row : rows) {
        TaskSummary& summary = summaries[row.task_id];
        summary.attempts += row.attempts;
        summary.passes += row.passes;
        summary.not_counting += row.not_counting;
        summary.last_attempt = std::max(summary.last_attempt, row.last_attempt);
        if (row.best_points)
            summary.best_points = std::max(summary.best_points.value_or(*row.best_points), *row.best_points);
    }
    return summaries;
}

QString reason_text(const Recommendation& next, const QString& stage, DeviceClass device,
                    std::int64_t now_ms) {
    switch (next.reason) {
        case RecommendationReason::nothing:
            return words(
                QT_TRANSLATE_NOOP("fulcrum::ui::next_task", "No task of the curriculum is unlocked."));
        case RecommendationReason::check_due:
            return words(QT_TRANSLATE_NOOP(
                             "fulcrum::ui::next_task",
                             "You are proficient in this task. A retention check has been due since %1."))
                .arg(date_text(next.check));
        case RecommendationReason::relapsed:
            return words(QT_TRANSLATE_NOOP(
                "fulcrum::ui::next_task",
                "Your results have fallen below proficiency. Three passes in four attempts restore it."));
        case RecommendationReason::not_tried:
            return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                           "You have not tried this task of the stage %1 yet."))
                .arg(stage);
        case RecommendationReason::longest_ago:
            return words(
                       QT_TRANSLATE_NOOP(
                           "fulcrum::ui::next_task",
                           "Of the tasks left in the stage %1, you practised this one least recently (%2)."))
                .arg(stage, ago_text(next.last, now_ms));
        case RecommendationReason::remedy:
            break;  // remedy_reason_text()
        case RecommendationReason::check_elsewhere:
        case RecommendationReason::relapsed_elsewhere:
            return elsewhere_text(next, device);
        case RecommendationReason::practice_only:
            return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                           "The remaining tasks cannot be assessed with %1, but you can "
                                           "practise this one."))
                .arg(device_class_text(device));
        case RecommendationReason::check_provisional:
            if (next.check == 0)
                return words(QT_TRANSLATE_NOOP(
                    "fulcrum::ui::next_task",
                    "Your results in this task have fallen below proficiency. Provisional limits cannot "
                    "restore it; an educator can decide. Until then you can practise it."));
            return words(QT_TRANSLATE_NOOP(
                             "fulcrum::ui::next_task",
                             "A retention check of this task has been due since %1. Provisional limits "
                             "cannot complete it; an educator can decide. Until then you can practise it."))
                .arg(date_text(next.check));
        case RecommendationReason::rule_never_met:
            return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                           "Nobody can meet the rule of this task: ask your educator to "
                                           "correct the curriculum. Until then you can practise it."));
        case RecommendationReason::awaits_rating:
            return words(QT_TRANSLATE_NOOP("fulcrum::ui::next_task",
                                           "The remaining tasks await ratings by your educators. Until then "
                                           "you can practise this one."));
        case RecommendationReason::all_done:
            return words(QT_TRANSLATE_NOOP(
                             "fulcrum::ui::next_task",
                             "You have completed every task. You performed this one least recently (%1)."))
                .arg(ago_text(next.last, now_ms));
    }
    return {};
}

}  // namespace fulcrum::ui
