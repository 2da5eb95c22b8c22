// SPDX-License-Identifier: Apache-2.0
// Builds a benchmark set from named experts' attempts, and refuses one that its own experts would not pass.
#pragma once

#include <string>
#include <vector>

#include "assessment/scoring/score.h"
#include "sim_core/numerics/sentence.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {

/// A counted attempt (after familiarisation).
struct BenchmarkAttempt {
    std::string person;
    std::vector<MetricResult> metrics;
    AttemptState state = AttemptState::completed;
    std::vector<CriticalError> critical_errors;
    bool simulated = false;  ///< by a synthetic operator, or on the account of a synthetic person
};

struct BenchmarkRequest {
    std::string variant_family = standard_variant, fidelity = standard_fidelity, source;
    DeviceClass device_class = DeviceClass::haptic;
    int version = 1;
    bool provisional = true;  ///< where an expert is simulated, the set is in any case
    int familiarisation = 3;  ///< attempts each person made before the counted ones
    bool outliers =
        true;  ///< experts far from the others are left out; operators are not: their presets vary so
    double p0 = 0.125;  ///< share of a proficient person's attempts that may fail: the middle of 5 to 20 %
    double most_failing = 0.2;  ///< a set that fails a larger share of its own experts' attempts is refused
    int minimum_experts = 8, minimum_attempts = 3;
    int minimum_familiarisation = 3;  ///< 0 for synthetic operators, who do not learn
    std::vector<BenchmarkAttempt> experts, novices;
    std::vector<BenchmarkAttempt> intermediates;  ///< who are to pass seldom; may be empty
    CuttingValues cutting;                        ///< as BenchmarkSet::cutting
};

/// The values that were tried, in order, for the screen, also after a refusal.
struct BenchmarkTrial {
    double k = 0;
    double pass_share = 0;
};
/// A gate, or a critical error, that so many of the experts' own attempts failed with their expert left out.
struct BenchmarkFailure {
    std::string metric, hand;  ///< of a gate
    std::string event;         ///< of a critical error
    int attempts = 0;
};
struct BenchmarkBuild {
    std::optional<BenchmarkSet> set;  ///< absent after a refusal
    Sentence refusal;                 ///< why; empty with a set
    std::vector<BenchmarkTrial> trials;
    std::vector<BenchmarkFailure> failures;  ///< at the chosen k, of the experts' own attempts
    std::vector<std::string>
        log;  ///< outliers left out, metrics turned into absolute gates, gates that failed experts
};

/// Pure. Of k from 1 to 3 in steps of 0.1 the one whose leave-one-expert-out pass share is nearest to 1 - p0;
/// of several equally near, the middle one. Below k = 1 one gate alone would fail an expert in six. Where
/// there are intermediates and the share of them that pass is not surely within 5 to 40 %, each gate gets a k
/// of its own from there, unless too many experts who had no part in the choice would fail them:
/// limits_for_fresh(). A set that is not provisional takes over the task's provisional limits: its experts'
/// attempts are judged by them too, and if they did not meet them it would be refused (taken_over.h).
BenchmarkBuild build_benchmark(const TaskDefinition& task, const BenchmarkRequest& request);

}  // namespace fulcrum
