// SPDX-License-Identifier: GPL-3.0-or-later
// The processes of fulcrum-hapticd that a window has started.
#pragma once

#include <fcntl.h>
#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "sim_core/devices/device_page.h"

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

/// The page with the daemon's own readings and its report of the forces, as that process has it open.
inline SharedPage<StatePage> state_page_of(pid_t process) {
    std::error_code gone;
    const std::string folder = "/proc/" + std::to_string(process) + "/fd";
    for (const auto& entry : std::filesystem::directory_iterator(folder, gone)) {
        const std::string target = std::filesystem::read_symlink(entry.path(), gone).string();
        if (target.rfind("/memfd:fulcrum-device-state", 0) != 0) continue;
        const int page = open(entry.path().c_str(), O_RDONLY | O_CLOEXEC);
        if (page >= 0) return SharedPage<StatePage>::open(page, false);
    }
    return {};
}

}  // namespace fulcrum::app::program_test
