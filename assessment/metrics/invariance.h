// SPDX-License-Identifier: Apache-2.0
// What a metric makes of the same attempt recorded otherwise: in a turned, mirrored or moved frame, with a
// clock that starts elsewhere, at half the rate, with noise, with a faulty sample.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/trace/trace.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {

enum class TraceChange : std::uint8_t { turned, mirrored, moved, later, half_rate, noise, spike };
inline constexpr NameRow<TraceChange> trace_changes[] = {
    {TraceChange::turned, "turned", "turned by 40 degrees about an oblique axis"},
    {TraceChange::mirrored, "mirrored", "mirrored left to right"},
    {TraceChange::moved, "moved", "moved by 5 cm"},
    {TraceChange::later, "later", "begun 0.25 s later"},
    {TraceChange::half_rate, "half_rate", "every second sample only (500 a second)"},
    {TraceChange::noise, "noise", "2 um of noise in each coordinate of the tips"},
    {TraceChange::spike, "spike", "one sample of 20 N in each hand"}};
static_assert(in_order(trace_changes));

/// How far a change may move a metric: what the page of the laboratory prints and its test holds.
struct AllowedChange {
    TraceChange change;
    std::vector<std::string> metrics;  ///< ids; empty: all that no other row of this change names
    double most;                       ///< as MetricChange::relative; infinite: not comparable
    const char* why;
};
/// Every change has a row for all other metrics; it is the last of the change.
const std::vector<AllowedChange>& allowed_changes();
/// The row that a metric falls under.
const AllowedChange& allowed_change(TraceChange change, const std::string& metric);

/// The record of an attempt, and the task and scene data that its metrics need.
struct RecordedAttempt {
    Trace trace;
    std::vector<Event> events;
    MetricContext context;
};

/// The same attempt, recorded otherwise. Deterministic.
RecordedAttempt changed(RecordedAttempt attempt, TraceChange change);

/// A row of metrics under all changes.
struct MetricChange {
    std::string id, hand, tissue;
    double value = 0;  ///< as recorded
    /// |change| over the value, or over the metric's precision where that is larger, by TraceChange; infinite
    /// where the metric is absent.
    std::vector<double> relative;
};
/// Every row that has a value and every change.
std::vector<MetricChange> compare_changes(const RecordedAttempt& attempt);

}  // namespace fulcrum
