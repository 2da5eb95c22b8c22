// SPDX-License-Identifier: GPL-3.0-or-later
// The processes of fulcrum-hapticd that a window has started.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fulcrum::app::program_test {

/// A process of the daemon whose parent is `parent`: of a window its overseer, of an overseer the device
/// process; 0: none.
inline pid_t daemon_child_of(pid_t parent) {
    std::error_code gone;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", gone)) {
        std::ifstream stat(entry.path() / "stat");
        pid_t pid = 0, its_parent = 0;
        std::string name, state;
        if (stat >> pid >> name >> state >> its_parent && its_parent == parent && state != "Z" &&
            name.rfind("(fulcrum-haptic", 0) == 0)
            return pid;
    }
    return 0;
}

}  // namespace fulcrum::app::program_test
