// SPDX-License-Identifier: Apache-2.0
#include "assessment/assets/assets.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace fs = std::filesystem;

std::string assets_folder() {
    if (const char* named = std::getenv("FULCRUM_ASSETS"); named != nullptr && *named != '\0') {
        if (!fs::is_directory(fs::path(named) / "tasks"))
            throw InputError(named, "", QT_TRANSLATE_NOOP("errors", "contains no folder \"tasks\""),
                             QT_TRANSLATE_NOOP("errors", "set FULCRUM_ASSETS to the assets folder"));
        return named;
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        for (const fs::path& candidate : {folder / "assets", folder / "share" / "fulcrum" / "assets"}) {
            if (fs::is_directory(candidate / "tasks", error)) return candidate.string();
        }
        if (folder == folder.root_path()) break;
    }
    throw InputError(QT_TRANSLATE_NOOP("errors", "assets"), "",
                     QT_TRANSLATE_NOOP("errors", "the folder was not found next to the program or above it"),
                     QT_TRANSLATE_NOOP("errors", "set FULCRUM_ASSETS to the assets folder"));
}

std::string asset_path(const std::string& relative) {
    return (fs::path(assets_folder()) / relative).string();
}

namespace {

std::map<std::string, std::string> tasks_by_id() {
    std::map<std::string, std::string> tasks;
    for (const auto& entry : fs::directory_iterator(asset_path("tasks"))) {
        if (entry.path().extension() != ".json") continue;
        tasks[load_task(entry.path().string()).id] = entry.path().string();
    }
    return tasks;
}

}  // namespace

std::vector<std::string> task_ids() {
    std::vector<std::string> ids;
    for (const auto& [id, file] : tasks_by_id()) ids.push_back(id);
    return ids;
}

std::string task_file(const std::string& id) {
    const auto tasks = tasks_by_id();
    const auto found = tasks.find(id);
    if (found != tasks.end()) return found->second;
    std::string known;
    for (const auto& [other, file] : tasks) known += (known.empty() ? "" : ", ") + other;
    throw InputError(QT_TRANSLATE_NOOP("errors", "command line"), "task",
                     {QT_TRANSLATE_NOOP("errors", "no task '%1'"), id},
                     {QT_TRANSLATE_NOOP("errors", "name one of %1"), known});
}

}  // namespace fulcrum
