// SPDX-License-Identifier: Apache-2.0
// How straight the ways between way-points were, and how well the depth of targets was judged.
#include "assessment/metrics/aim.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/signal.h"
#include "assessment/trace/cut_strokes.h"

namespace fulcrum {
namespace {

constexpr double millimetres = 1e3;  // in a metre

/// Times at which the hand reached a target, grasped, released, or began or ended a stroke.
std::vector<double> way_points(const Analysis& analysis, const std::vector<CutStroke>& strokes, int h) {
    std::vector<double> times;
    for (const Event& event : analysis.events()) {
        const bool way_point = event.kind == EventKind::target_reached || event.kind == EventKind::grasp ||
                               event.kind == EventKind::release;
        if (way_point && event.hand == h) times.push_back(analysis.trace().time_of(event));
    }
    for (const CutStroke& stroke : strokes) {
        if (stroke.hand != h) continue;
        times.push_back(stroke.begin);
        times.push_back(stroke.end);
    }
    std::sort(times.begin(), times.end());
    return times;
}

/// Depth beyond the nearer side of each target (negative: short of it), at the end of the first movement
/// after it was shown, m, and where.
struct DepthErrors {
    std::vector<double> errors;
    std::vector<ScoredInterval> movements;
    int shown = 0;
};

DepthErrors depth_errors(const Analysis& analysis, int h) {
    const HandAnalysis& hand = analysis.hand(h);
    std::vector<std::pair<double, std::size_t>> shown;
    for (const Event& event : analysis.events())
        if (event.kind == EventKind::target_shown && event.hand == h && event.detail >= 0 &&
            static_cast<std::size_t>(event.detail) < analysis.context().targets.size())
            shown.emplace_back(analysis.trace().time_of(event), static_cast<std::size_t>(event.detail));
    std::stable_sort(shown.begin(), shown.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    DepthErrors out;
    out.shown = static_cast<int>(shown.size());
    std::size_t s = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const double until = i + 1 < shown.size() ? shown[i + 1].first : analysis.trace().end;
        const auto start = [&](const Segment& segment) {
            return hand.motion[segment.block].time(segment.core.first);
        };
        while (s < hand.segments.size() && start(hand.segments[s]) < shown[i].first) ++s;
        if (s == hand.segments.size()) break;
        if (start(hand.segments[s]) > until) continue;
        const Segment& segment = hand.segments[s];
        const MotionBlock& block = hand.motion[segment.block];
        const std::size_t last = segment.whole.last - 1;
        const TargetSphere& target = analysis.context().targets[shown[i].second];
        const double error = (block.point(last) - target.centre).dot(block.direction(last)) + target.radius;
        out.errors.push_back(error);
        out.movements.push_back({std::abs(error), block.interval(segment.whole)});
    }
    return out;
}

Figure no_depth_error(const Analysis& analysis, const DepthErrors& depth, std::size_t needed) {
    if (analysis.context().targets.empty())
        return absent(Absence::not_measured, StatementId::target_positions_unknown);
    if (depth.shown == 0) return absent(Absence::not_done, StatementId::no_target_shown);
    return absent(Absence::not_done,
                  {StatementId::few_target_movements, {{"least", static_cast<double>(needed)}}});
}

}  // namespace

Figure econ(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    const std::vector<CutStroke> strokes =
        cut_strokes(analysis.events(), analysis.trace().tick_period, analysis.trace().end);
    std::vector<double> times = way_points(analysis, strokes, row.hand);
    // Along a stroke the blade follows the line that is to be divided, whatever its shape.
    const auto within_stroke = [&](double t) {
        return std::any_of(strokes.begin(), strokes.end(), [&](const CutStroke& stroke) {
            return stroke.hand == row.hand && stroke.begin <= t && t < stroke.end;
        });
    };
    const std::optional<double> begin = analysis.first_movement(row.hand);
    if (times.size() < 3) return absent(Absence::not_done, {StatementId::few_way_points, {{"least", 3.0}}});
    if (!begin) return absent(Absence::not_done, StatementId::hand_never_moved);
    times.erase(std::remove_if(times.begin(), times.end(), [&](double t) { return t <= *begin; }),
                times.end());
    times.insert(times.begin(), *begin);
    double straight = 0, travelled = 0;
    std::vector<ScoredInterval> legs;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        if (within_stroke(0.5 * (times[i] + times[i + 1]))) continue;
        const auto from = analysis.block_at(row.hand, times[i]),
                   to = analysis.block_at(row.hand, times[i + 1]);
        if (!from || from != to) continue;  // no movement spans a gap
        const MotionBlock& block = hand.motion[*from];
        std::size_t first = block.index(times[i]), last = block.index(times[i + 1]);
        // Holds at either end are not part of the path.
        while (first < last && block.pause[first] != 0) ++first;
        while (last > first && block.pause[last] != 0) --last;
        const auto size = static_cast<Eigen::Index>(last - first + 1);
        const double path =
            path_length(block.position.middleCols(static_cast<Eigen::Index>(first + block.held), size));
        const double distance = (block.point(last) - block.point(first)).norm();
        straight += distance;
        travelled += path;
        legs.push_back({path - distance, {block.time(first), block.time(last)}});
    }
    if (!(travelled > 0)) return absent(Absence::not_done, StatementId::still_between_way_points);
    Figure figure = value_of(std::clamp(straight / travelled, 0.0, 1.0), worst_first(std::move(legs)));
    figure.count = static_cast<int>(figure.evidence.size());
    return figure;
}

Figure depth_err(const Analysis& analysis, const Selection& row) {
    const DepthErrors depth = depth_errors(analysis, row.hand);
    if (depth.errors.empty()) return no_depth_error(analysis, depth, 1);
    double sum = 0;
    for (const double error : depth.errors) sum += std::abs(error);
    Figure figure =
        value_of(millimetres * sum / static_cast<double>(depth.errors.size()), worst_first(depth.movements));
    figure.count = static_cast<int>(depth.errors.size());
    return figure;
}

Figure depth_err_sd(const Analysis& analysis, const Selection& row) {
    const DepthErrors depth = depth_errors(analysis, row.hand);
    const auto n = static_cast<double>(depth.errors.size());
    if (depth.errors.size() < 2) return no_depth_error(analysis, depth, 2);
    double mean = 0, square = 0;
    for (const double error : depth.errors) mean += error / n;
    for (const double error : depth.errors) square += (error - mean) * (error - mean);
    Figure figure = value_of(millimetres * std::sqrt(square / (n - 1)), worst_first(depth.movements));
    figure.count = static_cast<int>(depth.errors.size());
    return figure;
}

}  // namespace fulcrum
