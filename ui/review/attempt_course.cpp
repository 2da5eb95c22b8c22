// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/attempt_course.h"

#include <algorithm>

#include "assessment/trace/cut_strokes.h"

namespace fulcrum::ui {
namespace {

constexpr double longest_hold_s = 0.1;  // of a sample: a longer way to the next one is a gap of the record
constexpr double touching_s = 1e-6;

}  // namespace

TractionCourse traction_course(const std::vector<Event>& events, double tick_period, double end) {
    TractionCourse course;
    for (const CutStroke& stroke : cut_strokes(events, tick_period, end))
        for (const CutElement& element : stroke.elements)
            if (element.traction) course.steps.push_back({element.begin, element.end, *element.traction});
    // Both hands may cut at once; fibres may part while a blade is in tissue.
    std::stable_sort(course.steps.begin(), course.steps.end(),
                     [](const ChartStep& a, const ChartStep& b) { return a.to < b.to; });
    if (!course.steps.empty()) return course;
    course.per_length = false;
    for (const Event& event : events) {
        if (event.kind != EventKind::band_divided) continue;
        const double time = event.tick * tick_period;
        course.steps.push_back({time, time, static_cast<double>(event.value)});
    }
    return course;
}

std::shared_ptr<const MinMaxPyramid> heat_course(const std::vector<Event>& events, double tick_period,
                                                 double end) {
    std::vector<double> time{0};
    std::vector<float> area{0};
    for (const Event& event : events) {
        if (event.kind != EventKind::heat_area) continue;
        const float before = area.back();
        for (const float value : {before, std::max(before, event.value)}) {
            time.push_back(event.tick * tick_period);
            area.push_back(value);
        }
    }
    if (time.size() == 1) return nullptr;
    time.push_back(std::max(end, time.back()));
    area.push_back(area.back());
    return std::make_shared<const MinMaxPyramid>(std::move(time), std::move(area));
}

std::vector<TraceBlock> joined_samples(const std::vector<double>& time, const std::vector<Event>& events,
                                       double tick_period) {
    Trace record;
    record.t = time;
    record.tick_period = tick_period;
    split_blocks(record, events);
    if (record.blocks.empty()) return {};
    TraceBlock& last = record.blocks.back();
    while (last.last < time.size() && time[last.last] > record.end &&
           time[last.last] - time[last.last - 1] <= longest_hold_s + touching_s)
        ++last.last;
    return std::move(record.blocks);
}

std::vector<ChartSpan> spans_of_flag(const std::vector<double>& time, const std::vector<std::uint32_t>& flags,
                                     std::uint32_t flag, double tick_period) {
    std::vector<ChartSpan> spans;
    for (std::size_t i = 0; i < std::min(time.size(), flags.size()); ++i) {
        if ((flags[i] & flag) == 0) continue;
        const bool followed = i + 1 < time.size() && time[i + 1] - time[i] <= longest_hold_s + touching_s;
        append_spans(spans, {{time[i], followed ? time[i + 1] : time[i] + tick_period}});
    }
    return spans;
}

void append_spans(std::vector<ChartSpan>& all, const std::vector<ChartSpan>& later) {
    for (const ChartSpan& span : later) {
        if (!all.empty() && span.from - all.back().to < touching_s)
            all.back().to = std::max(all.back().to, span.to);
        else
            all.push_back(span);
    }
}

std::vector<ChartSpan> without_pauses(const std::vector<ChartSpan>& spans, const std::vector<Event>& events,
                                      double tick_period, double end) {
    Trace times;
    times.t = {end};
    times.tick_period = tick_period;
    split_blocks(times, events);
    std::vector<ChartSpan> kept;
    for (ChartSpan span : spans) {
        for (const TimeInterval& pause : times.pauses) {
            const double begin =
                pause.begin + tick_period;  // the sample of the tick that it begins in counts
            if (pause.end <= span.from || begin >= std::min(span.to, pause.end)) continue;
            if (span.from < begin) kept.push_back({span.from, begin});
            span.from = pause.end;
        }
        if (span.from < span.to) kept.push_back(span);
    }
    return kept;
}

}  // namespace fulcrum::ui
