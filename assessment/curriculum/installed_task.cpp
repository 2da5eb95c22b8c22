// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/installed_task.h"

#include <algorithm>

namespace fulcrum {

InstalledTask installed_task(const TaskDefinition& task) {
    InstalledTask one;
    one.id = task.id;
    for (const TaskVariant& variant : task.variants) one.variants.push_back(variant.id);
    for (const Goal& goal : task.goals) one.goals.push_back(goal.id);
    one.metrics = task.metrics;
    one.has_hands = task.goals.empty() || type_of(task.goals.front().kind).site != GoalSite::camera_targets;
    one.needs_limits = std::any_of(task.gates.begin(), task.gates.end(),
                                   [](const GateSpec& gate) { return gate.kind == GateKind::benchmark; });
    return one;
}

const InstalledTask* find_installed(const std::vector<InstalledTask>& tasks, const std::string& id) {
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const InstalledTask& one) { return one.id == id; });
    return found == tasks.end() ? nullptr : &*found;
}

}  // namespace fulcrum
