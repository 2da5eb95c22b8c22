// SPDX-License-Identifier: Apache-2.0
// Handling of the scope: its path, the horizon, how well targets are in the middle, time without the target,
// contacts of the lens.
#include <algorithm>
#include <cmath>
#include <limits>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/signal.h"
#include "assessment/metrics/smoothness.h"
#include "sim_core/instrument/framing.h"

namespace fulcrum {
namespace {

constexpr double millimetres = 1e3, degrees = 180 / 3.14159265358979323846;
constexpr double last_second = 1.0;            // s before a target counts as held
constexpr double least_pace_deviation = 0.09;  // as of path_len

CameraPose pose_at(const CameraTrace& camera, std::size_t i) {
    CameraPose pose;
    pose.position = Vector3(camera.px[i], camera.py[i], camera.pz[i]);
    pose.orientation = Quaternion(camera.qw[i], camera.qx[i], camera.qy[i], camera.qz[i]).normalized();
    return pose;
}

/// Calls `visit(i)` for each sample of the trace's blocks from `begin` to `end`.
template <typename Visit>
void each_sample(const Trace& trace, double begin, double end, Visit visit) {
    for (const TraceBlock& block : trace.blocks) {
        const auto first = trace.t.begin() + static_cast<std::ptrdiff_t>(block.first),
                   last = trace.t.begin() + static_cast<std::ptrdiff_t>(block.last);
        for (auto t = std::lower_bound(first, last, begin); t != last && *t <= end; ++t)
            visit(static_cast<std::size_t>(t - trace.t.begin()));
    }
}

Figure scope_path(const Analysis& analysis, const Selection&) {
    double sum = 0;
    std::vector<ScoredInterval> windows;
    for (const MotionBlock& block : analysis.scope().motion) {
        sum += path_length(block.position);
        worst_window(block, block.speed, windows);
    }
    std::vector<TimeInterval> worst = worst_first(std::move(windows));
    if (worst.size() > 1) worst.resize(1);
    return value_of(millimetres * sum, std::move(worst));
}

/// When the moving tip was to be followed; never: after the end.
double follow_begin(const Analysis& analysis) {
    const auto tip = static_cast<std::int32_t>(analysis.context().targets.size()) - 1;
    for (const Event& event : analysis.events())
        if (event.kind == EventKind::target_shown && event.hand >= hand_count && tip >= 0 &&
            event.detail == tip)
            return analysis.trace().time_of(event);
    return std::numeric_limits<double>::infinity();
}

/// A lens that follows a tip has the tip's speed: only what came before has movements of its own.
Figure scope_ldlj(const Analysis& analysis, const Selection&) {
    HandAnalysis scope = analysis.scope();
    scope.free_segments.clear();
    scope.free_moving_samples = 0;
    const double until = follow_begin(analysis);
    for (std::size_t b = 0; b < scope.motion.size(); ++b) {
        const MotionBlock& block = scope.motion[b];
        if (block.begin >= until) break;
        const std::size_t size = block.time(block.size() - 1) < until ? block.size() : block.index(until) + 1;
        const auto part = [&](const auto& series) {
            return std::decay_t<decltype(series)>(series.begin(),
                                                  series.begin() + static_cast<std::ptrdiff_t>(size));
        };
        FreeMovement movement = find_free_movements(part(block.speed), part(block.pause), {});
        scope.free_moving_samples += movement.samples;
        for (Segment& segment : movement.segments) {
            segment.block = b;
            scope.free_segments.push_back(segment);
        }
    }
    return log_jerk(scope);
}

Figure horizon_err(const Analysis& analysis, const Selection&) {
    double sum = 0;
    std::size_t count = 0;
    each_sample(analysis.trace(), begin_of(analysis), analysis.trace().end, [&](std::size_t i) {
        sum += std::abs(horizon_of(pose_at(analysis.trace().camera, i).orientation, Vector3::UnitZ()));
        ++count;
    });
    if (count == 0) return absent(Absence::not_done, StatementId::nothing_recorded);
    return value_of(degrees * sum / static_cast<double>(count));
}

/// Mean over targets of the mean of `error(framing)` over the last second of each hold.
template <typename Error>
Figure mean_over_holds(const Analysis& analysis, double unit, Error error) {
    const Trace& trace = analysis.trace();
    const MetricContext& context = analysis.context();
    if (context.targets.empty() || !(context.framing_distance > 0))
        return absent(Absence::not_measured, StatementId::target_positions_unknown);
    double sum = 0;
    int held = 0;
    std::vector<ScoredInterval> holds;
    for (const Event& event : analysis.events()) {
        // The last of the targets moves: where it was is not known here.
        if (event.kind != EventKind::target_reached || event.hand < hand_count || event.detail < 0 ||
            static_cast<std::size_t>(event.detail) + 1 >= context.targets.size())
            continue;
        const double reached = trace.time_of(event);
        const Vector3& target = context.targets[static_cast<std::size_t>(event.detail)].centre;
        double total = 0;
        std::size_t samples = 0;
        each_sample(trace, reached - last_second, reached, [&](std::size_t i) {
            total +=
                error(frame_of(pose_at(trace.camera, i), target, context.framing_distance, Vector3::UnitZ()));
            ++samples;
        });
        if (samples == 0) continue;
        const double mean = total / static_cast<double>(samples);
        holds.push_back({mean, {std::max(0.0, reached - last_second), reached}});
        sum += mean;
        ++held;
    }
    if (held == 0) return absent(Absence::not_done, StatementId::no_target_reached);
    Figure figure = value_of(unit * sum / held, worst_first(std::move(holds)));
    figure.count = held;
    return figure;
}

Figure centre_err(const Analysis& analysis, const Selection&) {
    return mean_over_holds(analysis, degrees, [](const Framing& framing) { return framing.off_centre; });
}

Figure size_err(const Analysis& analysis, const Selection&) {
    return mean_over_holds(analysis, 100, [](const Framing& framing) { return std::abs(1 - framing.size); });
}

Figure tip_lost(const Analysis& analysis, const Selection&) {
    double sum = 0;
    bool followed = false;
    std::vector<ScoredInterval> losses;
    for (const Event& event : analysis.events()) {
        if (event.kind != EventKind::target_lost) continue;
        followed = true;
        sum += event.value;
        const double back = analysis.trace().time_of(event);
        losses.push_back({event.value, {std::max(0.0, back - event.value), back}});
    }
    if (!followed) return absent(Absence::not_done, StatementId::tip_not_followed);
    return value_of(sum, worst_first(std::move(losses)));
}

MetricDescriptor of_scope(Naming naming, Scale scale, Aggregation aggregation, EvidenceGrade grade,
                          const char* source, Wording wording) {
    MetricDescriptor d =
        describe(std::move(naming), Direction::lower, scale, aggregation, grade, source, std::move(wording));
    d.hands = Hands::scope;
    d.filter = no_filter;
    d.channels = {Channel::scope};
    d.minimum_rate = 20;
    d.absent_means = AbsentMeans::failed;
    return d;
}

// One text a line.
// clang-format off
std::vector<Metric> all() {
    using A = Aggregation;
    using E = EvidenceGrade;
    const auto only_events = [](MetricDescriptor d) {
        d.channels.clear();
        d.minimum_rate = 0;
        d.needs_events = true;
        return d;
    };
    std::vector<Metric> metrics;
    MetricDescriptor d = of_scope(
        {"scope_path", QT_TRANSLATE_NOOP("fulcrum::metrics", "Path of the scope"), "mm", 1}, Scale::ln, A::total,
        E::expert, "path length, as path_len",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How far the scope's lens travelled."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the lens travelled {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "turn the light post towards the target first, then go there in one move")});
    d.filter = motion_filter;
    d.least_deviation = least_pace_deviation;
    metrics.push_back({d, scope_path});
    d = of_scope(
        {"scope_ldlj", QT_TRANSLATE_NOOP("fulcrum::metrics", "Smoothness of the scope"), "-", 0.01}, Scale::raw,
        A::median_of_segments, E::moderate, "log jerk as ldlj, of the lens; jerk tells experts from novices in camera work, Lindstrom Haughey 2025",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Minus the logarithm of the dimensionless jerk of the lens's speed, median over its movements. Nearer to 0 is smoother."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the scope moved jerkily: log jerk {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "hold the scope with both hands and let each move run out")});
    d.direction = Direction::higher;
    d.filter = motion_filter;
    d.minimum_rate = 50;
    d.absent_means = AbsentMeans::not_scored;
    metrics.push_back({d, scope_ldlj});
    metrics.push_back({of_scope(
        {"horizon_err", QT_TRANSLATE_NOOP("fulcrum::metrics", "Horizon"), "deg", 0.1}, Scale::raw, A::mean,
        E::expert, "mean size of the turn between the image's upright and the patient's z",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Angle between the image's upright and the body's, on average from the first movement on."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the image was tilted by {value} on average, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "turn the camera head back whenever the light post turns")}), horizon_err});
    d = of_scope(
        {"centre_err", QT_TRANSLATE_NOOP("fulcrum::metrics", "Centring"), "deg", 0.1}, Scale::raw, A::mean,
        E::expert, "mean over the last second of each hold",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Angle between the line of sight and the target, on average over the last second of each hold."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "targets were {value} off the middle on average, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "bring the target to the middle before you hold still")});
    d.needs_events = true;
    metrics.push_back({d, centre_err});
    d = of_scope(
        {"size_err", QT_TRANSLATE_NOOP("fulcrum::metrics", "Size in the image"), "%", 1}, Scale::raw, A::mean,
        E::expert, "wanted distance over distance, off 1; mean over the last second of each hold",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How much larger or smaller than wanted targets were, on average over the last second of each hold."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the size of targets was off by {value} on average, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "bring the rim of the target onto the circle before you hold still")});
    d.needs_events = true;
    metrics.push_back({d, size_err});
    metrics.push_back({only_events(of_scope(
        {"tip_lost", QT_TRANSLATE_NOOP("fulcrum::metrics", "Tip out of the middle"), "s", 0.1}, Scale::raw, A::total,
        E::moderate, "time without the wanted view (its share: Korndorffer 2005); the first search included",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "For how long the moving tip was not framed while it was to be followed, the search for it included."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip was not framed for {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "move with the tip, not after it")})), tip_lost});
    d = only_events(of_scope(
        {"lens_contact", QT_TRANSLATE_NOOP("fulcrum::metrics", "Lens contacts"), "-", 1}, Scale::raw, A::count,
        E::expert, "contacts of the lens with anything; a touched lens has to be wiped",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How often the lens touched something."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the lens touched something {value} times, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "withdraw a little before you look elsewhere")}));
    metrics.push_back({d, counted<EventKind::lens_contact>});
    return metrics;
}
// clang-format on

}  // namespace

std::vector<Metric> camera_metrics() {
    return all();
}

}  // namespace fulcrum
