// SPDX-License-Identifier: Apache-2.0
// For any bytes, a task is read or refused with an InputError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const fulcrum::TaskDefinition task =
            fulcrum::parse_task(std::string(reinterpret_cast<const char*>(data), size), "fuzz.json");
        if (task.goals.empty() || task.id.empty()) __builtin_trap();
    } catch (const fulcrum::InputError& error) {
        if (error.place().empty() && size <= 1U << 20U) __builtin_trap();
    }
    return 0;
}
