// SPDX-License-Identifier: Apache-2.0
// Traces that other programs recorded (box trainers, robots, other simulators): a mapping file says which of
// their columns is which of ours and in which unit. docs/FORMATS.md, Traces from elsewhere; examples in
// assets/mappings.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "assessment/trace/trace.h"

namespace fulcrum {

/// One of our columns and where it is in the file.
struct MappedColumn {
    std::string name;    ///< "left.px", as in the documented format
    std::string column;  ///< its name in the file; empty: by number
    int number = 0;      ///< from 1; 0: by name
    double factor = 1;   ///< from the file's unit and sense to ours
    std::string unit{};  ///< of the file
};

struct TraceMapping {
    std::string title;                  ///< of the format
    bool transforms = false;            ///< a recording of poses (transform_log.h) instead of a table
    char separator = ',';               ///< ' ': one or more spaces or tabs
    int header_rows = 1;                ///< rows before the first sample; the last of them names the columns
    std::optional<double> rate;         ///< Hz, where the file has no time: sample i is at i / rate
    std::vector<std::string> missing;   ///< cells that mean "no value": the sample is left out
    std::vector<MappedColumn> columns;  ///< by our name
};

/// Throws InputError: not valid by the schema, unknown column or unit, no time and no rate or both, a header
/// row too few for a column by name.
TraceMapping parse_trace_mapping(const std::string& text, const std::string& file);
TraceMapping load_trace_mapping(const std::string& path);

struct MappedTrace {
    Trace trace;
    std::size_t left_out = 0;  ///< samples with a missing value, or without a pose of each device
};
/// Reads a trace as read_trace_csv does, with the same limits. Time begins at 0: the first sample's time is
/// taken off. A stretch without samples splits it into blocks. Throws InputError with the row of the file.
MappedTrace read_mapped_trace(std::istream& in, const std::string& file, const TraceMapping& mapping);
MappedTrace read_mapped_trace(const std::string& path, const TraceMapping& mapping);

}  // namespace fulcrum
