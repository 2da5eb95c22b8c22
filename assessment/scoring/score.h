// SPDX-License-Identifier: Apache-2.0
// Holds an attempt's metrics against the task's gates: passed, failed or not scored. Non-compensatory: every
// gate counts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/task/task.h"

namespace fulcrum {

/// How an attempt ended, from its events: simulator_fault beats every end; no end event means interrupted.
AttemptState attempt_state(const std::vector<Event>& events);

/// A critical error as it happened.
struct CriticalError {
    std::string event;   ///< event_name()
    std::string hand;    ///< "left", "right" or ""
    std::string tissue;  ///< label or ""
    double time_s = 0;
};
/// The events that the task calls critical, in order. `tissues` is the trace's table.
std::vector<CriticalError> critical_errors(const TaskDefinition& task, const std::vector<Event>& events,
                                           const Trace& trace);

/// One row of `gates`.
struct GateResult {
    std::string metric, hand, tissue;
    GateKind kind = GateKind::benchmark;  ///< absolute also where a benchmark set gives such a limit
    std::optional<double> value;
    std::string unit;
    std::optional<double> limit;  ///< in `unit`; absent where no set has a level
    std::string limit_source;
    std::optional<double> z;       ///< worse than the experts where positive; benchmark gates only
    std::optional<double> points;  ///< 0..100; benchmark gates with z_novice > 0.5 only
    std::optional<bool> passed;    ///< absent where it could not be judged
    bool provisional = false;
    Statement absent_because;  ///< why value, limit or passed are absent
    std::vector<TimeInterval> evidence;
};

/// Points of a passed attempt are at least this, points of a failed one are below it.
inline constexpr double pass_mark = 60;

struct Score {
    std::optional<bool> passed;
    Statement not_scored_because;  ///< empty where passed has a value
    std::optional<double> points;  ///< never without passed, never on the other side of the pass mark
    bool provisional = false;      ///< some gate's limit is provisional
    std::vector<GateResult> gates;
    std::vector<CriticalError> critical_errors;
    Statement advice;                           ///< one sentence
    std::vector<TimeInterval> advice_evidence;  ///< where to jump, may be empty
};

/// What a score is a pure function of.
struct ScoreInput {
    const TaskDefinition& task;
    const std::vector<MetricResult>& metrics;
    const BenchmarkSet* benchmark = nullptr;  ///< null: none for this task and device class
    AttemptState state = AttemptState::completed;
    bool moved = true;  ///< the first active movement happened
    std::vector<CriticalError> critical_errors = {};
    /// Phases as they ran, for "where": name and interval.
    struct Phase {
        std::string name;
        TimeInterval interval;
    };
    std::vector<Phase> phases = {};
    Statement why_no_benchmark = {};  ///< with a null `benchmark`: why the task's limits do not apply
    bool device_lost = false;         ///< a device was lost and came back: what followed is practice
};

/// Pure: the same input gives the same score and advice.
Score score_attempt(const ScoreInput& input);
/// As they ran, from phase_begin and phase_end events; names from the task's goals.
std::vector<ScoreInput::Phase> phases_of(const TaskDefinition& task, const std::vector<Event>& events,
                                         const Trace& trace);
/// From an attempt's record to its score.
Score score_attempt(const TaskDefinition& task, const Trace& trace, const std::vector<Event>& events,
                    const std::vector<MetricResult>& metrics, const BenchmarkSet* benchmark,
                    const Statement& why_no_benchmark = {});

/// The `gates` array of `perform`.
nlohmann::json gates_to_json(const std::vector<GateResult>& gates);
nlohmann::json critical_errors_to_json(const std::vector<CriticalError>& errors);
/// Throws InputError naming `file` and the gate: metric unknown or context only, hand or kind wrong, more
/// than 6 benchmark gates.
void check_gates(const TaskDefinition& task, const std::string& file);

}  // namespace fulcrum
