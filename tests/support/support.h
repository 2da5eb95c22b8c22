// SPDX-License-Identifier: Apache-2.0
// Where tests find the repository's files.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::test {

/// Absolute path of a file in the repository.
std::string source_path(const std::string& relative);
/// Ids of the tasks in assets/tasks, in the alphabet's order: a test that walks them meets every new one.
std::vector<std::string> task_ids();

}  // namespace fulcrum::test
