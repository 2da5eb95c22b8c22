// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/range_metrics.h"

#include <algorithm>

#include "assessment/attempt/engine.h"
#include "assessment/metrics/metrics_json.h"
#include "database/scoring/scoring.h"

namespace fulcrum {
namespace {

/// Those from the first to the last tick.
template <typename Record>
std::vector<Record> part_of_records(const std::vector<Record>& records, std::uint32_t first,
                                    std::uint32_t last) {
    const auto begin =
        std::lower_bound(records.begin(), records.end(), first,
                         [](const Record& one, std::uint32_t tick) { return one.tick < tick; });
    const auto end = std::upper_bound(begin, records.end(), last,
                                      [](std::uint32_t tick, const Record& one) { return tick < one.tick; });
    return {begin, end};
}

std::vector<TickSample> samples_between(const database::Trace& trace, std::uint32_t first,
                                        std::uint32_t last) {
    if (trace.ticks == nullptr) return part_of_records(trace.samples, first, last);
    std::vector<TickSample> samples;
    const std::unique_ptr<TickReader> reader = trace.ticks->reader();
    for (std::size_t i = reader->at_or_after(first); i < trace.ticks->size(); ++i) {
        const TickSample& sample = reader->sample(i);
        if (sample.tick > last) break;
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace

std::vector<MetricResult> metrics_of_range(const Scene& scene, const TaskDefinition& task, std::uint64_t seed,
                                           const database::Trace& trace, double from, double to) {
    const double period = scene.tick_period();
    const auto tick_of = [&](double t) {
        return static_cast<std::uint32_t>(std::max(0.0, t) / period + 0.5);
    };
    const auto samples = samples_between(trace, tick_of(from), tick_of(to));
    auto events = part_of_records(trace.events, tick_of(from), tick_of(to));
    // The time of a part runs from its beginning where the attempt's own runs already.
    const bool moved = std::any_of(trace.events.begin(), trace.events.end(), [&](const Event& event) {
        return event.kind == EventKind::first_movement && event.tick < tick_of(from);
    });
    if (moved && !samples.empty()) {
        Event begun;
        begun.kind = EventKind::first_movement;
        begun.tick = samples.front().tick;
        events.insert(events.begin(), begun);
    }
    const std::array<bool, hand_count> hands = {scene.instrument(Hand::left) != nullptr,
                                                scene.instrument(Hand::right) != nullptr};
    MetricContext context = make_metric_context(scene, task, targets_of(scene, task, seed));
    context.specimen.reset();
    context.metrics = task.metrics;
    return compute_metrics(trace_from_samples(samples, events, tissue_labels(scene), scene.tick_rate, hands),
                           events, context);
}

}  // namespace fulcrum
