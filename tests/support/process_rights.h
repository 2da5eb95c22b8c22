// SPDX-License-Identifier: Apache-2.0
// What another process may still do and what it has loaded, as the system reports it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fulcrum::test {

/// Every thread of it: no new privileges, and a filter of system calls. False where it has ended.
inline bool is_filtered(pid_t process) {
    int threads = 0;
    std::error_code gone;
    for (const auto& thread :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", gone)) {
        std::ifstream status(thread.path() / "status");
        std::string line;
        int held = 0;
        while (std::getline(status, line)) {
            if (line.rfind("NoNewPrivs:", 0) == 0 && line.back() == '1') ++held;
            if (line.rfind("Seccomp:", 0) == 0 && line.back() == '2') ++held;
        }
        if (held != 2) return false;
        ++threads;
    }
    return threads > 0;
}

/// It has this file in its memory, such as a library: by a part of its path.
inline bool has_mapped(pid_t process, const std::string& file) {
    std::ifstream maps("/proc/" + std::to_string(process) + "/maps");
    std::string line;
    while (std::getline(maps, line))
        if (line.find(file) != std::string::npos) return true;
    return false;
}

}  // namespace fulcrum::test
