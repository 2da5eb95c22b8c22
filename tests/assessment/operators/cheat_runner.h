// SPDX-License-Identifier: Apache-2.0
// Performs and scores one attempt of a rig, as far as it takes to know the verdict.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "assessment/attempt/memory_sink.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "assessment/operators/cheats.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/score.h"
#include "tests/support/support.h"

namespace fulcrum::test {

/// A task with its scene and its benchmark set, loaded once.
struct CheatStage {
    explicit CheatStage(const std::string& id)
        : task(load_task(source_path("assets/tasks/" + id + ".json"))),
          scene(load_scene(source_path("assets/scenes/" + task.scene))),
          benchmark(load_benchmark(source_path("assets/benchmarks/" + id + ".json"))) {
        for (const TissueSpec& tissue : scene.tissues) labels.push_back(tissue.label);
    }
    TaskDefinition task;
    Scene scene;
    BenchmarkSet benchmark;
    std::vector<std::string> labels;
};

struct CheatVerdict {
    Score score;
    AttemptState state = AttemptState::interrupted;
    double seconds = 0;  ///< simulated
    /// The gates that were not met and the critical errors, for messages.
    std::string why() const {
        std::string text;
        for (const CriticalError& error : score.critical_errors) text += error.event + "! ";
        for (const GateResult& gate : score.gates)
            if (gate.passed == false) text += gate.metric + (gate.hand.empty() ? "" : "." + gate.hand) + " ";
        return text;
    }
};

inline Score score_so_far(const CheatStage& stage, const AttemptRecord& record,
                          const std::vector<TargetSphere>& targets) {
    const std::array<bool, hand_count> hands = {stage.scene.instrument(Hand::left) != nullptr,
                                                stage.scene.instrument(Hand::right) != nullptr};
    const Trace trace =
        trace_from_samples(record.samples, record.events, stage.labels, stage.scene.tick_rate, hands);
    MetricContext context = make_metric_context(stage.scene, stage.task, targets);
    context.metrics.clear();
    for (const GateSpec& gate : stage.task.gates) context.metrics.push_back(gate.metric);
    return score_attempt(stage.task, trace, record.events, compute_metrics(trace, record.events, context),
                         &stage.benchmark);
}

inline constexpr double longest_rest_s = 30;

/// No continuation can pass: what an interruption cannot take back is broken (Score,
/// WhatIsBrokenForGoodStaysFailed), or a limit on time or path, which only grow, has been passed.
inline bool fails_whatever_follows(const Score& score) {
    return score.passed == false ||
           std::any_of(score.gates.begin(), score.gates.end(), [](const GateResult& gate) {
               return (gate.metric == "time" || gate.metric == "path_len" || gate.metric == "scope_path") &&
                      gate.value && gate.limit && *gate.value > *gate.limit;
           });
}

/// Of the benchmark set, s; the task's own limit where it has none.
inline double limit_on_time(const CheatStage& stage) {
    const BenchmarkLevel* level = stage.benchmark.find("time", "", "");
    return level == nullptr ? stage.task.time_limit_s
                            : limit_of(*find_metric("time"), *level, stage.benchmark.k);
}

/// Stops as soon as the attempt fails whatever follows; its verdict is then failed. It stops too after half a
/// minute in which no hand moved: what cheats do begins within 20 s, so the rest of the time limit would be
/// the same. `whole` runs to the end all the same.
inline CheatVerdict judge(const CheatStage& stage, Rig& rig, std::uint64_t seed, bool whole = false) {
    AttemptEngine engine(stage.scene, stage.task, seed);
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    MemorySink sink;
    CheatVerdict verdict;
    double next = 10;
    const double after_limit = limit_on_time(stage) + 2;
    const auto undecided = [&](double seconds) {
        verdict.seconds = seconds;
        if (whole || seconds < next) return true;
        const std::vector<Event>& events = sink.record.events;
        if (seconds > longest_rest_s && std::none_of(events.begin(), events.end(), [](const Event& event) {
                return event.kind == EventKind::first_movement;
            }))
            return false;
        // Each look reads the record from its beginning: with a constant interval the looks would cost more
        // than the attempt. One look is soon after the limit on time.
        next = std::max(seconds + 10, 1.5 * seconds);
        if (seconds < after_limit) next = std::min(next, after_limit);
        return !fails_whatever_follows(score_so_far(stage, sink.record, targets));
    };
    const RunOutcome outcome = run_headless(engine, rig, sink, undecided);
    verdict.seconds = outcome.ticks * stage.scene.tick_period();
    verdict.score = score_so_far(stage, sink.record, targets);
    verdict.state = attempt_state(sink.record.events);
    return verdict;
}

}  // namespace fulcrum::test
