// SPDX-License-Identifier: Apache-2.0
// Energy, heat and blood: time and safety of activations, thermal spread, blood loss.
#include <algorithm>
#include <optional>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/trace/cut_strokes.h"

namespace fulcrum {

namespace {

constexpr double release_time = 0.5;   // s, outside pauses: up for less, the pedal is pumped
constexpr double shortest_on = 0.001;  // s, so that no activation weighs nothing

/// An activation of a row's hand, with the conditions that held throughout.
struct ActivationSpan {
    TimeInterval when;
    double on_time = 0;  ///< s, outside pauses
    Activation held;
    double distance = 0;  ///< m, least
};

/// Activations of one hand less than `release_time` apart, pauses not counted, are one, which is safe only if
/// all of them were.
std::vector<ActivationSpan> activations(const Analysis& analysis, int hand) {
    std::vector<ActivationSpan> spans;
    double begun[hand_count] = {-1, -1};
    std::optional<std::size_t> last[hand_count];
    for (const Event& event : analysis.events()) {
        if (event.hand >= hand_count || (hand >= 0 && event.hand != hand)) continue;
        const double t = analysis.trace().time_of(event);
        if (event.kind == EventKind::activation_begin) begun[event.hand] = t;
        if (event.kind != EventKind::activation_end) continue;
        const double begin = begun[event.hand] >= 0 ? begun[event.hand] : t;
        begun[event.hand] = -1;
        const Activation held = activation_of(event);
        const auto distance = static_cast<double>(event.value);
        const double on_time = std::max(shortest_on, running_time(analysis.trace(), begin, t));
        std::optional<std::size_t>& open = last[event.hand];
        if (open && running_time(analysis.trace(), spans[*open].when.end, begin) < release_time) {
            ActivationSpan& span = spans[*open];
            span.when.end = t;
            span.on_time += on_time;
            span.held.in_view = span.held.in_view && held.in_view;
            span.held.on_target = span.held.on_target && held.on_target;
            span.held.clear = span.held.clear && held.clear;
            span.distance = std::min(span.distance, distance);
            continue;
        }
        open = spans.size();
        spans.push_back({{begin, t}, on_time, held, distance});
    }
    return spans;
}

Figure energy_safe(const Analysis& analysis, const Selection& row) {
    const std::vector<ActivationSpan> spans = activations(analysis, row.hand);
    if (spans.empty()) return absent(Absence::not_done, StatementId::no_energy);
    std::vector<ScoredInterval> unsafe;
    double safe = 0, all = 0;
    for (const ActivationSpan& span : spans) {
        all += span.on_time;
        if (span.held.safe()) {
            safe += span.on_time;
        } else {
            // Smaller distances from the named structure are worse; out of view and off target count as much
            // as 2 mm.
            unsafe.push_back({!span.held.clear ? 1.0 - span.distance : 0.5, span.when});
        }
    }
    Figure figure;
    figure.value = 100.0 * safe / all;
    figure.count = static_cast<int>(spans.size());
    figure.evidence = worst_first(std::move(unsafe));
    return figure;
}

Figure energy_time(const Analysis& analysis, const Selection& row) {
    const Trace& trace = analysis.trace();
    const std::vector<std::uint8_t>& on = trace.hand[static_cast<std::size_t>(row.hand)].energy;
    double sum = 0;
    std::vector<ScoredInterval> spans;
    for (const TraceBlock& block : trace.blocks) {
        // A sample is valid until the next; the last one of a block is as long as the one before it.
        for (std::size_t i = block.first; i < block.last;) {
            if (on[i] == 0) {
                ++i;
                continue;
            }
            const std::size_t first = i;
            while (i < block.last && on[i] != 0) ++i;
            double end = 0;
            if (i < block.last) {
                end = trace.t[i];
            } else {
                end = trace.t[i - 1] +
                      (i - 1 > block.first ? trace.t[i - 1] - trace.t[i - 2] : trace.tick_period);
            }
            sum += end - trace.t[first];
            spans.push_back({end - trace.t[first], {trace.t[first], end}});
        }
    }
    Figure figure;
    figure.value = sum;
    figure.count = static_cast<int>(spans.size());
    figure.evidence = worst_first(std::move(spans));
    return figure;
}

/// Share of the divided length during which energy was on in the hand that divided. Nothing is cut in a
/// pause.
Figure energy_cut(const Analysis& analysis, const Selection&) {
    const Trace& trace = analysis.trace();
    std::vector<TimeInterval> on[hand_count];
    double begun[hand_count] = {-1, -1};
    for (const Event& event : analysis.events()) {
        if (event.hand >= hand_count) continue;
        if (event.kind == EventKind::activation_begin) begun[event.hand] = trace.time_of(event);
        if (event.kind != EventKind::activation_end || begun[event.hand] < 0) continue;
        on[event.hand].push_back({begun[event.hand], trace.time_of(event)});
        begun[event.hand] = -1;
    }
    double all = 0, hot = 0;
    std::vector<ScoredInterval> cold;
    for (const CutStroke& stroke : cut_strokes(analysis.events(), trace.tick_period, trace.end)) {
        double stroke_cold = 0;
        for (const CutElement& element : stroke.elements) {
            all += element.length;
            double covered = 0;
            if (stroke.hand >= 0)
                for (const TimeInterval& span : on[stroke.hand])
                    covered += running_time(trace, std::max(span.begin, element.begin),
                                            std::min(span.end, element.end));
            const double duration = running_time(trace, element.begin, element.end);
            const double share = duration > 0 ? std::min(1.0, covered / duration) : 0.0;
            hot += share * element.length;
            stroke_cold += (1 - share) * element.length;
        }
        if (stroke_cold > 0) cold.push_back({stroke_cold, {stroke.begin, stroke.end}});
    }
    if (!(all > 0)) return absent(Absence::not_done, StatementId::nothing_cut);
    Figure figure;
    figure.value = 100.0 * hot / all;
    figure.evidence = worst_first(std::move(cold));
    return figure;
}

/// The last value reported by the events of a running sum or maximum; 0 without events. The evidence is the
/// interval with the largest increase.
Figure last_reported(const Analysis& analysis, EventKind kind) {
    if (analysis.trace().t.empty()) return absent(Absence::not_measured, StatementId::nothing_recorded);
    double value = 0, before = 0;
    std::vector<ScoredInterval> rises;
    for (const Event& event : analysis.events()) {
        if (event.kind != kind) continue;
        before = value;
        value = std::max(value, static_cast<double>(event.value));
        const double t = analysis.trace().time_of(event);
        if (value > before) rises.push_back({value - before, {std::max(0.0, t - 1), t}});
    }
    Figure figure;
    figure.value = value;
    figure.evidence = worst_first(std::move(rises));
    return figure;
}

Figure lateral_heat(const Analysis& analysis, const Selection& /*row*/) {
    return last_reported(analysis, EventKind::heat_area);
}

Figure bleed_ml(const Analysis& analysis, const Selection& /*row*/) {
    Figure figure = last_reported(analysis, EventKind::blood_loss);
    if (!figure.value) return figure;
    // The evidence is the bleedings, the largest loss first.
    struct Open {
        std::int32_t outlet = 0;
        double begin = 0;
    };
    std::vector<Open> open;
    std::vector<ScoredInterval> bleedings;
    std::vector<std::pair<std::int32_t, double>> before;
    for (const Event& event : analysis.events()) {
        const double t = analysis.trace().time_of(event);
        if (event.kind == EventKind::bleed_begin) open.push_back({event.detail, t});
        if (event.kind != EventKind::bleed_end) continue;
        const auto begun = std::find_if(open.begin(), open.end(),
                                        [&](const Open& known) { return known.outlet == event.detail; });
        if (begun == open.end()) continue;
        auto known = std::find_if(before.begin(), before.end(),
                                  [&](const auto& entry) { return entry.first == event.detail; });
        if (known == before.end()) known = before.insert(before.end(), {event.detail, 0.0});
        bleedings.push_back({static_cast<double>(event.value) - known->second, {begun->begin, t}});
        known->second = static_cast<double>(event.value);
        open.erase(begun);
    }
    if (!bleedings.empty()) figure.evidence = worst_first(std::move(bleedings));
    return figure;
}

}  // namespace

// Long because: a table, one entry for each metric.
std::vector<Metric> energy_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add = [&](MetricDescriptor d, Hands hands, bool events, std::vector<Channel> channels,
                         Figure (*compute)(const Analysis&, const Selection&)) {
        d.filter = no_filter;
        d.hands = hands;
        d.needs_events = events;
        d.channels = std::move(channels);
        d.absent_means = AbsentMeans::failed;
        metrics.push_back({std::move(d), compute});
    };
    MetricDescriptor safe = describe(
        {"energy_safe", QT_TRANSLATE_NOOP("fulcrum::metrics", "Safe use of energy"), "%", 1}, D::higher,
        Scale::raw, A::share, E::expert,
        "tip in view, on target tissue, at least 2 mm from a named structure, each throughout; "
        "activations less than 0.5 s apart are one; weighed by on-time; pauses excluded from both",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the time with energy on that belongs to activations with the "
                           "tip in view, on the tissue to be divided or sealed, and clear of the "
                           "marked structure from beginning to end."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "{value} of the time with energy on was safe, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "press the pedal only when the blade is in view, on the tissue to be "
                           "divided and clear of the nerve")});
    // 2: by on-time, pumped pulses as one; 3: pauses are no on-time; 4: nor time between activations
    safe.version = 4;
    add(std::move(safe), Hands::either, true, {}, energy_safe);
    MetricDescriptor powered = describe(
        {"energy_cut", QT_TRANSLATE_NOOP("fulcrum::metrics", "Length divided under power"), "%", 1},
        D::higher, Scale::raw, A::share, E::expert,
        "cut_advance between activation_begin and activation_end of the same hand, pauses excluded; torn "
        "length counts as without power",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the divided length that was divided with energy on: a hook "
                           "has no edge, and fibres carry small vessels."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "{value} of the length was divided with energy on, below the required "
                           "{limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "press the pedal in short activations while the blade divides, and "
                           "divide cold only next to a nerve")});
    powered.version = 2;  // 2: by time outside pauses
    add(std::move(powered), Hands::either, true, {}, energy_cut);
    add(describe(
            {"energy_time", QT_TRANSLATE_NOOP("fulcrum::metrics", "Time with energy on"), "s", 0.1}, D::lower,
            Scale::raw, A::total, E::expert, "sum of activations",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "How long energy was on, all activations together."),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "energy was on for {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "release the pedal as soon as the tissue has parted")}),
        Hands::each, false, {Channel::energy}, energy_time);
    MetricDescriptor heat = describe(
        {"lateral_heat", QT_TRANSLATE_NOOP("fulcrum::metrics", "Thermal spread"), "mm²", 0.1}, D::lower,
        Scale::raw, A::total, E::moderate,
        "area with a CEM43 of at least 240 min; Sapareto and Dewey 1984: R 0.5 from 43 degrees C, 0.25 from "
        "39",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Area of tissue that was not to be heated and received a dose that kills it (240 "
                           "equivalent minutes at 43 degrees)."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "heat killed {value} of non-target tissue, above the limit of {limit}"),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "keep the hot blade away from the tissue behind it, and let it cool before touching")});
    heat.version = 2;  // 2: area at a dose that kills, not the largest dose
    add(std::move(heat), Hands::either, true, {}, lateral_heat);
    add(describe(
            {"bleed_ml", QT_TRANSLATE_NOOP("fulcrum::metrics", "Blood lost"), "mL", 0.1}, D::lower,
            Scale::raw, A::total, E::moderate, "modelled blood loss",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "Blood lost from all vessels."),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "{value} of blood were lost, above the limit of {limit}"),
             QT_TRANSLATE_NOOP(
                 "fulcrum::metrics",
                 "seal a vessel slowly without traction, and clip a bleeding point before anything else")}),
        Hands::either, true, {}, bleed_ml);
    const auto add_count = [&](Naming naming, const char* source, Wording wording,
                               Figure (*compute)(const Analysis&, const Selection&)) {
        MetricDescriptor d = describe(std::move(naming), D::lower, Scale::raw, A::count, E::moderate, source,
                                      std::move(wording));
        add(std::move(d), Hands::each, true, {}, compute);
    };
    add_count({"vessel_injury", QT_TRANSLATE_NOOP("fulcrum::metrics", "Vessels injured"), "-", 1},
              "event, critical: torn, or divided before it was closed",
              {QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "Number of vessels torn or divided before they were sealed or clipped."),
               QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "{value} vessels were torn or divided open, above the limit of {limit}"),
               QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "clip or seal a vessel before it is divided, and apply less traction")},
              counted<EventKind::vessel_injury>);
    add_count({"nerve_injury", QT_TRANSLATE_NOOP("fulcrum::metrics", "Nerve injured"), "-", 1},
              "event, critical: thermal dose of the marked nerve above its limit, or a blade through it",
              {QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "Number of injuries of the marked nerve, by heat or by a blade."),
               QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "the nerve was injured {value} times, above the limit of {limit}"),
               QT_TRANSLATE_NOOP("fulcrum::metrics",
                                 "divide on the side away from the nerve and let the blade cool")},
              counted<EventKind::nerve_injury>);
    add_count({"tear", QT_TRANSLATE_NOOP("fulcrum::metrics", "Tears"), "-", 1},
              "event: tissue tore under traction",
              {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of times tissue tore under traction."),
               QT_TRANSLATE_NOOP("fulcrum::metrics", "tissue tore {value} times, above the limit of {limit}"),
               QT_TRANSLATE_NOOP("fulcrum::metrics", "lift only until the tissue is taut")},
              counted<EventKind::tear>);
    return metrics;
}

}  // namespace fulcrum
