// SPDX-License-Identifier: Apache-2.0
// For any bytes read as a trace: either an InputError with file, place and hint, or a trace whose metrics are
// all finite.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/metrics/metrics_json.h"
#include "assessment/trace/trace_csv.h"
#include "assessment/trace/trace_mapping.h"
#include "sim_core/numerics/input_error.h"

namespace {

/// The same bytes read as another program's trace.
void read_as_mapped(const std::string& bytes) {
    using namespace fulcrum;
    static const TraceMapping by_name = parse_trace_mapping(
        R"({"title": "a", "missing": [""], "columns": {"t": {"column": "t", "unit": "ms"}, "left.px": {"column": "left.px", "unit": "mm"}}})",
        "a.json");
    static const TraceMapping by_number = parse_trace_mapping(
        R"({"title": "b", "separator": "spaces", "header_rows": 0, "rate_hz": 30, "columns": {"right.tissue": {"column": 2, "unit": "-"}, "right.px": {"column": 1, "unit": "m"}}})",
        "b.json");
    for (const TraceMapping* mapping : {&by_name, &by_number}) {
        std::istringstream in(bytes);
        try {
            const MappedTrace mapped = read_mapped_trace(in, "fuzz.txt", *mapping);
            if (mapped.trace.t.empty() || mapped.trace.t[0] < 0) std::abort();
        } catch (const InputError& error) {
            if (error.place().empty() || error.hint().empty()) std::abort();
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    read_as_mapped(bytes);
    std::istringstream in(bytes);
    Trace trace;
    try {
        trace = read_trace_csv(in, "fuzz.csv");
    } catch (const InputError& error) {
        if (error.place().empty() || error.hint().empty()) std::abort();
        return 0;
    }
    std::stringstream text;
    write_trace_csv(trace, text);
    if (read_trace_csv(text, "again.csv").t != trace.t) std::abort();
    // A few samples far apart in time still cover many grid points: keep each run short.
    if (trace.t.back() - trace.t.front() > 60.0) return 0;
    MetricContext context;
    context.tissues = {{"bowel", 3.0}};
    context.events_recorded = false;
    const auto results = compute_metrics(trace, {}, context);
    for (const MetricResult& result : results)
        if (result.value && !std::isfinite(*result.value)) std::abort();
    if (metrics_to_json(results).dump().empty()) std::abort();
    return 0;
}
