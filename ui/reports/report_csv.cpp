// SPDX-License-Identifier: GPL-3.0-or-later
// CSV: UTF-8, a header row, a units row, ISO 8601 UTC, raw beside scaled columns, formula-injection guard.
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "ui/reports/report_rows.h"

namespace fulcrum::ui {
namespace {

struct Column {
    std::string name, unit, meaning;
};

const std::vector<Column>& cohort_columns() {
    static const std::vector<Column> columns{
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
         "counting attempts: assessed, scored, ended by the trainee or the clock, not voided"},
        {"passes", "1", "of these, passed"},
        {"not_counting", "1", "practice, interrupted or not scored attempts"},
        {"best_points", "points", "best points of a counting attempt, 0 to 100; empty: none"},
        {"best_points_scaled", "1", "best_points / 100"},
        {"best_attempt_id", "-", "UUID of the attempt with the best points"},
        {"last_attempt_utc", "-", "start of the latest attempt of any kind, ISO 8601 UTC"},
        {"standing", "-",
         "standing in the curriculum over the device classes that count there: locked, open, attempted, "
         "passed, proficient, maintained, due, relapsed; empty: the task does not belong to it"},
        {"proficient_since_utc", "-", "when proficiency was declared, ISO 8601 UTC; empty: it was not"},
        {"next_check_utc", "-", "when the next retention check is due, ISO 8601 UTC"},
        {"metric_versions", "-", "metric@version of every metric behind the values"},
        {"benchmark_sets", "-", "benchmark sets behind the values"},
        {"n_people", "1", "people in the table"},
        {"synthetic", "1", "1: the store is the demonstration, every person is synthetic"},
    };
    return columns;
}

const std::vector<Column>& attempt_columns() {
    static const std::vector<Column> columns{
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
        {"counting", "1", "1: the attempt counts"},
        {"passed", "1", "1 passed, 0 failed, empty not scored"},
        {"provisional", "1", "1: a gate depends on a provisional limit"},
        {"not_scored_because", "-", "why there is no score"},
        {"duration", "s", "length of the record, with pauses and the time before the first movement"},
        {"points", "points", "0 to 100; empty: none"},
        {"points_scaled", "1", "points / 100"},
    };
    return columns;
}

std::string metric_column(const database::MetricRow& metric) {
    std::string name = metric.id;
    if (!metric.hand.empty()) name += "." + metric.hand;
    if (!metric.tissue.empty()) name += "." + metric.tissue;
    return name;
}

/// Column of every metric value that occurs, by name; unit and id with it.
std::map<std::string, database::MetricRow> metric_columns(const PersonReport& report) {
    std::map<std::string, database::MetricRow> columns;
    for (const database::PersonProgress& progress : report.progress) {
        for (const database::ProgressSeries& series : progress.series) {
            for (const database::ProgressPoint& point : series.points) {
                for (const database::MetricRow& metric : point.metrics) {
                    columns.emplace(metric_column(metric), metric);
                }
            }
        }
    }
    return columns;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : " ") + part;
    return all;
}

void end_row(std::string& csv) {
    csv.back() = '\r';
    csv += '\n';
}

class Row {
  public:
    explicit Row(std::string& csv) : csv_(csv) {}
    Row(const Row&) = delete;
    Row& operator=(const Row&) = delete;
    ~Row() { end_row(csv_); }
    Row& words(const std::string& cell) {
        csv_ += csv_text(cell) + ",";
        return *this;
    }
    Row& number(const std::optional<double>& value) {
        csv_ += csv_number(value) + ",";
        return *this;
    }
    Row& count(long long value) {
        csv_ += std::to_string(value) + ",";
        return *this;
    }
    Row& flag(const std::optional<bool>& value) {
        csv_ += value ? (*value ? "1," : "0,") : ",";
        return *this;
    }

  private:
    std::string& csv_;
};

std::optional<double> scaled(const std::optional<double>& points) {
    return points ? std::optional<double>(*points / 100.0) : std::nullopt;
}

std::string time_text(std::int64_t utc_ms) {
    return utc_ms == 0 ? std::string() : database::iso_utc(utc_ms);
}

/// Whether a spreadsheet takes a cell that begins here for a formula: also after blanks, and with the
/// full-width forms that some of them read as the plain ones.
bool begins_formula(const std::string& cell, std::size_t at) {
    at = cell.find_first_not_of(' ', at);
    if (at == std::string::npos) return false;
    if (std::string("=+-@\t\r\n|%").find(cell[at]) != std::string::npos) return true;
    for (const char* wide : {"\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0", "\xE2\x88\x92"})
        if (cell.compare(at, 3, wide) == 0) return true;
    return false;
}

/// An apostrophe before every place where a formula could begin: the cell itself, and what follows a
/// character at which a spreadsheet of another country splits the row.
std::string guarded_text(const std::string& cell) {
    std::string guarded = begins_formula(cell, 0) ? "'" : "";
    for (std::size_t i = 0; i < cell.size(); ++i) {
        guarded += cell[i];
        const bool splits = std::string(";\t\r\n|").find(cell[i]) != std::string::npos;
        if (splits && begins_formula(cell, i + 1)) guarded += '\'';
    }
    return guarded;
}

}  // namespace

std::string csv_text(const std::string& cell) {
    const std::string guarded = cell == "-" || cell == "%" ? cell : guarded_text(cell);
    if (guarded.find_first_of(",;\"\r\n") == std::string::npos) return guarded;
    std::string quoted = "\"";
    for (const char c : guarded) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return {};
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *value);
    return {buffer.data(), end.ptr};
}

std::string cohort_csv(const CohortReport& report) {
    std::string csv;
    {
        Row header(csv);
        for (const Column& column : cohort_columns()) header.words(column.name);
    }
    {
        Row units(csv);
        for (const Column& column : cohort_columns()) units.words(column.unit);
    }
    for (const database::CohortRow& row : report.table.rows) {
        std::string title;
        for (const ReportTask& task : report.tasks) {
            if (task.id == row.task_id) title = task.title;
        }
        const TaskStanding* standing = standing_in(report.table, row.person_id, row.task_id);
        Row(csv)
            .words(report.table.cohort_name)
            .words(row.person_id)
            .words(row.login)
            .words(row.name)
            .words(row.task_id)
            .words(title)
            .words(row.device_class ? row_of(device_classes, *row.device_class).name : "")
            .words(database::task_state_name(row.state))
            .flag(row.provisional)
            .count(row.attempts)
            .count(row.passes)
            .count(row.not_counting)
            .number(row.best_points)
            .number(scaled(row.best_points))
            .words(row.best_attempt_id)
            .words(time_text(row.last_attempt))
            .words(standing == nullptr ? "" : row_of(standing_names, standing->standing).name)
            .words(time_text(standing == nullptr ? 0 : standing->declared_at))
            .words(time_text(standing == nullptr ? 0 : standing->next_check))
            .words(joined(report.table.metric_versions))
            .words(joined(report.table.benchmark_sets))
            .count(report.table.people)
            .flag(report.provenance.demo);
    }
    return csv;
}

std::string person_csv(const PersonReport& report) {
    const std::map<std::string, database::MetricRow> metrics = metric_columns(report);
    std::string csv;
    {
        Row header(csv);
        for (const Column& column : attempt_columns()) header.words(column.name);
        for (const auto& [name, metric] : metrics) header.words(name);
    }
    {
        Row units(csv);
        for (const Column& column : attempt_columns()) units.words(column.unit);
        for (const auto& [name, metric] : metrics) units.words(metric.unit.empty() ? "-" : metric.unit);
    }
    for (const database::PersonProgress& progress : report.progress) {
        for (const database::ProgressSeries& series : progress.series) {
            for (const database::ProgressPoint& point : series.points) {
                std::map<std::string, std::optional<double>> values;
                for (const database::MetricRow& metric : point.metrics)
                    values[metric_column(metric)] = metric.value;
                Row row(csv);
                row.words(report.person_id)
                    .words(report.login)
                    .words(report.name)
                    .flag(report.synthetic)
                    .words(progress.task_id)
                    .words(point.attempt_id)
                    .count(point.number)
                    .words(database::iso_utc(point.started))
                    .count(point.utc_offset_min)
                    .words(row_of(device_classes, series.device_class).name)
                    .words(row_of(attempt_modes, point.mode).name)
                    .words(row_of(attempt_states, point.state).name)
                    .words(point.variant)
                    .words(point.fidelity)
                    .words(point.limits)
                    .flag(point.counting)
                    .flag(point.passed)
                    .flag(point.provisional)
                    .words(words_of(point.not_scored_because))
                    .number(point.duration_s)
                    .number(point.points)
                    .number(scaled(point.points));
                for (const auto& [name, metric] : metrics) {
                    const auto found = values.find(name);
                    row.number(found == values.end() ? std::nullopt : found->second);
                }
            }
        }
    }
    return csv;
}

std::string csv_dictionary(bool cohort, const PersonReport* person) {
    std::string csv;
    Row(csv).words("column").words("unit").words("meaning");
    for (const Column& column : cohort ? cohort_columns() : attempt_columns()) {
        Row(csv).words(column.name).words(column.unit).words(column.meaning);
    }
    if (person != nullptr) {
        for (const auto& [name, metric] : metric_columns(*person)) {
            const MetricDescriptor* descriptor = find_metric(metric.id);
            Row(csv)
                .words(name)
                .words(metric.unit.empty() ? "-" : metric.unit)
                .words(metric.id + "@" + std::to_string(metric.version) +
                       (descriptor == nullptr ? "" : ": " + descriptor->explanation));
        }
    }
    return csv;
}

}  // namespace fulcrum::ui
