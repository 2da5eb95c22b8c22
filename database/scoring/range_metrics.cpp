// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/range_metrics.h"

#include <algorithm>
#include <array>
#include <map>

#include "assessment/attempt/engine.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/registry.h"
#include "database/scoring/scoring.h"

namespace fulcrum {
namespace {

/// Above this many samples (a quarter of an hour) the metrics are computed hand by hand, from the columns
/// that they need: a whole hour at once takes 1.7 GB. Below, all at once takes less, and a third of the time.
constexpr std::size_t most_at_once = 900000;

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

/// Samples of a part of a record, wherever they are; read as often as wanted, a chunk at a time.
class PartOfTicks {
  public:
    PartOfTicks(const database::Trace& trace, std::uint32_t first, std::uint32_t last) : trace_(trace) {
        const auto index = [&](std::uint32_t tick) {
            if (trace.ticks != nullptr) return trace.ticks->reader()->at_or_after(tick);
            const auto found =
                std::lower_bound(trace.samples.begin(), trace.samples.end(), tick,
                                 [](const TickSample& one, std::uint32_t t) { return one.tick < t; });
            return static_cast<std::size_t>(found - trace.samples.begin());
        };
        first_ = index(first);
        last_ = std::max(first_, index(last + 1));
        if (size() > 0)
            each(first_, first_ + 1, [&](const TickSample& sample) { first_tick_ = sample.tick; });
    }
    std::size_t size() const { return last_ - first_; }
    std::uint32_t first_tick() const { return first_tick_; }
    template <typename Visit>
    void each(Visit visit) const {
        each(first_, last_, visit);
    }

  private:
    template <typename Visit>
    void each(std::size_t first, std::size_t last, Visit visit) const {
        if (trace_.ticks == nullptr) {
            for (std::size_t i = first; i < last; ++i) visit(trace_.samples[i]);
            return;
        }
        const std::unique_ptr<TickReader> reader = trace_.ticks->reader();
        for (std::size_t i = first; i < last; ++i) visit(reader->sample(i));
    }
    const database::Trace& trace_;
    std::size_t first_ = 0, last_ = 0;
    std::uint32_t first_tick_ = 0;
};

constexpr ChannelSet force_channels =
    bit_of(Channel::force) | bit_of(Channel::jaw_force) | bit_of(Channel::jaw_area);

/// What a metric reads, with what its rows and movements depend on: which movements are free of contact is of
/// interest to metrics of a hand's movements alone. RangeMetrics tests that nothing is missing for any
/// metric.
ChannelSet channels_of(const MetricDescriptor& metric) {
    ChannelSet channels = bit_of(Channel::tissue);  // which tissues have a row
    for (const Channel channel : metric.channels)
        if (channel != Channel::scope) channels |= bit_of(channel);
    if ((channels & bit_of(Channel::position)) == 0) return channels;
    channels |= bit_of(Channel::inside);
    if (metric.hands == Hands::each && (channels & force_channels) == 0)
        channels |= bit_of(Channel::cutting) | bit_of(Channel::jaw_force);
    return channels;
}

/// Metrics that are computed from one trace.
struct MetricGroup {
    std::vector<std::string> ids;
    ChannelSet channels = 0;
    bool scope = false;
    void add(const MetricDescriptor& metric) {
        ids.push_back(metric.id);
        channels |= channels_of(metric);
        scope = scope || metric.hands == Hands::scope;
    }
};

/// What holds at the beginning of a part since before it: the attempt's time runs, it is paused, the device
/// is gone. Metrics read it from events.
std::vector<Event> begun_before(const std::vector<Event>& events, std::uint32_t first) {
    constexpr std::array<std::pair<EventKind, EventKind>, 2> stops = {
        {{EventKind::pause, EventKind::resume}, {EventKind::device_lost, EventKind::device_back}}};
    const Event* moved = nullptr;
    std::array<const Event*, stops.size()> stopped{};
    for (const Event& event : events) {
        if (event.tick >= first) continue;
        if (event.kind == EventKind::first_movement) moved = &event;
        for (std::size_t i = 0; i < stops.size(); ++i) {
            if (event.kind == stops[i].first) stopped[i] = &event;
            if (event.kind == stops[i].second) stopped[i] = nullptr;
        }
    }
    std::vector<Event> begun;
    for (const Event* event : {moved, stopped[0], stopped[1]})
        if (event != nullptr) begun.push_back(*event);
    return begun;
}

struct RangeStopped {};

class RangeMetrics {
  public:
    RangeMetrics(const Scene& scene, const PartOfTicks& ticks, const std::vector<Event>& events,
                 MetricContext context, std::function<bool()> stop)
        : scene_(scene),
          ticks_(ticks),
          events_(events),
          context_(std::move(context)),
          stop_(std::move(stop)) {
        for (std::size_t h = 0; h < hand_count; ++h)
            has_hand_[h] = scene.instrument(static_cast<Hand>(h)) != nullptr;
    }

    std::vector<MetricResult> at_once() {
        TraceContent content;
        content.torque = false;
        for (std::size_t h = 0; h < hand_count; ++h)
            if (!has_hand_[h]) content.hand[h] = 0;
        return compute_metrics(trace_of(content), events_, context_);
    }

    /// The same rows in the same order.
    std::vector<MetricResult> hand_by_hand() {
        const std::vector<std::string> wanted = context_.metrics;
        MetricGroup together;
        // Of one hand: what follows from its movements, from its forces, and from both.
        std::map<int, MetricGroup> of_hand;
        for (const std::string& id : wanted) {
            const MetricDescriptor* metric = find_metric(id);
            if (metric == nullptr) {
                together.ids.push_back(id);  // compute_metrics() refuses it
                continue;
            }
            const bool counted = metric->needs_events && metric->aggregation == Aggregation::count;
            if (metric->hands != Hands::each || counted) together.add(*metric);
            if (metric->hands != Hands::each) continue;
            const auto reads = [&](ChannelSet channels) {
                return std::any_of(metric->channels.begin(), metric->channels.end(),
                                   [&](Channel channel) { return (bit_of(channel) & channels) != 0; });
            };
            const bool moves = reads(bit_of(Channel::position)), presses = reads(force_channels);
            of_hand[moves && presses ? 2 : presses ? 1 : 0].add(*metric);
        }
        std::vector<MetricResult> rows;
        add_rows(together, {true, true}, "", rows);
        for (const auto& [kind, group] : of_hand)
            for (std::size_t h = 0; h < hand_count; ++h)
                add_rows(group, {h == 0, h == 1}, hand_name(static_cast<Hand>(h)), rows);
        put_in_order(rows);
        return rows;
    }

  private:
    Trace trace_of(const TraceContent& content) const {
        TraceBuilder builder(ticks_.size(), tissue_labels(scene_), scene_.tick_rate, content);
        constexpr std::size_t between = 8192;
        std::size_t added = 0;
        ticks_.each([&](const TickSample& sample) {
            if (added++ % between == 0 && stop_ && stop_()) throw RangeStopped();
            builder.add(sample);
        });
        if (stop_ && stop_()) throw RangeStopped();
        return builder.finish(events_);
    }
    void add_rows(const MetricGroup& group, const std::array<bool, hand_count>& hands, const std::string& of,
                  std::vector<MetricResult>& rows) {
        if (group.ids.empty()) return;
        TraceContent content;
        content.torque = false;
        content.scope = group.scope || (!has_hand_[0] && !has_hand_[1]);
        for (std::size_t h = 0; h < hand_count; ++h)
            content.hand[h] = hands[h] && has_hand_[h] ? group.channels : 0;
        context_.metrics = group.ids;
        for (MetricResult& row : compute_metrics(trace_of(content), events_, context_))
            if (row.hand == of) rows.push_back(std::move(row));
    }
    /// By metric, then both hands together, left, right; the tissues of a hand stay in their order.
    static void put_in_order(std::vector<MetricResult>& rows) {
        std::map<std::string, std::size_t> place;
        for (const Metric& metric : metric_registry()) place.emplace(metric.descriptor.id, place.size());
        const auto rank = [&](const MetricResult& row) {
            const int hand = row.hand.empty() ? 0 : row.hand == hand_name(Hand::left) ? 1 : 2;
            return std::make_pair(place.at(row.id), hand);
        };
        std::stable_sort(rows.begin(), rows.end(),
                         [&](const MetricResult& a, const MetricResult& b) { return rank(a) < rank(b); });
    }

    const Scene& scene_;
    const PartOfTicks& ticks_;
    const std::vector<Event>& events_;
    MetricContext context_;
    const std::function<bool()> stop_;
    std::array<bool, hand_count> has_hand_{};
};

}  // namespace

std::vector<MetricResult> metrics_of_range(const Scene& scene, const TaskDefinition& task, std::uint64_t seed,
                                           const database::Trace& trace, double from, double to,
                                           const RangeOptions& options) {
    const double period = scene.tick_period();
    const auto tick_of = [&](double t) {
        constexpr double latest = 4e9;
        return static_cast<std::uint32_t>(std::clamp(t / period, 0.0, latest) + 0.5);
    };
    const PartOfTicks ticks(trace, tick_of(from), tick_of(to));
    auto events = part_of_records(trace.events, tick_of(from), tick_of(to));
    if (ticks.size() > 0) {
        std::vector<Event> begun = begun_before(trace.events, tick_of(from));
        for (Event& event : begun) event.tick = ticks.first_tick();
        events.insert(events.begin(), begun.begin(), begun.end());
    }
    MetricContext context = make_metric_context(scene, task, targets_of(scene, task, seed));
    context.specimen.reset();
    context.metrics = task.metrics;
    RangeMetrics metrics(scene, ticks, events, std::move(context), options.stop);
    const bool by_hand = options.passes == RangePasses::hand_by_hand ||
                         (options.passes == RangePasses::by_length && ticks.size() > most_at_once);
    try {
        return by_hand && !task.metrics.empty() ? metrics.hand_by_hand() : metrics.at_once();
    } catch (const RangeStopped&) {
        return {};
    }
}

}  // namespace fulcrum
