// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/spacenavd_socket.h"

#include <cstdlib>
#include <fstream>

namespace fulcrum {

std::string spacenavd_socket(const std::string& configuration) {
    if (const char* const named = std::getenv("SPNAV_SOCKET"); named != nullptr && *named != '\0')
        return named;
    std::ifstream file(configuration);
    const std::string key = "socket";
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find_first_not_of(" \t"), equals = line.find('=');
        if (first == std::string::npos || equals == std::string::npos ||
            line.compare(first, key.size(), key) != 0)
            continue;
        const std::size_t begin = line.find_first_not_of(" \t", equals + 1);
        const std::size_t end = line.find_last_not_of(" \t\r");
        if (begin != std::string::npos && end >= begin) return line.substr(begin, end + 1 - begin);
    }
    return "/var/run/spnav.sock";
}

}  // namespace fulcrum
