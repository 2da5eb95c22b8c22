// SPDX-License-Identifier: Apache-2.0
// A small task, a benchmark set for it, and attempts with given figures.
#pragma once

#include <string>
#include <vector>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/scoring/benchmark_builder.h"

namespace fulcrum::test {

inline MetricResult figure(const std::string& id, const std::string& hand, double value,
                           const std::string& tissue = "") {
    const MetricDescriptor& d = *find_metric(id);
    MetricResult result;
    result.id = id;
    result.version = d.version;
    result.hand = hand;
    result.tissue = tissue;
    result.value = value;
    result.unit = d.unit;
    result.direction = d.direction;
    result.evidence = {{10.0, 11.0}};
    return result;
}

inline MetricResult missing(const std::string& id, const std::string& hand, Absence absence) {
    MetricResult result = figure(id, hand, 0);
    result.value.reset();
    result.evidence.clear();
    result.absence = absence;
    result.absent_because = absence == Absence::not_done ? Statement(StatementId::nothing_grasped)
                                                         : Statement(StatementId::not_recorded,
                                                                     {{"channels", std::string("left.fx")}});
    return result;
}

/// Gates: time and sparc (benchmark), f_max left at most 4 N, drop at most 1 (absolute).
inline TaskDefinition small_task() {
    TaskDefinition task;
    task.id = "T1";
    Goal first, second;
    first.text = "Find the start";
    second.text = "Run the bowel";
    task.goals = {first, second};
    task.metrics = {"time", "sparc", "f_max", "drop"};
    task.gates = {{"time", "", "", GateKind::benchmark, 0, ""},
                  {"sparc", "right", "", GateKind::benchmark, 0, ""},
                  {"f_max", "left", "", GateKind::absolute, 4.0, "training limit", true},
                  {"drop", "", "", GateKind::absolute, 1.0, "not provisional: any drop is one too many"}};
    task.critical_errors = {"perforation"};
    return task;
}

/// Experts: ln time 4.0 +- 0.2, sparc -1.5 +- 0.1; novices at z = 4 in both. k = 2.
inline BenchmarkSet small_set() {
    BenchmarkSet set;
    set.task = "T1";
    set.variant_family = "standard";
    set.device_class = DeviceClass::haptic;
    set.fidelity = "standard";
    set.source = "synthetic operators";
    set.k = 2.0;
    set.expert_pass_share = 0.95;
    for (int i = 0; i < 8; ++i) set.experts.push_back({"expert " + std::to_string(i), 3, 3});
    BenchmarkLevel time;
    time.metric = "time";
    time.unit = "s";
    time.scale = Scale::ln;
    time.mean = 4.0;
    time.deviation = 0.2;
    time.z_novice = 4.0;
    time.experts = 8;
    BenchmarkLevel sparc = time;
    sparc.metric = "sparc";
    sparc.hand = "right";
    sparc.unit = "-";
    sparc.scale = Scale::raw;
    sparc.mean = -1.5;
    sparc.deviation = 0.1;
    for (BenchmarkLevel* level : {&time, &sparc}) level->metric_version = find_metric(level->metric)->version;
    set.levels = {time, sparc};
    return set;
}

/// The same from people, as version 4, with what it took over of small_task().
inline BenchmarkSet small_site_set() {
    BenchmarkSet set = small_set();
    set.version = 4;
    set.source = "experts of this site";
    set.provisional = false;
    set.taken_over = limits_to_take_over(small_task());
    return set;
}

inline std::vector<MetricResult> figures(double time, double sparc, double force, double drops) {
    return {figure("time", "", time), figure("sparc", "right", sparc), figure("f_max", "left", force),
            figure("drop", "", drops)};
}

}  // namespace fulcrum::test
