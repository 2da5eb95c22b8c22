// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/fidelity_now.h"

#include "assessment/metrics/registry.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"

namespace fulcrum {

std::map<std::string, int> gated_metric_versions(const TaskDefinition& task) {
    std::map<std::string, int> versions;
    for (const GateSpec& gate : task.gates)
        if (const MetricDescriptor* metric = find_metric(gate.metric))
            versions[gate.metric] = metric->version;
    return versions;
}

bool measured_with_this_program(const TaskFidelityCost& cost) {
    if (!cost.of_this_physics() || cost.metrics.empty()) return false;
    for (const auto& [id, version] : cost.metrics) {
        const MetricDescriptor* metric = find_metric(id);
        if (metric == nullptr || metric->version != version) return false;
    }
    return true;
}

bool measured_as_now(const TaskFidelityCost& cost, const std::string& task) {
    if (!measured_with_this_program(cost)) return false;
    const LoadedTask loaded = load_task_and_scene(task);
    return cost.metrics == gated_metric_versions(loaded.task) &&
           cost.limits == limits_for(loaded.task, loaded.scene, DeviceClass::synthetic).name();
}

}  // namespace fulcrum
