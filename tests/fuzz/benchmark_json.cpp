// SPDX-License-Identifier: Apache-2.0
// For any bytes, a benchmark set is read with finite limits or refused with an InputError.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "assessment/scoring/benchmark.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const fulcrum::BenchmarkSet set =
            fulcrum::parse_benchmark(std::string(reinterpret_cast<const char*>(data), size), "fuzz.json");
        if (set.task.empty()) __builtin_trap();
    } catch (const fulcrum::InputError& error) {
        if (error.problem().empty() || error.hint().empty()) __builtin_trap();
    }
    return 0;
}
