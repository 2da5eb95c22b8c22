// SPDX-License-Identifier: Apache-2.0
// What happened, where (hand and phase), by how much; the words add one thing to try. Worst first: a critical
// error, an absolute gate by value over limit, a benchmark gate by z; then that the attempt was not
// completed, and only of one that was, a gate whose metric is absent: a goal that was not reached was not
// done badly.
#include <cmath>
#include <limits>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"

namespace fulcrum {

namespace {

std::string phase_at(const ScoreInput& input, double t) {
    for (const ScoreInput::Phase& phase : input.phases)
        if (t >= phase.interval.begin && t <= phase.interval.end) return phase.name;
    return {};
}

std::string phase_of(const ScoreInput& input, const GateResult& gate) {
    // Only evidence that points at a moment names a phase; a whole attempt has many.
    if (gate.evidence.empty() || gate.evidence.front().end - gate.evidence.front().begin > 30.0) return {};
    return phase_at(input, 0.5 * (gate.evidence.front().begin + gate.evidence.front().end));
}

/// What the task says to try where a gate is not met; "": the metric says it.
std::string task_advice(const ScoreInput& input, const GateResult& gate) {
    for (const GateSpec& spec : input.task.gates)
        if (spec.metric == gate.metric && spec.hand == gate.hand && spec.tissue == gate.tissue)
            return spec.advice;
    return {};
}

Advice missed_advice(const ScoreInput& input, const GateResult& gate) {
    const double value = gated_value(*find_metric(gate.metric), *gate.value);
    Statement statement(StatementId::gate_missed, {{"metric", gate.metric},
                                                   {"hand", gate.hand},
                                                   {"tissue", gate.tissue},
                                                   {"phase", phase_of(input, gate)},
                                                   {"value", value},
                                                   {"limit", *gate.limit}});
    if (gate.z) statement.add({"z", *gate.z});
    const std::string advice = task_advice(input, gate);
    if (!advice.empty()) statement.add({"advice", advice});
    return {std::move(statement), gate.evidence};
}

Advice critical_advice(const ScoreInput& input, const CriticalError& error) {
    return {{StatementId::critical_error,
             {{"event", error.event},
              {"hand", error.hand},
              {"tissue", error.tissue},
              {"phase", phase_at(input, error.time_s)},
              {"time_s", error.time_s}}},
            {{std::max(0.0, error.time_s - 2.0), error.time_s + 1.0}}};
}

/// How many times the limit an absolute gate was broken by; a limit of 0 is beyond any factor.
double overshoot(const GateResult& gate) {
    const MetricDescriptor& d = *find_metric(gate.metric);
    const double value = gated_value(d, *gate.value), limit = *gate.limit;
    // Of two values below 0 the lower is the larger share.
    const bool inverse = (d.direction == Direction::higher) != (value < 0 && limit < 0);
    const double part = inverse ? limit / value : value / limit;
    return std::isfinite(part) && part > 0 ? part : std::numeric_limits<double>::infinity();
}

bool judged(const GateResult& gate) {
    return gate.value && gate.limit && gate.passed;
}

/// The worst gate of one kind that was not met; the first of equals.
const GateResult* worst_gate(const Score& score, GateKind kind) {
    const GateResult* worst = nullptr;
    double most = 0;
    for (const GateResult& gate : score.gates) {
        if (gate.kind != kind || !judged(gate) || *gate.passed) continue;
        const double badness = gate.z ? *gate.z : overshoot(gate);
        if (worst != nullptr && badness <= most) continue;
        worst = &gate;
        most = badness;
    }
    return worst;
}

/// Of a passed attempt: the benchmark gate nearest to its limit.
const GateResult* narrowest_gate(const Score& score) {
    const GateResult* narrowest = nullptr;
    for (const GateResult& gate : score.gates)
        if (judged(gate) && gate.z && (narrowest == nullptr || *gate.z > *narrowest->z)) narrowest = &gate;
    return narrowest;
}

Advice passed_advice(const ScoreInput& input, const Score& score) {
    const GateResult* gate = narrowest_gate(score);
    if (gate == nullptr) return {StatementId::gates_met, {}};
    return {{StatementId::gates_met_narrowly,
             {{"metric", gate->metric},
              {"hand", gate->hand},
              {"value", gated_value(*find_metric(gate->metric), *gate->value)},
              {"limit", *gate->limit}}},
            phase_of(input, *gate).empty() ? std::vector<TimeInterval>{} : gate->evidence};
}

}  // namespace

Advice make_advice(const ScoreInput& input, const Score& score) {
    if (!score.critical_errors.empty()) return critical_advice(input, score.critical_errors.front());
    for (const GateKind kind : {GateKind::absolute, GateKind::benchmark})
        if (const GateResult* gate = worst_gate(score, kind)) return missed_advice(input, *gate);
    if (score.passed == true) return passed_advice(input, score);
    if (input.state == AttemptState::timed_out)
        return {{StatementId::time_ran_out, {{"metric", "time"}}}, {}};
    if (input.state == AttemptState::abandoned) return {StatementId::attempt_abandoned, {}};
    for (const GateResult& gate : score.gates)
        if (input.state == AttemptState::completed && gate.passed == false)
            return {{StatementId::gate_without_value,
                     {{"metric", gate.metric}, {"hand", gate.hand}, {"because", gate.absent_because}}},
                    {}};
    return {{StatementId::not_scored, {{"because", score.not_scored_because}}}, {}};
}

}  // namespace fulcrum
