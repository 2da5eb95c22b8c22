// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/score.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"

namespace fulcrum {

namespace {

constexpr double best_failed =
    pass_mark - 1;  // points of a failed attempt whose benchmark gates are all at their best

/// Whether the recorded part of an attempt breaks a gate for good.
bool broke_for_good(const std::vector<GateResult>& gates) {
    return std::any_of(gates.begin(), gates.end(), [](const GateResult& gate) {
        return gate.value && gate.passed == false && stays_broken(gate.metric);
    });
}

/// Passed, failed or not scored; the order of the rules is the order in which they beat one another.
void decide(const ScoreInput& input, Score& score) {
    const auto not_scored = [&](Statement reason) { score.not_scored_because = std::move(reason); };
    // Nothing that happens later takes these back: no crash, no lost device, no simulator fault.
    const bool cut_off =
        input.state == AttemptState::interrupted || input.state == AttemptState::failed_simulation;
    if (!score.critical_errors.empty() || ((cut_off || input.device_lost) && broke_for_good(score.gates))) {
        score.passed = false;
        return;
    }
    if (input.state == AttemptState::failed_simulation) return not_scored(StatementId::simulator_failed);
    if (input.state == AttemptState::interrupted) return not_scored(StatementId::attempt_interrupted);
    if (input.state != AttemptState::completed) {
        if (input.state == AttemptState::abandoned && !input.moved)
            return not_scored(StatementId::ended_before_moving);
        score.passed = false;
        return;
    }
    if (input.device_lost) return not_scored(StatementId::device_was_lost);
    if (score.gates.empty()) return not_scored(StatementId::no_gates);
    const GateResult* open = nullptr;
    for (const GateResult& gate : score.gates) {
        if (gate.passed == false) {
            score.passed = false;
            return;
        }
        if (!gate.passed && open == nullptr) open = &gate;
    }
    if (open != nullptr && open->kind == GateKind::benchmark && !input.why_no_benchmark.empty())
        return not_scored(input.why_no_benchmark);
    if (open != nullptr)
        return not_scored(
            {StatementId::gate_not_judged,
             {{"metric", open->metric}, {"hand", open->hand}, {"because", open->absent_because}}});
    score.passed = true;
}

/// Mean over the gates that have points, on the verdict's side of the pass mark. A part of an attempt has
/// none: a short path of an abandoned attempt is no merit.
std::optional<double> attempt_points(const ScoreInput& input, const Score& score) {
    if (!score.passed) return std::nullopt;
    if (!score.critical_errors.empty()) return 0.0;
    if (input.state != AttemptState::completed) return std::nullopt;
    double sum = 0;
    int count = 0;
    for (const GateResult& gate : score.gates)
        if (gate.points) sum += *gate.points, ++count;
    if (count == 0) return std::nullopt;
    const double share = sum / count / 100;
    return *score.passed ? pass_mark + (100 - pass_mark) * share : best_failed * share;
}

}  // namespace

bool stays_broken(const std::string& metric) {
    const MetricDescriptor* d = find_metric(metric);
    if (d == nullptr) return false;
    if (d->direction == Direction::higher) return d->aggregation == Aggregation::minimum;
    if (d->direction != Direction::lower) return false;
    return d->aggregation == Aggregation::total || d->aggregation == Aggregation::maximum ||
           d->aggregation == Aggregation::count;
}

AttemptState attempt_state(const std::vector<Event>& events) {
    AttemptState state = AttemptState::interrupted;
    for (const Event& event : events) {
        if (event.kind == EventKind::simulator_fault) return AttemptState::failed_simulation;
        if (event.kind == EventKind::completed) state = AttemptState::completed;
        if (event.kind == EventKind::timed_out) state = AttemptState::timed_out;
        if (event.kind == EventKind::abandoned) state = AttemptState::abandoned;
        if (event.kind == EventKind::interrupted) state = AttemptState::interrupted;
    }
    return state;
}

std::vector<CriticalError> critical_errors(const TaskDefinition& task, const std::vector<Event>& events,
                                           const Trace& trace) {
    std::vector<CriticalError> errors;
    for (const Event& event : events) {
        const std::string name = event_name(event.kind);
        if (std::find(task.critical_errors.begin(), task.critical_errors.end(), name) ==
            task.critical_errors.end())
            continue;
        CriticalError error;
        error.event = name;
        if (event.hand < hand_count) error.hand = hand_name(static_cast<Hand>(event.hand));
        if (event.tissue >= 0 && static_cast<std::size_t>(event.tissue) < trace.tissues.size())
            error.tissue = trace.tissues[static_cast<std::size_t>(event.tissue)];
        error.time_s = trace.time_of(event);
        errors.push_back(std::move(error));
    }
    return errors;
}

std::vector<ScoreInput::Phase> phases_of(const TaskDefinition& task, const std::vector<Event>& events,
                                         const Trace& trace) {
    std::vector<ScoreInput::Phase> phases;
    std::vector<std::int32_t> open;  // index of the phase that each entry stands for
    for (const Event& event : events) {
        const double t = trace.time_of(event);
        if (event.kind == EventKind::phase_begin) {
            const auto index = static_cast<std::size_t>(std::max(0, event.detail));
            phases.push_back({index < task.goals.size() ? task.goals[index].text : std::string(),
                              {t, std::max(t, trace.end)}});
            open.push_back(event.detail);
        } else if (event.kind == EventKind::phase_end) {
            for (std::size_t i = phases.size(); i-- > 0;)
                if (open[i] == event.detail) {
                    phases[i].interval.end = std::max(t, phases[i].interval.begin);
                    break;
                }
        }
    }
    return phases;
}

Score score_attempt(const ScoreInput& input) {
    Score score;
    score.critical_errors = input.critical_errors;
    for (const GateSpec& spec : input.task.gates) {
        score.gates.push_back(judge_gate(spec, input.metrics, input.benchmark));
        GateResult& gate = score.gates.back();
        if (gate.kind == GateKind::benchmark && !input.why_no_benchmark.empty())
            gate.absent_because = input.why_no_benchmark;
        // A short path or little time of an attempt that was not carried to its end is not better than the
        // experts'.
        if (input.state != AttemptState::completed && gate.z && *gate.z < 0)
            gate.z = gate.points = std::nullopt;
        score.provisional = score.provisional || score.gates.back().provisional;
    }
    decide(input, score);
    score.points = attempt_points(input, score);
    Advice advice = make_advice(input, score);
    score.advice = std::move(advice.statement);
    score.advice_evidence = std::move(advice.evidence);
    return score;
}

Score score_attempt(const TaskDefinition& task, const Trace& trace, const std::vector<Event>& events,
                    const std::vector<MetricResult>& metrics, const BenchmarkSet* benchmark,
                    const Statement& why_no_benchmark) {
    ScoreInput input{task, metrics, benchmark, attempt_state(events)};
    input.why_no_benchmark = why_no_benchmark;
    input.moved = std::any_of(events.begin(), events.end(),
                              [](const Event& event) { return event.kind == EventKind::first_movement; });
    input.device_lost = std::any_of(events.begin(), events.end(),
                                    [](const Event& event) { return event.kind == EventKind::device_back; });
    input.critical_errors = critical_errors(task, events, trace);
    input.phases = phases_of(task, events, trace);
    return score_attempt(input);
}

nlohmann::json critical_errors_to_json(const std::vector<CriticalError>& errors) {
    using nlohmann::json;
    const auto text = [](const std::string& value) { return value.empty() ? json(nullptr) : json(value); };
    json rows = json::array();
    for (const CriticalError& error : errors)
        rows.push_back({{"event", error.event},
                        {"hand", text(error.hand)},
                        {"tissue", text(error.tissue)},
                        {"time_s", error.time_s}});
    return rows;
}

}  // namespace fulcrum
