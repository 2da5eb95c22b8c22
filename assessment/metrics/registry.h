// SPDX-License-Identifier: Apache-2.0
// All metrics, in one list made in one file (registry.cpp): no static initialisers.
#pragma once

#include <string>
#include <vector>

#include "assessment/metrics/metric.h"

namespace fulcrum {

class Analysis;

/// Result of a metric's function: a value, or the reason why there is none.
struct Figure {
    std::optional<double> value;
    Absence absence = Absence::none;
    Statement because;
    std::vector<TimeInterval> evidence;
    std::optional<int> count;
};
Figure absent(Absence absence, Statement because);
Figure value_of(double value, std::vector<TimeInterval> evidence = {});

/// Which row: hand 0 or 1, -1 where a metric has none; tissue an index into Analysis::tissues(), -1 all
/// together.
struct Selection {
    int hand = -1;
    int tissue = -1;
};

/// A descriptor and its pure function of the analysed record. The channels and rate that the descriptor
/// requires are present.
struct Metric {
    MetricDescriptor descriptor;
    Figure (*compute)(const Analysis& analysis, const Selection& row) = nullptr;
};

/// Checked on first use; families in the order motion, smoothness, force, cutting, energy, specimen, camera.
const std::vector<Metric>& metric_registry();
/// Null when unknown.
const MetricDescriptor* find_metric(const std::string& id);
/// Throws std::logic_error naming the metric: duplicate id, empty field, unknown or circular dependency, ln
/// where 0 is possible.
void check_registry(const std::vector<Metric>& metrics);

/// The families, each in a file of its own.
std::vector<Metric> motion_metrics();
std::vector<Metric> coordination_metrics();
std::vector<Metric> smoothness_metrics();
std::vector<Metric> force_metrics();
std::vector<Metric> grasp_metrics();
std::vector<Metric> cutting_metrics();
std::vector<Metric> energy_metrics();
std::vector<Metric> specimen_metrics();
std::vector<Metric> camera_metrics();

}  // namespace fulcrum
