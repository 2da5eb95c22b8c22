// SPDX-License-Identifier: Apache-2.0
// Events CSV (docs/FORMATS.md): the events of an attempt as a table; the trace is a file of its own.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_core/telemetry/event.h"

namespace fulcrum {

inline constexpr std::size_t events_csv_row_limit = 1'000'000;

/// In an events file the begin of an attempt carries its seed, which places the targets; a seed that does not
/// fit there stays 0. Other events stay as they are.
void put_seed(Event& event, std::uint64_t seed);

/// One row an event. `tissues`: the scene's labels that Event::tissue points into; `tick_period` in s.
void write_events_csv(std::vector<Event> events, const std::vector<std::string>& tissues, double tick_period,
                      std::ostream& out);

/// The reverse. Throws InputError `FILE:ROW: COLUMN: what is wrong; what to do` for an unknown event, hand or
/// tissue, a time that falls, and numbers that are none.
std::vector<Event> read_events_csv(std::istream& in, const std::string& file,
                                   const std::vector<std::string>& tissues, double tick_period);
std::vector<Event> read_events_csv(const std::string& path, const std::vector<std::string>& tissues,
                                   double tick_period);

}  // namespace fulcrum
