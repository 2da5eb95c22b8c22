// SPDX-License-Identifier: Apache-2.0
// For any bytes, a mapping of traces is read or refused with an InputError that says where and what to do;
// what was read maps columns that exist, by factors that are finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "assessment/trace/trace_mapping.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum;
    try {
        const TraceMapping mapping =
            parse_trace_mapping(std::string(reinterpret_cast<const char*>(data), size), "fuzz.json");
        if (mapping.columns.empty()) std::abort();
        for (const MappedColumn& column : mapping.columns)
            if (!std::isfinite(column.factor) || (column.column.empty() && column.number < 1)) std::abort();
        std::istringstream in("a b c\n1 2 3\n2 3 4\n");
        read_mapped_trace(in, "fuzz.txt", mapping);
    } catch (const InputError& error) {
        if (error.hint().empty()) std::abort();
    }
    return 0;
}
