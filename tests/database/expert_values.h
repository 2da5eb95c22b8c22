// SPDX-License-Identifier: GPL-3.0-or-later
// Stored values of experts, from which a benchmark set is built: of every gate of a task, without a
// simulation.
#pragma once

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "database/rows/attempt_records.h"

namespace fulcrum::database::test {

/// Of every gate: a value at `z` of the delivered set, or one that an absolute gate lets pass.
inline void write_expert_values(const TaskDefinition& task, const BenchmarkSet& set, double z,
                                ScoreRow& score) {
    score.gates.clear();
    score.metrics.clear();
    for (const GateSpec& spec : task.gates) {
        const MetricDescriptor& about = *find_metric(spec.metric);
        const BenchmarkLevel* level = set.find(spec.metric, spec.hand, spec.tissue);
        double value = about.direction == Direction::higher ? spec.limit : 0;
        if (spec.kind == GateKind::benchmark && level != nullptr) value = limit_of(about, *level, z);
        MetricRow metric;
        metric.id = spec.metric;
        metric.version = about.version;
        metric.hand = spec.hand;
        metric.tissue = spec.tissue;
        metric.value = value;
        metric.unit = about.unit;
        metric.direction = about.direction;
        score.metrics.push_back(metric);
        GateRow gate;
        gate.metric = spec.metric;
        gate.hand = spec.hand;
        gate.tissue = spec.tissue;
        gate.kind = spec.kind;
        gate.value = value;
        gate.unit = about.unit;
        gate.passed = true;
        score.gates.push_back(gate);
    }
}

}  // namespace fulcrum::database::test
