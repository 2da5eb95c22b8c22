// SPDX-License-Identifier: Apache-2.0
// For any bytes read as events: either an InputError with file, place and hint, or events that are the same
// after they were written and read again, and that score a trace with finite metrics.
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "assessment/metrics/metric.h"
#include "assessment/trace/events_csv.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum;
    const std::vector<std::string> tissues = {"bowel", "vessel"};
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    std::vector<Event> events;
    try {
        events = read_events_csv(in, "fuzz.csv", tissues, 0.001);
    } catch (const InputError& error) {
        if (error.place().empty() || error.hint().empty()) std::abort();
        return 0;
    }
    std::stringstream text;
    write_events_csv(events, tissues, 0.001, text);
    const std::vector<Event> again = read_events_csv(text, "again.csv", tissues, 0.001);
    if (again.size() != events.size()) std::abort();
    for (std::size_t i = 0; i < events.size(); ++i)
        if (again[i].tick != events[i].tick || again[i].kind != events[i].kind ||
            again[i].hand != events[i].hand || again[i].tissue != events[i].tissue ||
            again[i].value != events[i].value || again[i].detail != events[i].detail)
            std::abort();
    Trace trace;
    trace.t = {0.0, 0.05, 0.1};
    trace.tissues = tissues;
    split_blocks(trace, events);
    for (const MetricResult& result : compute_metrics(trace, events, {}))
        if (result.value && !std::isfinite(*result.value)) std::abort();
    return 0;
}
