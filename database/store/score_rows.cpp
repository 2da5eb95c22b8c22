// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/score_rows.h"

#include <algorithm>

#include "assessment/metrics/metric_names.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

struct ScoreOfAttempt {
    std::string attempt_id;
    ScoreRow score;
};

void write_row(Connection& connection, const std::string& attempt_id, const ScoreRow& score) {
    Query(connection,
          "INSERT INTO score (id, attempt_id, computed, program_version, limits, in_force, passed, "
          "not_scored_because, points, "
          "advice) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(score.id)
        .bind(attempt_id)
        .bind(score.computed)
        .bind(score.program_version)
        .bind(score.limits)
        .bind(score.in_force)
        .bind(score.passed)
        .bind(stored_text(score.not_scored_because))
        .bind(score.points)
        .bind(stored_text(score.advice))
        .run();
}

void write_gates(Connection& connection, const ScoreRow& score) {
    int number = 0;
    for (const GateRow& gate : score.gates) {
        Query(connection,
              "INSERT INTO gate (score_id, number, metric, hand, tissue, kind, value, unit, limit_value, "
              "limit_source, z, points, "
              "passed, provisional, not_passed_because) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
            .bind(score.id)
            .bind(number++)
            .bind(gate.metric)
            .bind(gate.hand)
            .bind(gate.tissue)
            .bind(std::string(row_of(gate_kinds, gate.kind).name))
            .bind(gate.value)
            .bind(gate.unit)
            .bind(gate.limit)
            .bind(gate.limit_source)
            .bind(gate.z)
            .bind(gate.points)
            .bind(gate.passed)
            .bind(gate.provisional)
            .bind(stored_text(gate.not_passed_because))
            .run();
    }
}

void write_metrics(Connection& connection, const ScoreRow& score) {
    int number = 0;
    for (const MetricRow& metric : score.metrics) {
        Query(connection,
              "INSERT INTO metric (score_id, number, id, version, hand, tissue, value, absent_because, unit, "
              "direction, evidence) "
              "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
            .bind(score.id)
            .bind(number++)
            .bind(metric.id)
            .bind(metric.version)
            .bind(metric.hand)
            .bind(metric.tissue)
            .bind(metric.value)
            .bind(stored_text(metric.absent_because))
            .bind(metric.unit)
            .bind(std::string(row_of(metric_directions, metric.direction).name))
            .bind(json_intervals(metric.evidence))
            .run();
    }
}

void write_errors(Connection& connection, const ScoreRow& score) {
    int number = 0;
    for (const CriticalErrorRow& error : score.critical_errors) {
        Query(connection,
              "INSERT INTO critical_error (score_id, number, time_s, kind, hand, tissue, text) VALUES (?, ?, "
              "?, ?, ?, ?, ?)")
            .bind(score.id)
            .bind(number++)
            .bind(error.time_s)
            .bind(error.kind)
            .bind(error.hand)
            .bind(error.tissue)
            .bind(error.text)
            .run();
    }
}

/// Scores (table `s`) of attempts (table `a`) for which `where` holds with these values.
class ScoreReader {
  public:
    ScoreReader(Connection& connection, const QString& where, const std::vector<std::string>& values)
        : connection_(connection), where_(where), values_(values) {}

    std::vector<ScoreOfAttempt> read() {
        read_rows();
        if (scores_.empty()) return {};
        read_gates();
        read_metrics();
        read_errors();
        Query reports = rows("t.report", "pathology t", "");
        while (reports.next())
            if (ScoreRow* score = find(reports)) score->pathology = reports.text(1);
        return std::move(scores_);
    }

  private:
    /// Columns of a table `t` that belongs to scores, after the score's id.
    Query rows(const char* columns, const char* table, const char* order) {
        Query query(connection_, QString("SELECT s.id, %1 FROM attempt a JOIN score s ON s.attempt_id = a.id "
                                         "JOIN %2 ON t.score_id = s.id WHERE %3%4")
                                     .arg(columns, table, where_, order));
        for (const std::string& value : values_) query.bind(value);
        return query;
    }
    ScoreRow* find(const Query& query) {
        const std::string id = query.text(0);
        if (id != last_id_) {
            const auto found = place_.find(id);
            last_ = found == place_.end() ? nullptr : &scores_[found->second].score;
            last_id_ = id;
        }
        return last_;
    }
    void read_rows();
    void read_gates();
    void read_metrics();
    void read_errors();

    Connection& connection_;
    QString where_;
    const std::vector<std::string>& values_;
    std::vector<ScoreOfAttempt> scores_;
    std::map<std::string, std::size_t> place_;
    std::string last_id_;
    ScoreRow* last_ = nullptr;
};

constexpr const char* by_number = " ORDER BY s.id, t.number";

void ScoreReader::read_rows() {
    Query row(connection_,
              QString("SELECT s.id, s.computed, s.program_version, s.limits, s.in_force, s.passed, "
                      "s.not_scored_because, s.points, s.advice, a.id FROM attempt a JOIN score s "
                      "ON s.attempt_id = a.id WHERE ") +
                  where_);
    for (const std::string& value : values_) row.bind(value);
    while (row.next()) {
        ScoreRow score;
        score.id = row.text(0);
        score.computed = row.integer(1);
        score.program_version = row.text(2);
        score.limits = row.text(3);
        score.in_force = row.flag(4);
        score.passed = row.optional_flag(5);
        score.not_scored_because = statement_of(row.text(6));
        score.points = row.optional_real(7);
        score.advice = statement_of(row.text(8));
        place_[score.id] = scores_.size();
        scores_.push_back({row.text(9), std::move(score)});
    }
}

void ScoreReader::read_gates() {
    Query gates = rows(
        "t.metric, t.hand, t.tissue, t.kind, t.value, t.unit, t.limit_value, t.limit_source, t.z, "
        "t.points, t.passed, t.provisional, t.not_passed_because",
        "gate t", by_number);
    while (gates.next()) {
        ScoreRow* score = find(gates);
        if (score == nullptr) continue;
        GateRow gate;
        gate.metric = gates.text(1);
        gate.hand = gates.text(2);
        gate.tissue = gates.text(3);
        gate.kind = enum_of(gates.text(4), gate_kinds, "gate " + gate.metric + " of score " + score->id);
        gate.value = gates.optional_real(5);
        gate.unit = gates.text(6);
        gate.limit = gates.optional_real(7);
        gate.limit_source = gates.text(8);
        gate.z = gates.optional_real(9);
        gate.points = gates.optional_real(10);
        gate.passed = gates.optional_flag(11);
        gate.provisional = gates.flag(12);
        gate.not_passed_because = statement_of(gates.text(13));
        score->gates.push_back(std::move(gate));
    }
}

constexpr const char* metric_columns =
    "t.id, t.version, t.hand, t.tissue, t.value, t.absent_because, t.unit, t.direction, t.evidence";

/// Of a row that has these columns after the id of its score.
MetricRow metric_of(const Query& row) {
    MetricRow metric;
    metric.id = row.text(1);
    metric.version = static_cast<int>(row.integer(2));
    metric.hand = row.text(3);
    metric.tissue = row.text(4);
    metric.value = row.optional_real(5);
    if (std::string why = row.text(6); !why.empty()) metric.absent_because = statement_of(why);
    metric.unit = row.text(7);
    const std::string direction = row.text(8);
    const auto* const known = find_row(metric_directions, direction);
    metric.direction = known != nullptr
                           ? known->kind
                           : enum_of(direction, metric_directions,
                                     "direction of metric " + metric.id + " of score " + row.text(0));
    metric.evidence = parse_intervals(row.text(9));
    return metric;
}

void ScoreReader::read_metrics() {
    Query metrics = rows(metric_columns, "metric t", by_number);
    while (metrics.next())
        if (ScoreRow* score = find(metrics)) score->metrics.push_back(metric_of(metrics));
}

void ScoreReader::read_errors() {
    Query errors = rows("t.time_s, t.kind, t.hand, t.tissue, t.text", "critical_error t", by_number);
    while (errors.next())
        if (ScoreRow* score = find(errors))
            score->critical_errors.push_back(
                {errors.real(1), errors.text(2), errors.text(3), errors.text(4), errors.text(5)});
}

}  // namespace

std::string write_score(const Store& store, const Session& session, const std::string& attempt_id,
                        ScoreRow score) {
    Connection& connection = store.connection();
    Transaction transaction(connection);
    Query in_force(connection, "SELECT 1 FROM score WHERE attempt_id = ? AND in_force = 1");
    in_force.bind(attempt_id);
    score.in_force = !in_force.next();
    score.id = random_uuid();
    score.computed = store.now();
    if (score.passed && !score.not_scored_because.empty()) {
        throw StoreError(
            StoreErrorKind::bad_value,
            QT_TRANSLATE_NOOP("errors", "a score is passed, failed, or not scored with a reason"),
            QT_TRANSLATE_NOOP("errors", "give one of them"));
    }
    write_row(connection, attempt_id, score);
    write_gates(connection, score);
    write_metrics(connection, score);
    write_errors(connection, score);
    if (!score.pathology.empty())
        Query(connection, "INSERT INTO pathology (score_id, report) VALUES (?, ?)")
            .bind(score.id)
            .bind(score.pathology)
            .run();
    // The payload holds the digest, not the values: an administrator who reads the audit log sees no
    // scores.
    Audit(store).append(session, score.id, "score.add",
                        json_object({{"attempt", attempt_id}, {"digest", score_digest(attempt_id, score)}}),
                        {{RecordKind::score, score.id}});
    transaction.commit();
    return score.id;
}

ScoreRow read_score(Connection& connection, const std::string& score_id) {
    std::vector<ScoreOfAttempt> found = ScoreReader(connection, "s.id = ?", {score_id}).read();
    return found.empty() ? ScoreRow() : std::move(found.front().score);
}

std::map<std::string, ScoreRow> read_scores_in_force(Connection& connection, const QString& whose,
                                                     const std::vector<std::string>& values) {
    std::map<std::string, ScoreRow> scores;
    for (ScoreOfAttempt& one : ScoreReader(connection, "s.in_force = 1 AND " + whose, values).read())
        scores.emplace(std::move(one.attempt_id), std::move(one.score));
    return scores;
}

std::unordered_map<std::string, std::vector<MetricRow>> read_metrics_in_force(
    Connection& connection, const QString& whose, const std::vector<std::string>& values) {
    // Sorted here: a database sorts the rows with all their texts.
    Query rows(connection, QString("SELECT s.id, %1, t.number, a.id FROM attempt a JOIN score s ON "
                                   "s.attempt_id = a.id AND s.in_force = 1 JOIN metric t ON t.score_id = "
                                   "s.id WHERE %2")
                               .arg(metric_columns, whose));
    for (const std::string& value : values) rows.bind(value);
    constexpr int number_column = 10, attempt_column = 11;
    std::unordered_map<std::string, std::vector<std::pair<std::int64_t, MetricRow>>> found;
    while (rows.next())
        found[rows.text(attempt_column)].emplace_back(rows.integer(number_column), metric_of(rows));
    std::unordered_map<std::string, std::vector<MetricRow>> metrics;
    for (auto& [attempt, numbered] : found) {
        std::sort(numbered.begin(), numbered.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<MetricRow>& list = metrics[attempt];
        list.reserve(numbered.size());
        for (auto& one : numbered) list.push_back(std::move(one.second));
    }
    return metrics;
}

}  // namespace fulcrum::database
