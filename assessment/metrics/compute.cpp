// SPDX-License-Identifier: Apache-2.0
// Computes all metrics of a record: determines the rows, and which are absent before their function is
// called.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/metric.h"
#include "assessment/metrics/registry.h"

namespace fulcrum {

namespace {

constexpr double lost_limit_s = 0.1;  // the length of a gap that splits a trace

/// Which columns are missing, or nothing.
Statement missing_column(const Trace& trace, int h, Channel channel) {
    const HandTrace& hand = trace.hand[static_cast<std::size_t>(h)];
    if (hand.has(channel)) return {};
    const std::string prefix = std::string(hand_name(static_cast<Hand>(h))) + ".";
    std::istringstream columns(channel_columns(channel));
    std::string names, column;
    while (columns >> column) names += (names.empty() ? "" : ", ") + prefix + column;
    return {StatementId::not_recorded, {{"channels", names}}};
}

Statement missing_channels(const Analysis& analysis, const MetricDescriptor& d, int h) {
    for (const Channel channel : d.channels) {
        Statement missing = missing_column(analysis.trace(), h, channel);
        if (!missing.empty()) return missing;
    }
    return {};
}

/// The reason why a row cannot be measured, independent of the trainee; empty if it can.
Statement not_measurable(const Analysis& analysis, const MetricDescriptor& d, const Selection& row) {
    const Trace& trace = analysis.trace();
    if (d.needs_events && !analysis.context().events_recorded) return StatementId::no_events;
    if (d.hands == Hands::scope) {
        if (!d.channels.empty() && !trace.camera.recorded())
            return {StatementId::not_recorded, {{"channels", channel_columns(Channel::scope)}}};
    } else if (row.hand >= 0) {
        Statement missing = missing_channels(analysis, d, row.hand);
        if (!missing.empty()) return missing;
        if (row.tissue >= 0 && !d.channels.empty())
            missing = missing_column(trace, row.hand, Channel::tissue);
        if (!missing.empty()) return missing;
    } else if (!d.channels.empty()) {
        const Statement left = missing_channels(analysis, d, 0), right = missing_channels(analysis, d, 1);
        if (d.hands == Hands::both && !(left.empty() && right.empty())) return left.empty() ? right : left;
        const bool one = d.hands == Hands::either || (d.hands == Hands::any && !trace.camera.recorded());
        if (one && !left.empty() && !right.empty()) return left;
    }
    if (d.channels.empty()) return {};
    if (analysis.grids().empty()) return StatementId::few_samples;
    // A mean rate computed from rounded times may be slightly below a round value.
    if (analysis.mean_rate() < d.minimum_rate * 0.999)
        return {StatementId::low_rate, {{"rate_hz", analysis.mean_rate()}, {"least_hz", d.minimum_rate}}};
    if (static_cast<double>(trace.samples_lost) * trace.tick_period > lost_limit_s)
        return {StatementId::samples_lost, {{"count", static_cast<double>(trace.samples_lost)}}};
    return {};
}

class Rows {
  public:
    Rows(const Analysis& analysis, std::vector<MetricResult>& out) : analysis_(analysis), out_(out) {}

    void add(const Metric& metric) {
        if (metric.descriptor.hands != Hands::each) {
            add_row(metric, {});
            return;
        }
        if (metric.descriptor.needs_events && metric.descriptor.aggregation == Aggregation::count) {
            add_row(metric, {});  // counted events also have a row of both hands together
        }
        for (int h = 0; h < hand_count; ++h) {
            add_row(metric, {h, -1});
            if (!metric.descriptor.per_tissue) continue;
            for (std::size_t k = 0; k < analysis_.tissues().size(); ++k)
                if (is_shown(h, static_cast<int>(k))) add_row(metric, {h, static_cast<int>(k)});
        }
    }

  private:
    /// Tissues that a hand touched, or that the task limits.
    bool is_shown(int h, int tissue) const {
        if (analysis_.hand(h).touched[static_cast<std::size_t>(tissue)] != 0) return true;
        const auto& limits = analysis_.context().tissues;
        return std::any_of(limits.begin(), limits.end(), [&](const TissueLimits& known) {
            return known.label == analysis_.tissues()[static_cast<std::size_t>(tissue)];
        });
    }

    void add_row(const Metric& metric, const Selection& row) {
        const MetricDescriptor& d = metric.descriptor;
        const Statement reason = not_measurable(analysis_, d, row);
        Figure figure =
            reason.empty() ? metric.compute(analysis_, row) : absent(Absence::not_measured, reason);
        if (figure.value && !std::isfinite(*figure.value))
            figure = absent(Absence::not_measured, StatementId::numbers_too_large);
        MetricResult result;
        result.id = d.id;
        result.version = d.version;
        result.hand = row.hand < 0 ? "" : hand_name(static_cast<Hand>(row.hand));
        result.tissue = row.tissue < 0 ? "" : analysis_.tissues()[static_cast<std::size_t>(row.tissue)];
        result.value = figure.value;
        result.unit = d.unit;
        result.direction = d.direction;
        result.absence = figure.absence;
        result.absent_because = std::move(figure.because);
        result.evidence = std::move(figure.evidence);
        result.count = figure.count;
        out_.push_back(std::move(result));
    }

    const Analysis& analysis_;
    std::vector<MetricResult>& out_;
};

}  // namespace

bool only_describes(const std::vector<std::string>& described, const std::string& id,
                    const std::string& hand) {
    return std::any_of(described.begin(), described.end(), [&](const std::string& row) {
        return row == id || (!hand.empty() && row == id + "." + hand);
    });
}

std::size_t replaced_force_samples(const Trace& trace) {
    std::size_t replaced = 0;
    for (std::size_t h = 0; h < trace.hand.size(); ++h) despiked_forces(trace, h, replaced);
    return replaced;
}

std::vector<MetricResult> compute_metrics(const Trace& trace, const std::vector<Event>& events,
                                          const MetricContext& context) {
    for (const std::string& id : context.metrics)
        if (find_metric(id) == nullptr) throw std::invalid_argument("unknown metric '" + id + "'");
    const Analysis analysis(trace, events, context);
    std::vector<MetricResult> results;
    Rows rows(analysis, results);
    for (const Metric& metric : metric_registry()) {
        const auto& wanted = context.metrics;
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), metric.descriptor.id) != wanted.end())
            rows.add(metric);
    }
    for (MetricResult& result : results)
        if (only_describes(context.described, result.id, result.hand)) result.direction = Direction::context;
    return results;
}

const MetricResult* find_result(const std::vector<MetricResult>& results, const std::string& id,
                                const std::string& hand, const std::string& tissue) {
    for (const MetricResult& result : results)
        if (result.id == id && result.hand == hand && result.tissue == tissue) return &result;
    return nullptr;
}

}  // namespace fulcrum
