// SPDX-License-Identifier: Apache-2.0
// Performs and scores one attempt of a rig, as far as it takes to know the verdict.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
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

// s after which an attempt is not followed further: before its first movement (what cheats do begins within
// 20 s), and while hands, pedals and camera stay exactly as they are (a hand that an operator holds still
// trembles). Both would last to the end of the time limit.
inline constexpr double longest_rest_s = 21, longest_stillness_s = 12;

/// No continuation can pass: the attempt has failed, or a limit is broken whose value can only get worse (the
/// rule that keeps an interrupted attempt failed; Score, WhatIsBrokenForGoodStaysFailed).
inline bool fails_whatever_follows(const Score& score) {
    return score.passed == false ||
           std::any_of(score.gates.begin(), score.gates.end(), [](const GateResult& gate) {
               return gate.value && gate.passed == false && stays_broken(gate.metric);
           });
}

/// s that the task's timer may still run before its limit is passed; nothing without that limit or a value.
inline std::optional<double> time_left(const Score& score) {
    for (const GateResult& gate : score.gates)
        if (gate.metric == "time" && gate.value && gate.limit) return *gate.limit - *gate.value;
    return std::nullopt;
}

inline bool same_input(const RigSample& a, const RigSample& b) {
    static_assert(std::has_unique_object_representations_v<DeviceSample>);
    return a.flags == b.flags && std::memcmp(&a.hand, &b.hand, sizeof a.hand) == 0 &&
           std::memcmp(&a.camera, &b.camera, sizeof a.camera) == 0;
}

/// When an attempt need not be followed further.
class Verdict {
  public:
    Verdict(const CheatStage& stage, const AttemptRecord& record, const std::vector<TargetSphere>& targets)
        : stage_(stage), record_(record), targets_(targets) {}

    /// Called once a simulated second.
    bool is_open(double seconds) {
        const std::vector<RigSample>& inputs = record_.inputs;
        for (; seen_ < inputs.size(); ++seen_)
            if (!same_input(inputs[seen_], inputs[seen_ - 1])) still_since_ = seconds;
        if (seconds - still_since_ >= longest_stillness_s) return false;
        if (seconds >= longest_rest_s &&
            std::none_of(record_.events.begin(), record_.events.end(),
                         [](const Event& event) { return event.kind == EventKind::first_movement; }))
            return false;
        if (seconds < next_look_) return true;
        const Score score = score_so_far(stage_, record_, targets_);
        if (fails_whatever_follows(score)) return false;
        // Each look reads the record from its beginning: with a constant interval the looks would cost more
        // than the attempt. One look comes as soon as the limit on time can have been passed.
        next_look_ = std::max(seconds + 3, 1.12 * seconds);
        if (const std::optional<double> left = time_left(score))
            next_look_ = std::min(next_look_, seconds + std::max(0.0, *left) + 0.01);
        return true;
    }

  private:
    const CheatStage& stage_;
    const AttemptRecord& record_;
    const std::vector<TargetSphere>& targets_;
    std::size_t seen_ = 1;
    double still_since_ = 0, next_look_ = 4;
};

/// Stops as soon as the attempt fails whatever follows; its verdict is then failed. `whole` runs to the end
/// all the same.
inline CheatVerdict judge(const CheatStage& stage, Rig& rig, std::uint64_t seed, bool whole = false) {
    AttemptEngine engine(stage.scene, stage.task, seed);
    const std::vector<TargetSphere>& targets = engine.initial_snapshot().targets;
    MemorySink sink;
    Verdict open(stage, sink.record, targets);
    const RunOutcome outcome =
        run_headless(engine, rig, sink, [&](double seconds) { return whole || open.is_open(seconds); });
    CheatVerdict verdict;
    verdict.seconds = outcome.ticks * stage.scene.tick_period();
    verdict.score = score_so_far(stage, sink.record, targets);
    verdict.state = attempt_state(sink.record.events);
    return verdict;
}

}  // namespace fulcrum::test
