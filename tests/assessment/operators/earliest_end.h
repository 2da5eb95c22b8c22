// SPDX-License-Identifier: Apache-2.0
// Whether an attempt can still pass: the product scores what was recorded so far as if the task were
// completed as soon as it can be. What is broken even then stays broken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "assessment/attempt/engine.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/judged_limits.h"
#include "assessment/scoring/score.h"
#include "tests/support/support.h"

namespace fulcrum::test {

/// A task with its scene and its benchmark set, loaded once.
struct CheatStage {
    explicit CheatStage(const std::string& id)
        : task(load_task(source_path("assets/tasks/" + id + ".json"))),
          scene(load_scene(source_path("assets/scenes/" + task.scene))),
          benchmark(load_benchmark(source_path("assets/benchmarks/" + id + ".json"))),
          lasting(task),
          limits(judged_limits(task, &benchmark)) {
        for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
        std::vector<GateSpec>& gates = lasting.gates;
        gates.erase(std::remove_if(gates.begin(), gates.end(),
                                   [](const GateSpec& gate) { return !stays_broken(gate.metric); }),
                    gates.end());
        for (const JudgedLimit& limit : limits)
            if (limit.metric == "time") longest_s = limit.limit;
    }
    TaskDefinition task;
    Scene scene;
    BenchmarkSet benchmark;
    TaskDefinition lasting;  ///< the task with those gates alone that a part of an attempt breaks for good
    std::vector<JudgedLimit> limits;
    std::optional<double> longest_s;  ///< that its limit on time leaves
    std::vector<std::string> labels;
};

/// As the product scores an attempt, by the gates of `task`: the stage's own, or some of them.
inline Score score_by(const CheatStage& stage, const TaskDefinition& task,
                      const std::vector<TickSample>& samples, const std::vector<Event>& events,
                      const std::vector<TargetSphere>& targets) {
    const std::array<bool, hand_count> hands = {stage.scene.instrument(Hand::left) != nullptr,
                                                stage.scene.instrument(Hand::right) != nullptr};
    const Trace trace = trace_from_samples(samples, events, stage.labels, stage.scene.tick_rate, hands);
    MetricContext context = make_metric_context(stage.scene, stage.task, targets);
    context.metrics.clear();
    for (const GateSpec& gate : task.gates) context.metrics.push_back(gate.metric);
    return score_attempt(task, trace, events, compute_metrics(trace, events, context), &stage.benchmark);
}

/// s that the goals after this one ask to hold: without it the task is not completed.
inline double holds_after(const TaskDefinition& task, int goal) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(std::max(0, goal)) + 1; i < task.goals.size(); ++i)
        sum += task.goals[i].hold_s;
    return sum;
}

/// The events of an attempt whose task is completed so many seconds after a tick, without a further pause.
inline std::vector<Event> completed_after(const std::vector<Event>& so_far, std::uint32_t tick,
                                          double seconds, double tick_period) {
    std::vector<Event> events = so_far;
    Event next;
    next.tick = tick;
    next.kind = EventKind::resume;
    events.push_back(next);
    next.tick += static_cast<std::uint32_t>(std::lround(seconds / tick_period));
    next.kind = EventKind::completed;
    events.push_back(next);
    return events;
}

/// "path_len.left"
inline std::string name_of(const GateResult& gate) {
    return gate.metric + (gate.hand.empty() ? "" : "." + gate.hand);
}

/// What of a score no continuation takes back: critical errors, and broken limits whose value can only get
/// worse (the rule that keeps an interrupted attempt failed; Score, WhatIsBrokenForGoodStaysFailed).
inline std::string broken_for_good(const Score& score) {
    std::string text;
    for (const CriticalError& error : score.critical_errors) text += error.event + "! ";
    for (const GateResult& gate : score.gates)
        if (gate.value && gate.passed == false && stays_broken(gate.metric)) text += name_of(gate) + " ";
    return text;
}

}  // namespace fulcrum::test
