// SPDX-License-Identifier: Apache-2.0
#include "tests/support/support.h"

#include <algorithm>
#include <filesystem>

namespace fulcrum::test {

std::string source_path(const std::string& relative) {
    return std::string(FULCRUM_SOURCE_DIR) + "/" + relative;
}

std::vector<std::string> task_ids() {
    std::vector<std::string> ids;
    for (const auto& entry : std::filesystem::directory_iterator(source_path("assets/tasks")))
        if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace fulcrum::test
