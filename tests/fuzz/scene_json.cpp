// SPDX-License-Identifier: Apache-2.0
// For any bytes, a scene is read or refused with an InputError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const fulcrum::Scene scene =
            fulcrum::parse_scene(std::string(reinterpret_cast<const char*>(data), size), "fuzz.json");
        if (scene.instruments.empty() || scene.tissues.empty()) __builtin_trap();
    } catch (const fulcrum::InputError& error) {
        if (error.place().empty() && size <= 1U << 20U) __builtin_trap();
    }
    return 0;
}
