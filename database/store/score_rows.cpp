// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/score_rows.h"

#include <cstring>

#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

/// Every field with its length before it and every number by its bits: two scores that differ anywhere differ
/// here.
class Canonical {
  public:
    Canonical& add(const std::string& text) {
        add(static_cast<std::int64_t>(text.size()));
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        return *this;
    }
    Canonical& add(std::int64_t value) {
        for (unsigned shift = 0; shift < 64; shift += 8) {
            bytes_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> shift));
        }
        return *this;
    }
    Canonical& add(double value) {
        const double plain = value + 0.0;  // SQLite keeps no sign of zero
        std::int64_t bits = 0;
        std::memcpy(&bits, &plain, sizeof bits);
        return add(bits);
    }
    template <typename Value>
    Canonical& add(const std::optional<Value>& value) {
        add(std::int64_t{value.has_value()});
        if (value) {
            if constexpr (std::is_same_v<Value, bool>) {
                add(std::int64_t{*value});
            } else {
                add(*value);
            }
        }
        return *this;
    }
    const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
};

}  // namespace

std::string score_digest(const std::string& attempt_id, const ScoreRow& score) {
    Canonical canonical;
    canonical.add(attempt_id).add(score.id).add(score.computed).add(score.program_version).add(score.limits);
    canonical.add(std::int64_t{score.in_force})
        .add(score.passed)
        .add(stored_text(score.not_scored_because))
        .add(score.points)
        .add(stored_text(score.advice));
    canonical.add(static_cast<std::int64_t>(score.gates.size()));
    for (const GateRow& gate : score.gates) {
        canonical.add(gate.metric)
            .add(gate.hand)
            .add(gate.tissue)
            .add(gate.kind)
            .add(gate.value)
            .add(gate.unit)
            .add(gate.limit.value_or(0));  // the source says whether there is one
        canonical.add(gate.limit_source)
            .add(gate.z)
            .add(gate.points)
            .add(gate.passed)
            .add(std::int64_t{gate.provisional});
        canonical.add(stored_text(gate.not_passed_because));
    }
    canonical.add(static_cast<std::int64_t>(score.metrics.size()));
    for (const MetricRow& metric : score.metrics) {
        canonical.add(metric.id)
            .add(std::int64_t{metric.version})
            .add(metric.hand)
            .add(metric.tissue)
            .add(metric.value);
        canonical.add(stored_text(metric.absent_because))
            .add(metric.unit)
            .add(metric.direction)
            .add(json_intervals(metric.evidence));
    }
    canonical.add(static_cast<std::int64_t>(score.critical_errors.size()));
    for (const CriticalErrorRow& error : score.critical_errors) {
        canonical.add(error.time_s).add(error.kind).add(error.hand).add(error.tissue).add(error.text);
    }
    if (!score.pathology.empty())
        canonical.add(score.pathology);  // scores of before there were any keep theirs
    return to_hex(blake2b(canonical.bytes()));
}

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
        throw StoreError(StoreErrorKind::bad_value, "a score is passed, failed, or not scored with a reason",
                         "give one of them");
    }
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
            .bind(gate.kind)
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
    number = 0;
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
            .bind(metric.direction)
            .bind(json_intervals(metric.evidence))
            .run();
    }
    number = 0;
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
    if (!score.pathology.empty())
        Query(connection, "INSERT INTO pathology (score_id, report) VALUES (?, ?)")
            .bind(score.id)
            .bind(score.pathology)
            .run();
    // The payload holds the digest, not the figures: the administrator who reads the audit log sees no
    // scores.
    Audit(store).append(session, score.id, "score.add",
                        json_object({{"attempt", attempt_id}, {"digest", score_digest(attempt_id, score)}}));
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
    Query gates(connection,
                "SELECT metric, hand, tissue, kind, value, unit, limit_value, limit_source, z, points, "
                "passed, provisional, "
                "not_passed_because FROM gate WHERE score_id = ? ORDER BY number");
    gates.bind(score_id);
    while (gates.next()) {
        GateRow gate;
        gate.metric = gates.text(0);
        gate.hand = gates.text(1);
        gate.tissue = gates.text(2);
        gate.kind = gates.text(3);
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
    Query metrics(
        connection,
        "SELECT id, version, hand, tissue, value, absent_because, unit, direction, evidence FROM metric "
        "WHERE score_id = ? ORDER BY number");
    metrics.bind(score_id);
    while (metrics.next()) {
        MetricRow metric;
        metric.id = metrics.text(0);
        metric.version = static_cast<int>(metrics.integer(1));
        metric.hand = metrics.text(2);
        metric.tissue = metrics.text(3);
        metric.value = metrics.optional_real(4);
        metric.absent_because = statement_of(metrics.text(5));
        metric.unit = metrics.text(6);
        metric.direction = metrics.text(7);
        metric.evidence = parse_intervals(metrics.text(8));
        score.metrics.push_back(std::move(metric));
    }
    Query errors(
        connection,
        "SELECT time_s, kind, hand, tissue, text FROM critical_error WHERE score_id = ? ORDER BY number");
    errors.bind(score_id);
    while (errors.next()) {
        score.critical_errors.push_back(
            {errors.real(0), errors.text(1), errors.text(2), errors.text(3), errors.text(4)});
    }
    Query pathology(connection, "SELECT report FROM pathology WHERE score_id = ?");
    pathology.bind(score_id);
    if (pathology.next()) score.pathology = pathology.text(0);
    return score;
}

}  // namespace fulcrum::database
