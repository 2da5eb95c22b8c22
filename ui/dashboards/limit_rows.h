// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmark sets next to each other as charts and tables show them: the gates with the limit of each set, and
// how many would pass.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "assessment/scoring/benchmark.h"
#include "database/scoring/limit_trial.h"
#include "ui/dashboards/limits_chart.h"

namespace fulcrum::ui {

/// Metric, hand and tissue.
QString gate_name(const GateSpec& gate);
QString gate_name(const std::string& metric, const std::string& hand, const std::string& tissue);
/// What attempts are held against with this set: where it narrows an absolute limit, the narrower one.
std::optional<double> limit_in(const BenchmarkSet& set, const GateSpec& gate);
/// Of the attempts that were performed in the tissue of one of the sets, in the metric's unit.
std::vector<double> values_of(const std::vector<TriedAttempt>& attempts, const GateSpec& gate,
                              const std::vector<const BenchmarkSet*>& sets);
/// Gates on the experts' range, and absolute ones that one of the sets narrows.
std::vector<GateLimits> gate_limits(const TaskDefinition& task, const std::vector<const BenchmarkSet*>& sets,
                                    const std::vector<TriedAttempt>& attempts);
/// The provisional limits of the task that are the site's with this set, "Largest force · left hand: at most
/// 4 N; …"; empty: none.
QString taken_over_words(const TaskDefinition& task, const BenchmarkSet& set);
/// A sentence on those that a set of the site leaves provisional; empty: none, or the set is provisional.
QString left_provisional_words(const TaskDefinition& task, const BenchmarkSet& set);
/// "3 of 12 (25 %)".
QString share_of(int part, int all);
/// The cells of a set in the table of who would pass: the set, what it was made from, its experts, what of
/// their attempts pass, attempts and people that would pass.
QStringList pass_columns();
QStringList pass_cells(const QString& name, const BenchmarkSet& set, const TaskDefinition& task,
                       const std::vector<TriedAttempt>& attempts);

}  // namespace fulcrum::ui
