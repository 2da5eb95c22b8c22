// SPDX-License-Identifier: Apache-2.0
// The one place where metrics are registered.
#include "assessment/metrics/registry.h"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

namespace fulcrum {

namespace {

void append(std::vector<Metric>& all, std::vector<Metric> family) {
    for (Metric& metric : family) all.push_back(std::move(metric));
}

std::vector<Metric> make_registry() {
    std::vector<Metric> all;
    append(all, motion_metrics());
    append(all, coordination_metrics());
    append(all, smoothness_metrics());
    append(all, force_metrics());
    append(all, grasp_metrics());
    append(all, cutting_metrics());
    append(all, energy_metrics());
    append(all, specimen_metrics());
    append(all, camera_metrics());
    check_registry(all);
    return all;
}

void check_filled(const Metric& metric) {
    const MetricDescriptor& d = metric.descriptor;
    const auto refuse = [&](const char* what) { throw std::logic_error("metric '" + d.id + "': " + what); };
    if (d.id.empty() || d.name.empty() || d.unit.empty()) refuse("id, name or unit is empty");
    if (!(d.precision > 0)) refuse("precision is not positive");
    if (d.version < 1) refuse("version is not set");
    if (d.source.empty() || d.filter.empty() || d.explanation.empty())
        refuse("source, filter or explanation is empty");
    if (d.advice_fault.find("{value}") == std::string::npos || d.advice_remedy.empty())
        refuse("the advice does not name the value or a remedy");
    if (d.direction != Direction::context && d.advice_fault.find("{limit}") == std::string::npos)
        refuse("the advice does not name the limit");
    if (d.channels.empty() && !d.needs_events) refuse("it names neither channels nor events");
    if (d.scale == Scale::ln && (d.aggregation == Aggregation::count || d.aggregation == Aggregation::share ||
                                 d.aggregation == Aggregation::grade))
        refuse("a count or share can be 0 and takes no logarithm");
    if (metric.compute == nullptr) refuse("it has no function");
}

}  // namespace

void check_registry(const std::vector<Metric>& metrics) {
    std::map<std::string, const Metric*> by_id;
    for (const Metric& metric : metrics) {
        check_filled(metric);
        if (!by_id.emplace(metric.descriptor.id, &metric).second)
            throw std::logic_error("metric '" + metric.descriptor.id + "': registered twice");
    }
    enum class Mark { open, done };
    std::map<std::string, Mark> marks;
    const std::function<void(const Metric&)> visit = [&](const Metric& metric) {
        const std::string& id = metric.descriptor.id;
        const auto mark = marks.find(id);
        if (mark != marks.end()) {
            if (mark->second == Mark::open)
                throw std::logic_error("metric '" + id + "': it depends on itself");
            return;
        }
        marks[id] = Mark::open;
        for (const std::string& other : metric.descriptor.dependencies) {
            const auto found = by_id.find(other);
            if (found == by_id.end())
                throw std::logic_error("metric '" + id + "': depends on unknown '" + other + "'");
            visit(*found->second);
        }
        marks[id] = Mark::done;
    };
    for (const Metric& metric : metrics) visit(metric);
}

const std::vector<Metric>& metric_registry() {
    static const std::vector<Metric> registry = make_registry();
    return registry;
}

const MetricDescriptor* find_metric(const std::string& id) {
    for (const Metric& metric : metric_registry())
        if (metric.descriptor.id == id) return &metric.descriptor;
    return nullptr;
}

}  // namespace fulcrum
