// SPDX-License-Identifier: Apache-2.0
// How a gate judges a value; shared by scoring, the benchmark builder and advice.
#pragma once

#include <optional>
#include <string>

#include "assessment/metrics/metric.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/score.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// What a gate compares: the value, or its size where only that counts.
double gated_value(const MetricDescriptor& descriptor, double value);
/// On the metric's scale; absent for the logarithm of what is not above 0.
std::optional<double> on_scale(const MetricDescriptor& descriptor, double value);
/// d (x - mean) / deviation with d = +1 where lower is better, -1 where higher is: above 0 is worse than the
/// experts.
double z_of(const MetricDescriptor& descriptor, const BenchmarkLevel& level, double scaled);
/// The value at z = k, in the metric's unit.
double limit_of(const MetricDescriptor& descriptor, const BenchmarkLevel& level, double k);
/// True where the value keeps the limit in the metric's direction.
bool keeps_limit(const MetricDescriptor& descriptor, double value, double limit);
/// A value of this metric that a part of an attempt has already broken stays broken however the attempt would
/// have gone on.
bool stays_broken(const std::string& metric);
/// 100 clamp((z_novice - z) / z_novice, 0, 1); absent without z_novice above 0.5.
std::optional<double> points_of(const BenchmarkLevel& level, double z);
/// What is wrong with a gate on this metric: the key in its file, and what to say of it.
struct WrongRow {
    const char* key;
    Sentence what, hint;
};
/// Whether the metric has rows for this hand and tissue ("": none); nothing where it has.
std::optional<WrongRow> wrong_row(const MetricDescriptor& descriptor, const std::string& hand,
                                  const std::string& tissue);
/// The worst that happened and one thing to try, and where to look.
struct Advice {
    Statement statement;
    std::vector<TimeInterval> evidence;
};
Advice make_advice(const ScoreInput& input, const Score& score);

/// Judges one gate.
GateResult judge_gate(const GateSpec& spec, const std::vector<MetricResult>& metrics,
                      const BenchmarkSet* benchmark);

}  // namespace fulcrum
