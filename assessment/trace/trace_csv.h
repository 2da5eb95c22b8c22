// SPDX-License-Identifier: Apache-2.0
// The documented trace format (docs/FORMATS.md): a row of names, a row of units, then one row a sample.
#pragma once

#include <iosfwd>
#include <string>

#include "assessment/trace/trace.h"

namespace fulcrum {

/// Limits of a trace file; above them the reader reports an error instead of filling the memory.
inline constexpr std::size_t trace_csv_row_limit = 8'000'000;
inline constexpr std::size_t trace_csv_column_limit = 256;
inline constexpr std::size_t trace_csv_line_limit = 65536;  ///< bytes
inline constexpr std::size_t trace_csv_tissue_limit = 120;  ///< different labels
inline constexpr double trace_csv_time_limit = 7200;        ///< s

/// Reads a trace; blocks are split at gaps. `file` names the source in errors. Throws InputError with place
/// "ROW: COLUMN", the row counted from 1 with the header as row 1.
Trace read_trace_csv(std::istream& in, const std::string& file);
Trace read_trace_csv(const std::string& path);

/// Writes the channels that exist, numbers so that reading them back gives the same doubles.
void write_trace_csv(const Trace& trace, std::ostream& out);

}  // namespace fulcrum
