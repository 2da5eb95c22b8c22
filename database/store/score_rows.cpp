// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/score_rows.h"

#include "assessment/metrics/metric_names.h"
#include "database/rows/crypto.h"
#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

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

void read_gates(Connection& connection, ScoreRow& score) {
    Query gates(connection,
                "SELECT metric, hand, tissue, kind, value, unit, limit_value, limit_source, z, points, "
                "passed, provisional, "
                "not_passed_because FROM gate WHERE score_id = ? ORDER BY number");
    gates.bind(score.id);
    while (gates.next()) {
        GateRow gate;
        gate.metric = gates.text(0);
        gate.hand = gates.text(1);
        gate.tissue = gates.text(2);
        gate.kind = enum_of(gates.text(3), gate_kinds, "gate " + gate.metric + " of score " + score.id);
        gate.value = gates.optional_real(4);
        gate.unit = gates.text(5);
        gate.limit = gates.optional_real(6);
        gate.limit_source = gates.text(7);
        gate.z = gates.optional_real(8);
        gate.points = gates.optional_real(9);
        gate.passed = gates.optional_flag(10);
        gate.provisional = gates.flag(11);
        gate.not_passed_because = statement_of(gates.text(12));
        score.gates.push_back(std::move(gate));
    }
}

void read_metrics(Connection& connection, ScoreRow& score) {
    Query metrics(
        connection,
        "SELECT id, version, hand, tissue, value, absent_because, unit, direction, evidence FROM metric "
        "WHERE score_id = ? ORDER BY number");
    metrics.bind(score.id);
    while (metrics.next()) {
        MetricRow metric;
        metric.id = metrics.text(0);
        metric.version = static_cast<int>(metrics.integer(1));
        metric.hand = metrics.text(2);
        metric.tissue = metrics.text(3);
        metric.value = metrics.optional_real(4);
        metric.absent_because = statement_of(metrics.text(5));
        metric.unit = metrics.text(6);
        metric.direction = enum_of(metrics.text(7), metric_directions,
                                   "direction of metric " + metric.id + " of score " + score.id);
        metric.evidence = parse_intervals(metrics.text(8));
        score.metrics.push_back(std::move(metric));
    }
}

void read_errors(Connection& connection, ScoreRow& score) {
    Query errors(
        connection,
        "SELECT time_s, kind, hand, tissue, text FROM critical_error WHERE score_id = ? ORDER BY number");
    errors.bind(score.id);
    while (errors.next()) {
        score.critical_errors.push_back(
            {errors.real(0), errors.text(1), errors.text(2), errors.text(3), errors.text(4)});
    }
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
    ScoreRow score;
    Query row(connection,
              "SELECT id, computed, program_version, limits, in_force, passed, not_scored_because, points, "
              "advice FROM score "
              "WHERE id = ?");
    row.bind(score_id);
    if (!row.next()) return score;
    score.id = row.text(0);
    score.computed = row.integer(1);
    score.program_version = row.text(2);
    score.limits = row.text(3);
    score.in_force = row.flag(4);
    score.passed = row.optional_flag(5);
    score.not_scored_because = statement_of(row.text(6));
    score.points = row.optional_real(7);
    score.advice = statement_of(row.text(8));
    read_gates(connection, score);
    read_metrics(connection, score);
    read_errors(connection, score);
    Query pathology(connection, "SELECT report FROM pathology WHERE score_id = ?");
    pathology.bind(score_id);
    if (pathology.next()) score.pathology = pathology.text(0);
    return score;
}

}  // namespace fulcrum::database
