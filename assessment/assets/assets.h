// SPDX-License-Identifier: Apache-2.0
// Finds the program's data files: in FULCRUM_ASSETS, or in assets/ next to the program or above it.
#pragma once

#include <string>
#include <vector>

namespace fulcrum {

/// Folder that contains scenes/, tasks/, benchmarks/. Throws InputError naming the folders searched.
std::string assets_folder();
/// Path of an asset, "tasks/a2.json".
std::string asset_path(const std::string& relative);
/// Ids of all tasks in assets/tasks, sorted.
std::vector<std::string> task_ids();
/// File of a task id ("B1"). Throws InputError listing the known ids.
std::string task_file(const std::string& id);

}  // namespace fulcrum
