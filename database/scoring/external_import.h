// SPDX-License-Identifier: GPL-3.0-or-later
// From a trace that was recorded elsewhere to an external attempt: the one path for window and command line.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "assessment/trace/trace.h"
#include "database/records/external_attempts.h"

namespace fulcrum {

/// How one column was understood.
struct ReadColumn {
    std::string ours, unit;          ///< "left.px", "m"
    std::string theirs, their_unit;  ///< name or number in the file; where it has our format, the same
};

/// A trace that was read and measured, and what was understood of it.
struct ExternalTrace {
    std::string source;               ///< title of the mapping; empty: the file has our format
    std::vector<ReadColumn> columns;  ///< without the time
    Trace trace;
    std::string text;  ///< the trace in our format
    std::vector<database::AssetFile> files;
    nlohmann::json document;   ///< what `fulcrum metrics` prints, and samples_left_out
    std::size_t left_out = 0;  ///< samples
    std::size_t measured = 0;  ///< metrics that have a value
    double rate_hz = 0;        ///< mean within stretches without a gap
};

/// Thrown where `progress` returned false.
class ReadingStopped : public std::runtime_error {
  public:
    ReadingStopped() : std::runtime_error("stopped") {}
};

/// Reads and measures; `mapping` empty: the file has our format. `progress`: share that is done; false stops.
/// Throws InputError with the row of the file, ReadingStopped.
ExternalTrace read_external_trace(const std::string& path, const std::string& mapping,
                                  const std::function<bool(double)>& progress = {});

/// As an attempt, still without person, exercise and time.
database::ExternalAttempt external_attempt(const ExternalTrace& read);

/// Mapping files that the program is delivered with, with their titles, in the order of these.
struct DeliveredMapping {
    std::string path, title;
};
std::vector<DeliveredMapping> delivered_mappings();

}  // namespace fulcrum
