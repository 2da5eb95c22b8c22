// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/judged_limits.h"

#include <cmath>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"

namespace fulcrum {
namespace {

void add_experts(JudgedLimit& limit, const BenchmarkLevel& level) {
    if (level.absolute_limit) return;
    const auto value = [&](double x) { return level.scale == Scale::ln ? std::exp(x) : x; };
    limit.experts_low = value(level.mean - level.deviation);
    limit.experts_high = value(level.mean + level.deviation);
}

}  // namespace

std::vector<JudgedLimit> judged_limits(const TaskDefinition& task, const BenchmarkSet* benchmark,
                                       const Statement& why_none) {
    std::vector<JudgedLimit> limits;
    for (const GateSpec& spec : task.gates) {
        const GateResult gate = judge_gate(spec, {}, benchmark);
        JudgedLimit limit;
        limit.metric = spec.metric;
        limit.hand = spec.hand;
        limit.tissue = spec.tissue;
        limit.unit = gate.unit;
        limit.exclusive = spec.exclusive;
        limit.limit = gate.limit;
        limit.limit_source = gate.limit_source;
        limit.provisional = gate.provisional;
        if (!gate.limit)
            limit.absent_because = benchmark == nullptr && !why_none.empty() ? why_none : gate.absent_because;
        const MetricDescriptor* metric = find_metric(spec.metric);
        limit.higher_is_better = metric != nullptr && metric->direction == Direction::higher;
        const BenchmarkLevel* level =
            benchmark == nullptr ? nullptr : benchmark->find(spec.metric, spec.hand, spec.tissue);
        limit.of_set = level != nullptr;
        if (spec.kind == GateKind::absolute) limit.task_limit = spec.limit;
        if (level != nullptr) add_experts(limit, *level);
        limits.push_back(std::move(limit));
    }
    return limits;
}

}  // namespace fulcrum
