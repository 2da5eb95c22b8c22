// SPDX-License-Identifier: Apache-2.0
// What a curriculum can know of an installed task.
#pragma once

#include <string>
#include <vector>

#include "assessment/task/task.h"

namespace fulcrum {

struct InstalledTask {
    std::string id;
    std::vector<std::string> variants = {};  ///< ids, the standard one first
    std::vector<std::string> goals = {};     ///< ids, in order
    std::vector<std::string> metrics = {};   ///< ids of those that it shows
    bool has_hands = true;                   ///< false: the scope alone, which has no ghost
    bool needs_limits = false;               ///< a gate is based on the experts' range
    std::vector<DeviceClass> with_limits =
        {};  ///< classes that a benchmark set with experts is installed for
};

/// All but with_limits.
InstalledTask installed_task(const TaskDefinition& task);
/// Null where it is not among them.
const InstalledTask* find_installed(const std::vector<InstalledTask>& tasks, const std::string& id);

}  // namespace fulcrum
