// SPDX-License-Identifier: GPL-3.0-or-later
// What a record says of traction, energy and heat over the time of an attempt, as charts draw it. Values that
// the record does not hold are not made up. Pure; any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assessment/trace/trace.h"
#include "sim_core/telemetry/event.h"
#include "ui/charts/decimation.h"
#include "ui/charts/time_chart.h"

namespace fulcrum::ui {

/// The tension of the tissue while it was divided.
struct TractionCourse {
    bool per_length = true;        ///< N/m, across a cut along a line; else N, of a band as it was divided
    std::vector<ChartStep> steps;  ///< empty: the record says nothing of it
};
/// `end`: of the record, s.
TractionCourse traction_course(const std::vector<Event>& events, double tick_period, double end);

/// mm2 of tissue that heat has reached and was not meant for; null without an event of it.
std::shared_ptr<const MinMaxPyramid> heat_course(const std::vector<Event>& events, double tick_period,
                                                 double end);

/// The samples (taken at `time`, s) that a line may join, as the metrics measure across them: none across a
/// gap of the record, a pause or lost samples. What was recorded during a pause is in no block; what follows
/// the end of the attempt belongs to the last one.
std::vector<TraceBlock> joined_samples(const std::vector<double>& time, const std::vector<Event>& events,
                                       double tick_period);

/// When a flag was set, from samples in order: a sample holds until the next one, the last one before a gap
/// of the record, or of the part, for one period. The metric energy_time counts the same.
std::vector<ChartSpan> spans_of_flag(const std::vector<double>& time, const std::vector<std::uint32_t>& flags,
                                     std::uint32_t flag, double tick_period);
/// Those of the next part of the record; one that continues at the border stays one.
void append_spans(std::vector<ChartSpan>& all, const std::vector<ChartSpan>& later);
/// Without what falls into a pause or the loss of a device: the record holds its last sample there, and the
/// metric leaves it out. `end`: of the record, s.
std::vector<ChartSpan> without_pauses(const std::vector<ChartSpan>& spans, const std::vector<Event>& events,
                                      double tick_period, double end);

}  // namespace fulcrum::ui
