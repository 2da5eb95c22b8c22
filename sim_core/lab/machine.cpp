// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/machine.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace fulcrum::lab {

Machine this_machine(const BuildInfo& build) {
    Machine machine;
    machine.build = build;
    machine.cores = std::thread::hardware_concurrency();
    machine.processor = "unknown processor";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(':');
        if (line.rfind("model name", 0) != 0 || colon == std::string::npos || colon + 2 > line.size())
            continue;
        machine.processor = line.substr(colon + 2);
        break;
    }
    return machine;
}

std::string Machine::text() const {
    return processor + ", " + std::to_string(cores) + (cores == 1 ? " core; " : " cores; ") + build.compiler +
           ", " + build.flags;
}

nlohmann::json to_json(const Machine& machine) {
    return {{"processor", machine.processor},
            {"cores", machine.cores},
            {"compiler", machine.build.compiler},
            {"flags", machine.build.flags},
            {"commit", machine.build.commit}};
}

}  // namespace fulcrum::lab
