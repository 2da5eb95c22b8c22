// SPDX-License-Identifier: Apache-2.0
// All metrics, in one list made in one file (registry.cpp): no static initialisers.
#pragma once

#include <string>
#include <vector>

#include "assessment/metrics/metric.h"

namespace fulcrum {

class Analysis;

/// A descriptor and its pure function, which appends one row a hand and tissue.
struct Metric {
    MetricDescriptor descriptor;
    void (*compute)(const MetricDescriptor& descriptor, const Analysis& analysis,
                    std::vector<MetricResult>& rows) = nullptr;
};

/// Checked on first use; families in the order motion, smoothness, force.
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

}  // namespace fulcrum
