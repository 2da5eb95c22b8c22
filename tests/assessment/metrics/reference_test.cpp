// SPDX-License-Identifier: Apache-2.0
// The table of docs/METRICS.md is what the registry holds. FULCRUM_WRITE_REFERENCES=1 writes it.
#include <gtest/gtest.h>

#include <string>

#include "assessment/metrics/registry.h"
#include "tests/support/generated.h"

namespace fulcrum {
namespace {

using test::in_cell;

const char* direction_text(Direction direction) {
    if (direction == Direction::context) return "context";
    return direction == Direction::lower ? "lower" : "higher";
}

/// "10 Hz" of a descriptor's whole sentence about the low-pass; what has none stays as it is.
std::string short_filter(const std::string& filter) {
    const std::size_t end = filter.find(" Hz, ends held");
    if (end == std::string::npos) return filter;
    const std::size_t begin = filter.rfind(' ', end - 1) + 1;
    return "low-pass " + filter.substr(begin, end - begin) + " Hz";
}

TEST(References, MetricsAreThoseOfTheRegistry) {
    std::string text =
        "| metric | name | unit | better | needs | filter | source | what it measures |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Metric& metric : metric_registry()) {
        const MetricDescriptor& d = metric.descriptor;
        const char* hands = d.hands == Hands::each    ? "each hand"
                            : d.hands == Hands::both  ? "both hands"
                            : d.hands == Hands::scope ? "the scope"
                                                      : "either hand";
        text += "| `" + d.id + "` (v" + std::to_string(d.version) + ") | " + in_cell(d.name) + " | " +
                in_cell(d.unit) + " | " + direction_text(d.direction) + (d.scale == Scale::ln ? ", ln" : "") +
                " | " + hands + (d.per_tissue ? ", per tissue" : "") + (d.needs_events ? ", events" : "") +
                " | " + in_cell(short_filter(d.filter)) + " | " + in_cell(d.source) + " | " +
                in_cell(d.explanation) + " |\n";
    }
    test::expect_generated("METRICS.md", "metrics", text);
}

}  // namespace
}  // namespace fulcrum
