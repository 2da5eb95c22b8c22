// SPDX-License-Identifier: Apache-2.0
// One sentence: what, where (hand and phase), by how much, one thing to try. Worst first: a critical error,
// an absolute gate by value over limit, a benchmark gate by z; then that the attempt was not carried to its
// end, and only of one that was, a gate whose metric is absent: what was not reached was not done badly.
#include <cmath>
#include <limits>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum {

namespace {

/// A value with its unit, as many digits as the metric's precision asks for.
std::string value_text(const MetricDescriptor& d, double value) {
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(d.precision) - 1e-9)));
    std::string text = decimal_text(value, digits);
    if (d.unit != "-") text += " " + d.unit;
    return text;
}

void replace(std::string& text, const std::string& mark, const std::string& with) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + with.size()))
        text.replace(at, mark.size(), with);
}

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

/// "Left hand, in 'Run the bowel': " or "".
std::string where_text(const std::string& hand, const std::string& phase) {
    std::string text = hand_words(hand);
    if (!phase.empty()) text += (text.empty() ? "In '" : ", in '") + phase + "'";
    if (text.empty()) return text;
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text + ": ";
}

std::string excess_text(const MetricDescriptor& d, const GateResult& gate) {
    if (gate.z) return decimal_text(*gate.z, 1) + " standard deviations from the experts";
    const double value = gated_value(d, *gate.value), limit = *gate.limit;
    if (d.direction == Direction::lower && limit > 0)
        return decimal_text(100.0 * (value - limit) / limit, 0) + " % over";
    return value_text(d, std::abs(value - limit)) + (d.direction == Direction::lower ? " over" : " short");
}

std::string sentence_of(const ScoreInput& input, const GateResult& gate) {
    const MetricDescriptor& d = *find_metric(gate.metric);
    std::string fault = d.advice_fault;
    replace(fault, "{value}", value_text(d, gated_value(d, *gate.value)));
    replace(fault, "{limit}", value_text(d, *gate.limit));
    std::string sentence =
        where_text(gate.hand, phase_of(input, gate)) + fault + " (" + excess_text(d, gate) + ")";
    if (!gate.tissue.empty()) sentence += ", on " + gate.tissue;
    if (sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    return sentence + "; " + d.advice_remedy + ".";
}

std::string clock_text(double t) {
    const auto seconds = static_cast<int>(std::max(0.0, t));
    return std::to_string(seconds / 60) + (seconds % 60 < 10 ? ":0" : ":") + std::to_string(seconds % 60);
}

Advice critical_advice(const ScoreInput& input, const CriticalError& error) {
    std::string what = error.event;
    replace(what, "_", " ");
    std::string sentence = where_text(error.hand, phase_at(input, error.time_s)) + "critical error, " + what;
    if (!error.tissue.empty()) sentence += " (" + error.tissue + ")";
    sentence += " at " + clock_text(error.time_s);
    const MetricDescriptor* d = find_metric(error.event);
    sentence += "; " +
                (d != nullptr ? d->advice_remedy : std::string("replay that moment and plan another way")) +
                ".";
    if (sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    return {sentence, {{std::max(0.0, error.time_s - 2.0), error.time_s + 1.0}}};
}

/// How many times the limit an absolute gate was broken by; a limit of 0 is beyond any factor.
double overshoot(const GateResult& gate) {
    const MetricDescriptor& d = *find_metric(gate.metric);
    const double value = gated_value(d, *gate.value), limit = *gate.limit;
    const double part = d.direction == Direction::higher ? limit / value : value / limit;
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
    if (gate == nullptr) return {"All gates are met; repeat it to make it a habit.", {}};
    const MetricDescriptor& d = *find_metric(gate->metric);
    std::string what = d.name;
    if (!gate->hand.empty()) what += ", " + hand_words(gate->hand);
    return {"All gates are met, most narrowly " + what + " (" + value_text(d, gated_value(d, *gate->value)) +
                "; the limit is " + value_text(d, *gate->limit) + "); " + d.advice_remedy + ".",
            phase_of(input, *gate).empty() ? std::vector<TimeInterval>{} : gate->evidence};
}

}  // namespace

Advice make_advice(const ScoreInput& input, const Score& score) {
    if (!score.critical_errors.empty()) return critical_advice(input, score.critical_errors.front());
    for (const GateKind kind : {GateKind::absolute, GateKind::benchmark})
        if (const GateResult* gate = worst_gate(score, kind))
            return {sentence_of(input, *gate), gate->evidence};
    if (score.passed == true) return passed_advice(input, score);
    if (input.state == AttemptState::timed_out)
        return {
            "The time ran out before the last goal was reached; " + find_metric("time")->advice_remedy + ".",
            {}};
    if (input.state == AttemptState::abandoned)
        return {
            "The attempt was abandoned before the last goal was reached; carry the next one through to its "
            "end.",
            {}};
    for (const GateResult& gate : score.gates)
        if (input.state == AttemptState::completed && gate.passed == false) {
            const MetricDescriptor& d = *find_metric(gate.metric);
            return {where_text(gate.hand, {}) + d.name + " has no value because " + gate.absent_because +
                        "; " + d.advice_remedy + ".",
                    {}};
        }
    return {"Not scored: " + score.not_scored_because + ".", {}};
}

}  // namespace fulcrum
