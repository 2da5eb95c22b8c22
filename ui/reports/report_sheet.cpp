// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/metrics/registry.h"
#include "ui/reports/report_rows.h"

namespace fulcrum::ui {
namespace {

const std::vector<SheetColumn>& cohort_columns() {
    static const std::vector<SheetColumn> columns{
        {"cohort", "-", "name of the cohort"},
        {"person_id", "-", "UUID of the person"},
        {"login", "-", "login of the person"},
        {"name", "-", "name of the person"},
        {"task", "-", "task id"},
        {"task_title", "-", "title of the task"},
        {"device_class", "-", "device class; classes are never pooled; empty where the task was not tried"},
        {"state", "-", "open (no counting attempt), attempted (none passed), passed"},
        {"provisional", "1", "1: every pass depends on provisional limits"},
        {"attempts", "1",
         "counting attempts: assessed, scored, ended by the trainee or the clock, not voided, counted by the "
         "standing of the task"},
        {"passes", "1", "of these, passed"},
        {"not_counting", "1",
         "practice, interrupted or not scored attempts, and those that no standing counts"},
        {"best_points", "points", "best points of a counting attempt, 0 to 100; empty: none"},
        {"best_points_scaled", "1", "best_points / 100"},
        {"best_attempt_id", "-", "UUID of the attempt with the best points"},
        {"last_attempt_utc", "-", "start of the latest attempt of any kind, ISO 8601 UTC"},
        {"standing", "-",
         "standing in the curriculum over the device classes that count there: locked, open, attempted, "
         "passed, awaiting_rating, proficient, maintained, due, relapsed; empty: the task does not belong to "
         "it, or nothing can be said, since the person follows a version that is not at the station"},
        {"proficient_since_utc", "-", "when proficiency was declared, ISO 8601 UTC; empty: it was not"},
        {"next_check_utc", "-", "when the next retention check is due, ISO 8601 UTC"},
        {"proficient_by_decision", "1",
         "1: the proficiency is an educator's decision, not what the rule gave; empty: no standing"},
        {"metric_versions", "-", "metric@version of every metric behind the values"},
        {"benchmark_sets", "-", "benchmark sets behind the values"},
        {"assets", "-",
         "files of tasks, scenes, benchmark sets and curricula of the assessed attempts, with their SHA-256"},
        {"program_sha256", "-", "SHA-256 of the program that wrote this"},
        {"tamper_evidence", "-",
         "whether an edit of the store by its owner would be evident, and where to read more"},
        {"n_people", "1", "people in the table, without those who are deactivated"},
        {"synthetic", "1", "1: the store is the demonstration, every person is synthetic"},
        {"active", "1", "0: the account of the person is deactivated"},
    };
    return columns;
}

const std::vector<SheetColumn>& attempt_columns() {
    static const std::vector<SheetColumn> columns{
        {"person_id", "-", "UUID of the person"},
        {"login", "-", "login of the person"},
        {"name", "-", "name of the person"},
        {"synthetic", "1", "1: the person is synthetic or external"},
        {"task", "-", "task id"},
        {"attempt_id", "-", "UUID of the attempt"},
        {"number", "1", "running number within task and device class"},
        {"started_utc", "-", "start, ISO 8601 UTC"},
        {"utc_offset_min", "min", "local time minus UTC at the start"},
        {"device_class", "-", "device class"},
        {"mode", "-", "assessed or practice"},
        {"state", "-", "completed, timed_out, abandoned, interrupted, failed_simulation"},
        {"variant", "-", "anatomy variant"},
        {"fidelity", "-", "fidelity of the simulation"},
        {"limits", "-", "benchmark set in force at the start"},
        {"counting", "1", "1: the attempt counts, also in the standing of its task"},
        {"passed", "1", "1 passed, 0 failed, empty not scored"},
        {"provisional", "1", "1: a gate depends on a provisional limit"},
        {"not_scored_because", "-", "why there is no score"},
        {"duration", "s", "length of the record, with pauses and the time before the first movement"},
        {"points", "points", "0 to 100; empty: none"},
        {"points_scaled", "1", "points / 100"},
        {"continues", "1",
         "1: practice from a moment of another attempt or of a demonstration, a part of the task, never "
         "scored"},
    };
    return columns;
}

std::string metric_name(const database::MetricRow& metric) {
    std::string name = metric.id;
    if (!metric.hand.empty()) name += "." + metric.hand;
    if (!metric.tissue.empty()) name += "." + metric.tissue;
    return name;
}

template <typename Visit>
void each_metric(const PersonReport& report, const Visit& visit) {
    for (const database::PersonProgress& progress : report.progress)
        for (const database::ProgressSeries& series : progress.series)
            for (const database::ProgressPoint& point : series.points)
                for (const database::MetricRow& metric : point.metrics) visit(metric);
}

/// Columns of metric values. Versions of a metric are never in one: the newest that occurs has the plain
/// name, others have their version after it.
class MetricColumns {
  public:
    explicit MetricColumns(const PersonReport& report) {
        each_metric(report, [&](const database::MetricRow& metric) {
            int& newest = newest_[metric_name(metric)];
            newest = std::max(newest, metric.version);
        });
        each_metric(report,
                    [&](const database::MetricRow& metric) { all_.emplace(name_of(metric), metric); });
    }
    std::string name_of(const database::MetricRow& metric) const {
        const std::string name = metric_name(metric);
        return metric.version == newest_.at(name) ? name : name + "@" + std::to_string(metric.version);
    }
    /// By name; unit and id with it.
    const std::map<std::string, database::MetricRow>& all() const { return all_; }

  private:
    std::map<std::string, int> newest_;
    std::map<std::string, database::MetricRow> all_;
};

/// What a form says of one attempt or of several.
const database::RatedForm* form_named(const std::vector<database::RatedForm>& forms,
                                      const std::string& name) {
    for (const database::RatedForm& one : forms)
        if (one.form == name) return &one;
    return nullptr;
}

/// Released forms that occur in the rows, by name.
std::map<std::string, std::string> rated_forms_of(const std::vector<database::CohortRow>& rows) {
    std::map<std::string, std::string> titles;
    for (const database::CohortRow& row : rows)
        for (const database::RatedForm& form : row.ratings) titles[form.form] = form.title;
    return titles;
}

/// The same of the attempts of a person, with its items.
std::map<std::string, ObserverForm> rated_forms_of(const PersonReport& report) {
    std::map<std::string, ObserverForm> forms;
    for (const database::PersonProgress& progress : report.progress)
        for (const database::ProgressSeries& series : progress.series)
            for (const database::ProgressPoint& point : series.points)
                for (const database::RatingRow& rating : point.ratings)
                    forms.emplace(rating.form.name(), rating.form);
    return forms;
}

SheetCell number_cell(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? SheetCell(*value) : SheetCell();
}
SheetCell scaled_cell(const std::optional<double>& points) {
    return points ? number_cell(*points / 100.0) : SheetCell();
}
SheetCell flag_cell(const std::optional<bool>& value) {
    return value ? SheetCell(*value) : SheetCell();
}
SheetCell count_cell(long long value) {
    return SheetCell(value);
}
SheetCell word_cell(std::string text) {
    return text.empty() ? SheetCell() : SheetCell(std::move(text));
}
SheetCell time_cell(std::int64_t utc_ms) {
    return utc_ms == 0 ? SheetCell() : word_cell(database::iso_utc(utc_ms));
}

std::string unit_of(const database::MetricRow& metric) {
    return metric.unit.empty() ? "-" : metric.unit;
}

std::vector<SheetCell> attempt_cells(const PersonReport& report, const std::string& task_id,
                                     DeviceClass device_class, const database::ProgressPoint& point) {
    return {word_cell(report.person_id),
            word_cell(report.login),
            word_cell(report.name),
            flag_cell(report.synthetic),
            word_cell(task_id),
            word_cell(point.attempt_id),
            count_cell(point.number),
            word_cell(database::iso_utc(point.started)),
            count_cell(point.utc_offset_min),
            word_cell(row_of(device_classes, device_class).name),
            word_cell(row_of(attempt_modes, point.mode).name),
            word_cell(row_of(attempt_states, point.state).name),
            word_cell(point.variant),
            word_cell(point.fidelity),
            word_cell(point.limits),
            flag_cell(point.counting),
            flag_cell(point.passed),
            flag_cell(point.provisional),
            word_cell(why_not_scored(point.not_scored_because, point.continues)),
            number_cell(point.duration_s),
            number_cell(point.points),
            scaled_cell(point.points),
            flag_cell(point.continues)};
}

void add_ratings(std::vector<SheetCell>& row, const database::ProgressPoint& point,
                 const std::map<std::string, ObserverForm>& forms) {
    const std::vector<database::RatedForm> rated = database::rated_forms(point.ratings);
    for (const auto& [name, form] : forms) {
        const database::RatedForm* one = form_named(rated, name);
        row.push_back(one == nullptr ? SheetCell() : count_cell(one->forms));
        row.push_back(one == nullptr ? SheetCell() : number_cell(one->scaled));
        for (const FormItem& item : form.items) {
            const bool seen = one != nullptr && one->items.count(item.id) > 0;
            row.push_back(seen ? number_cell(one->items.at(item.id)) : SheetCell());
        }
    }
}

}  // namespace

std::string joined_assets(const std::vector<database::AssetFile>& files) {
    std::vector<std::string> parts;
    for (const database::AssetFile& file : files) parts.push_back(file.name + " sha256:" + file.digest);
    return joined(parts);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : " ") + part;
    return all;
}

DataSheet cohort_sheet(const CohortReport& report) {
    DataSheet sheet{"Progress", cohort_columns(), {}};
    const std::map<std::string, std::string> forms = rated_forms_of(report.table.rows);
    for (const auto& [form, title] : forms) {
        const std::string name = "rating." + form;
        sheet.columns.push_back({name + ".attempts", "1", title + ": attempts with a released form"});
        sheet.columns.push_back({name + ".forms", "1", title + ": released forms of all raters"});
        sheet.columns.push_back({name + ".scaled", "1",
                                 title +
                                     ": mean over attempts of the mean over raters, 0 (lowest ratings) to "
                                     "1 (highest)"});
    }
    for (const database::CohortRow& row : report.table.rows) {
        std::string title;
        for (const ReportTask& task : report.tasks) {
            if (task.id == row.task_id) title = task.title;
        }
        const TaskStanding* standing = standing_in(report.table, row.person_id, row.task_id);
        sheet.rows.push_back(
            {word_cell(report.table.cohort_name),
             word_cell(row.person_id),
             word_cell(row.login),
             word_cell(row.name),
             word_cell(row.task_id),
             word_cell(title),
             word_cell(row.device_class ? row_of(device_classes, *row.device_class).name : ""),
             word_cell(database::task_state_name(row.state)),
             flag_cell(row.provisional),
             count_cell(row.attempts),
             count_cell(row.passes),
             count_cell(row.not_counting),
             number_cell(row.best_points),
             scaled_cell(row.best_points),
             word_cell(row.best_attempt_id),
             time_cell(row.last_attempt),
             word_cell(standing == nullptr ? "" : row_of(standing_names, standing->standing).name),
             time_cell(standing == nullptr ? 0 : standing->declared_at),
             time_cell(standing == nullptr ? 0 : standing->next_check),
             standing == nullptr ? SheetCell() : flag_cell(standing->declared_by_decision()),
             word_cell(joined(report.table.metric_versions)),
             word_cell(joined(report.table.benchmark_sets)),
             word_cell(joined_assets(report.table.assets)),
             word_cell(report.provenance.program_digest),
             word_cell(tamper_evidence(report.provenance)),
             count_cell(report.table.people),
             flag_cell(report.provenance.demo),
             flag_cell(row.active)});
        for (const auto& [form, form_title] : forms) {
            const database::RatedForm* rated = form_named(row.ratings, form);
            sheet.rows.back().push_back(rated == nullptr ? SheetCell() : count_cell(rated->attempts));
            sheet.rows.back().push_back(rated == nullptr ? SheetCell() : count_cell(rated->forms));
            sheet.rows.back().push_back(rated == nullptr ? SheetCell() : number_cell(rated->scaled));
        }
    }
    return sheet;
}

DataSheet person_sheet(const PersonReport& report) {
    DataSheet sheet{"Attempts", attempt_columns(), {}};
    const MetricColumns metrics(report);
    for (const auto& [name, metric] : metrics.all()) {
        const MetricDescriptor* descriptor = find_metric(metric.id);
        const bool explained = descriptor != nullptr && descriptor->version == metric.version;
        sheet.columns.push_back({name, unit_of(metric),
                                 metric.id + "@" + std::to_string(metric.version) +
                                     (explained ? ": " + descriptor->explanation : "")});
    }
    const std::map<std::string, ObserverForm> forms = rated_forms_of(report);
    for (const auto& [name, form] : forms) {
        sheet.columns.push_back({"rating." + name + ".raters", "1", form.title + ": released forms"});
        sheet.columns.push_back({"rating." + name + ".scaled", "1",
                                 form.title + ": mean over raters, 0 (lowest ratings) to 1 (highest)"});
        for (const FormItem& item : form.items)
            sheet.columns.push_back({"rating." + name + "." + item.id, "1",
                                     item.title + ": mean over raters, " + std::to_string(item.lowest) +
                                         " to " + std::to_string(item.highest)});
    }
    for (const database::PersonProgress& progress : report.progress) {
        for (const database::ProgressSeries& series : progress.series) {
            for (const database::ProgressPoint& point : series.points) {
                std::map<std::string, std::optional<double>> values;
                for (const database::MetricRow& metric : point.metrics)
                    values[metrics.name_of(metric)] = metric.value;
                std::vector<SheetCell> row =
                    attempt_cells(report, progress.task_id, series.device_class, point);
                for (const auto& [name, metric] : metrics.all()) {
                    const auto found = values.find(name);
                    row.push_back(number_cell(found == values.end() ? std::nullopt : found->second));
                }
                add_ratings(row, point, forms);
                sheet.rows.push_back(std::move(row));
            }
        }
    }
    return sheet;
}

}  // namespace fulcrum::ui
