// SPDX-License-Identifier: Apache-2.0
// Where the program's data files lie: FULCRUM_ASSETS, or assets/ beside the program or above it.
#pragma once

#include <string>
#include <vector>

namespace fulcrum {

/// Folder that holds scenes/, tasks/, benchmarks/. Throws InputError naming what was looked at.
std::string assets_folder();
/// Path of an asset, "tasks/a2.json".
std::string asset_path(const std::string& relative);
/// Ids of all tasks in assets/tasks, sorted.
std::vector<std::string> task_ids();
/// File of a task id ("B1"). Throws InputError listing the ids there are.
std::string task_file(const std::string& id);

}  // namespace fulcrum
