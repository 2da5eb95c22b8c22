// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include "assessment/metrics/metric_names.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/score_rows.h"

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

void add_gates(Canonical& canonical, const ScoreRow& score) {
    canonical.add(static_cast<std::int64_t>(score.gates.size()));
    for (const GateRow& gate : score.gates) {
        canonical.add(gate.metric)
            .add(gate.hand)
            .add(gate.tissue)
            .add(std::string(row_of(gate_kinds, gate.kind).name))
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
}

void add_metrics(Canonical& canonical, const ScoreRow& score) {
    canonical.add(static_cast<std::int64_t>(score.metrics.size()));
    for (const MetricRow& metric : score.metrics) {
        canonical.add(metric.id)
            .add(std::int64_t{metric.version})
            .add(metric.hand)
            .add(metric.tissue)
            .add(metric.value);
        canonical.add(stored_text(metric.absent_because))
            .add(metric.unit)
            .add(std::string(row_of(metric_directions, metric.direction).name))
            .add(json_intervals(metric.evidence));
    }
}

void add_errors(Canonical& canonical, const ScoreRow& score) {
    canonical.add(static_cast<std::int64_t>(score.critical_errors.size()));
    for (const CriticalErrorRow& error : score.critical_errors) {
        canonical.add(error.time_s).add(error.kind).add(error.hand).add(error.tissue).add(error.text);
    }
}

}  // namespace

std::string score_digest(const std::string& attempt_id, const ScoreRow& score) {
    Canonical canonical;
    canonical.add(attempt_id).add(score.id).add(score.computed).add(score.program_version).add(score.limits);
    canonical.add(std::int64_t{score.in_force})
        .add(score.passed)
        .add(stored_text(score.not_scored_because))
        .add(score.points)
        .add(stored_text(score.advice));
    add_gates(canonical, score);
    add_metrics(canonical, score);
    add_errors(canonical, score);
    if (!score.pathology.empty())
        canonical.add(score.pathology);  // the digest of a score from before there were any stays the same
    return to_hex(blake2b(canonical.bytes()));
}

}  // namespace fulcrum::database
