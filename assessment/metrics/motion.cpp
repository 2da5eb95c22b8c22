// SPDX-License-Identifier: Apache-2.0
// Movement of the instrument: time, paths, depth, workspace. Positions after the 10 Hz filter at 100 Hz.
#include <algorithm>
#include <cmath>

#include "assessment/metrics/aim.h"
#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/signal.h"
#include "assessment/metrics/waits.h"

namespace fulcrum {
namespace {

constexpr double mm = 1e3, degrees = 180.0 / 3.14159265358979323846;  // in a metre, in a radian

/// Evidence of a sum over the whole attempt: its worst 5 s.
std::vector<TimeInterval> worst_five_seconds(const HandAnalysis& hand, bool angular) {
    std::vector<ScoredInterval> windows;
    for (const MotionBlock& block : hand.motion)
        worst_window(block, angular ? block.angular_speed : block.speed, windows);
    std::vector<TimeInterval> worst = worst_first(std::move(windows));
    if (worst.size() > 1) worst.resize(1);
    return worst;
}

Figure time(const Analysis& analysis, const Selection&) {
    std::optional<double> begin;
    for (int h = 0; h < hand_count; ++h) {
        const std::optional<double> first = analysis.first_movement(h);
        if (first && (!begin || *first < *begin)) begin = first;
    }
    // Slow, halting work has no movement that is long enough; the beginning then comes from the monitor.
    for (const Event& event : analysis.events()) {
        if (event.kind != EventKind::first_movement) continue;
        const double seen = analysis.trace().time_of(event);
        if (!begin || seen < *begin - rest_time) begin = seen;
        break;
    }
    if (!begin) return absent(Absence::not_done, StatementId::nothing_moved);
    const double end = std::max(*begin, analysis.trace().end);
    double paused = 0;
    for (const TimeInterval& pause : analysis.trace().pauses)
        paused += std::max(0.0, std::min(end, pause.end) - std::max(*begin, pause.begin));
    return value_of(end - *begin - paused, {longest_wait(analysis, *begin, end)});
}

Figure path_len(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    double sum = 0;
    for (const MotionBlock& block : hand.motion) sum += path_length(block.position);
    return value_of(sum * mm, worst_five_seconds(hand, false));
}

Figure ang_path(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    double sum = 0;
    for (const MotionBlock& block : hand.motion) sum += angular_path(block.axis);
    return value_of(sum * degrees, worst_five_seconds(hand, true));
}

/// Sum over steps of a function of the step along the shaft (positive deeper) and its length.
template <typename Part>
double sum_steps(const HandAnalysis& hand, Part part) {
    double sum = 0;
    for (const MotionBlock& block : hand.motion)
        for (Eigen::Index i = 1; i < block.position.cols(); ++i) {
            const Vector3 moved = block.position.col(i) - block.position.col(i - 1);
            const Vector3 axis = (block.axis.col(i) + block.axis.col(i - 1)).normalized();
            sum += part(moved.dot(axis), moved.norm());
        }
    return sum;
}

Figure retract_path(const Analysis& analysis, const Selection& row) {
    return value_of(mm * sum_steps(analysis.hand(row.hand),
                                   [](double along, double length) { return along < 0 ? length : 0.0; }));
}

Figure seek_path(const Analysis& analysis, const Selection& row) {
    return value_of(mm * sum_steps(analysis.hand(row.hand),
                                   [](double along, double length) { return along > 0 ? length : 0.0; }));
}

Figure depth_axis(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    std::vector<ScoredInterval> windows;
    for (const MotionBlock& block : hand.motion) {
        std::vector<double> amount(block.size(), 0.0);
        for (std::size_t i = 1; i < block.size(); ++i)
            amount[i] = std::abs((block.point(i) - block.point(i - 1)).dot(block.direction(i)));
        worst_window(block, amount, windows);
    }
    std::vector<TimeInterval> worst = worst_first(std::move(windows));
    if (worst.size() > 1) worst.resize(1);
    return value_of(mm * sum_steps(hand, [](double along, double) { return std::abs(along); }),
                    std::move(worst));
}

Figure n_moves(const Analysis& analysis, const Selection& row) {
    constexpr double fast = 0.050;                   // m/s
    constexpr std::size_t apart = 10, lasting = 20;  // samples: 0.1 s, 0.2 s
    int count = 0;
    std::vector<ScoredInterval> moves;
    for (const MotionBlock& block : analysis.hand(row.hand).motion) {
        std::vector<Run> merged;
        for (const Run& run : runs_of(block.size(), [&](std::size_t i) { return block.speed[i] > fast; })) {
            if (!merged.empty() && run.first - merged.back().last < apart)
                merged.back().last = run.last;
            else
                merged.push_back(run);
        }
        for (const Run& run : merged) {
            if (run.size() <= lasting) continue;
            ++count;
            moves.push_back({static_cast<double>(run.size()), block.interval(run)});
        }
    }
    return value_of(count, worst_first(std::move(moves)));
}

Figure n_sub(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    if (hand.segments.empty()) return absent(Absence::not_done, StatementId::no_movement_between_rests);
    int count = 0;
    std::vector<ScoredInterval> segments;
    for (const Segment& segment : hand.segments) {
        const MotionBlock& block = hand.motion[segment.block];
        const auto begin = block.speed.begin();
        const std::vector<double> speed(begin + static_cast<std::ptrdiff_t>(segment.whole.first),
                                        begin + static_cast<std::ptrdiff_t>(segment.whole.last));
        const auto peaks = static_cast<int>(find_peaks(speed, 0.010, 10).size());
        count += peaks;
        segments.push_back({static_cast<double>(peaks), block.interval(segment.whole)});
    }
    Figure figure = value_of(count, worst_first(std::move(segments)));
    figure.count = static_cast<int>(hand.segments.size());
    return figure;
}

/// Share (%) of active samples from the first movement on, as `time`, that fulfil test(block, i): waiting
/// before it is no work. Evidence: the longest runs of them.
template <typename Test>
Figure active_share(const Analysis& analysis, int hand, Test test) {
    const double begin = begin_of(analysis);
    std::size_t active = 0, found = 0;
    std::vector<ScoredInterval> runs;
    for (const MotionBlock& block : analysis.hand(hand).motion) {
        const auto counts = [&](std::size_t i) { return block.active[i] != 0 && block.time(i) >= begin; };
        for (const Run& run : runs_of(block.size(), counts)) active += run.size();
        for (const Run& run :
             runs_of(block.size(), [&](std::size_t i) { return counts(i) && test(block, i); })) {
            found += run.size();
            runs.push_back({static_cast<double>(run.size()), block.interval(run)});
        }
    }
    if (active == 0) return absent(Absence::not_done, StatementId::never_inside);
    return value_of(100.0 * static_cast<double>(found) / static_cast<double>(active),
                    worst_first(std::move(runs)));
}

Figure idle(const Analysis& analysis, const Selection& row) {
    return active_share(analysis, row.hand, [](const MotionBlock& block, std::size_t i) {
        return block.speed[i] < rest_speed && block.tissue[i] < 0;
    });
}

Figure off_screen(const Analysis& analysis, const Selection& row) {
    return active_share(analysis, row.hand,
                        [](const MotionBlock& block, std::size_t i) { return block.in_view[i] == 0; });
}

Figure speed_mean(const Analysis& analysis, const Selection& row) {
    double sum = 0;
    std::size_t count = 0;
    for (const MotionBlock& block : analysis.hand(row.hand).motion)
        for (std::size_t i = 0; i < block.size(); ++i)
            if (block.active[i] != 0) sum += block.speed[i], ++count;
    if (count == 0) return absent(Absence::not_done, StatementId::never_inside);
    return value_of(mm * sum / static_cast<double>(count));
}

Figure speed_peak(const Analysis& analysis, const Selection& row) {
    double peak = -1;
    TimeInterval where;
    for (const MotionBlock& block : analysis.hand(row.hand).motion)
        for (std::size_t i = 0; i < block.size(); ++i)
            if (block.active[i] != 0 && block.speed[i] > peak) {
                peak = block.speed[i];
                where = {block.time(i < 25 ? 0 : i - 25), block.time(std::min(i + 25, block.size() - 1))};
            }
    if (peak < 0) return absent(Absence::not_done, StatementId::never_inside);
    return value_of(mm * peak, {where});
}

Figure ws_volume(const Analysis& analysis, const Selection& row) {
    constexpr double chi_square_95 = 7.8147;  // three degrees of freedom
    std::vector<Vector3> points;
    for (const MotionBlock& block : analysis.hand(row.hand).motion)
        for (std::size_t i = 0; i < block.size(); ++i)
            if (block.active[i] != 0) points.push_back(block.point(i));
    if (points.empty()) return absent(Absence::not_done, StatementId::never_inside);
    Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = points[i];
    const double volume = ellipsoid_volume(matrix, chi_square_95);
    if (!(volume > 0)) return absent(Absence::not_done, StatementId::flat_movement);
    return value_of(volume * 1e6);
}

MetricDescriptor motion(Naming naming, Direction direction, Scale scale, Aggregation aggregation,
                        EvidenceGrade grade, const char* source, Wording wording) {
    MetricDescriptor d =
        describe(std::move(naming), direction, scale, aggregation, grade, source, std::move(wording));
    d.filter = motion_filter;
    d.minimum_rate = 20;
    d.channels = {Channel::position};
    return d;
}

using Compute = Figure (*)(const Analysis&, const Selection&);

MetricDescriptor with_axis(MetricDescriptor d) {
    d.channels.push_back(Channel::axis);
    return d;
}

// One text a line.
// clang-format off
/// The logarithm of time and path of one person at one level varies by at least this. People trained to an
/// expert's criterion took 130 s (SD 23 s) and 166 s (SD 52 s) for two tasks (Andreatta 2006): 18 and 31 %.
/// Half of the smaller one, since these include differences between people and a small group.
constexpr double least_pace_deviation = 0.09;

/// Time, paths and their straightness.
void add_paths(std::vector<Metric>& metrics) {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    const auto add = [&](MetricDescriptor d, Compute compute) { metrics.push_back({std::move(d), compute}); };
    MetricDescriptor d = motion(
        {"time", QT_TRANSLATE_NOOP("fulcrum::metrics", "Time"), "s", 0.1}, D::lower, Scale::ln, A::total,
        E::strong, "van Hove 2010; Fundamentals of Laparoscopic Surgery",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Time from the first movement or work of either instrument (or of the scope, where there is none) to the end of the task, pauses excluded. In a trace file without events the last sample is the end."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the task took {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "look at the next goal while finishing this one, and keep both hands at work")});
    d.version = 2;  // 2: halting work before the first movement also starts the time
    d.hands = Hands::any;
    d.absent_means = AbsentMeans::failed;
    d.least_deviation = least_pace_deviation;
    add(d, time);
    d = motion(
        {"path_len", QT_TRANSLATE_NOOP("fulcrum::metrics", "Path length"), "mm", 1}, D::lower, Scale::ln,
        A::total, E::strong, "Cotin 2002; van Hove 2010",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How far the instrument tip travelled."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip travelled {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "picture the target's depth first and go there in one straight move")});
    d.absent_means = AbsentMeans::failed;
    d.least_deviation = least_pace_deviation;
    add(d, path_len);
    d = with_axis(motion(
        {"ang_path", QT_TRANSLATE_NOOP("fulcrum::metrics", "Angular path"), "deg", 1}, D::lower, Scale::ln,
        A::total, E::strong, "sum of the angles between successive shaft axes",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How much the instrument shaft turned about the trocar."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the shaft turned {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "remember that the tip moves against the hand and steer with small hand movements")}));
    d.absent_means = AbsentMeans::failed;
    add(d, ang_path);
    d = motion(
        {"econ", QT_TRANSLATE_NOOP("fulcrum::metrics", "Economy of movement"), "-", 0.01}, D::higher,
        Scale::raw, A::ratio, E::strong, "Oropesa 2013; ratio of ideal to actual path",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Straight distances between way-points (targets reached, grasps, releases, beginnings and ends of strokes of a blade) over the path that was travelled between them; 1 is a straight line each time. Holds and strokes are left out."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the path between grasps and targets was indirect: economy {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "aim before moving, then go straight")});
    d.version = 2;  // 2: strokes of a blade are way-points
    d.needs_events = true;
    d.absent_means = AbsentMeans::failed;
    d.dependencies = {"path_len"};
    add(d, econ);
    d = with_axis(
        motion({"retract_path", QT_TRANSLATE_NOOP("fulcrum::metrics", "Path while retracting"), "mm", 1},
               D::context, Scale::raw, A::total, E::moderate, "sign of the step along the shaft",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "The part of the path on which the tip moved towards its trocar."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip moved {value} towards the trocar"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "withdraw only as far as the next move needs")}));
    d.dependencies = {"path_len"};
    add(d, retract_path);
    d = with_axis(
        motion({"seek_path", QT_TRANSLATE_NOOP("fulcrum::metrics", "Path while seeking"), "mm", 1},
               D::context, Scale::raw, A::total, E::moderate, "sign of the step along the shaft",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "The part of the path on which the tip moved away from its trocar."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip moved {value} away from the trocar"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "judge the depth before going in")}));
    d.dependencies = {"path_len"};
    add(d, seek_path);
    d = with_axis(motion(
        {"depth_axis", QT_TRANSLATE_NOOP("fulcrum::metrics", "Depth travel"), "mm", 1}, D::lower, Scale::raw,
        A::total, E::strong, "Cotin 2002, depth perception",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How far the tip travelled along its own shaft, in and out."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip travelled {value} in and out, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "read the depth from shadow and parallax before advancing")}));
    d.absent_means = AbsentMeans::failed;
    add(d, depth_axis);
}

/// Depth, number of movements, idle time.
void add_movements(std::vector<Metric>& metrics) {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    const auto add = [&](MetricDescriptor d, Compute compute) { metrics.push_back({std::move(d), compute}); };
    MetricDescriptor d = with_axis(motion(
        {"depth_err", QT_TRANSLATE_NOOP("fulcrum::metrics", "Depth error"), "mm", 0.1}, D::lower, Scale::raw,
        A::mean, E::moderate, "distance along the shaft from the target's surface at the end of the first movement",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How far from the target's surface, too deep or too shallow, the first movement ended, on average over targets."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the first movement missed the depth by {value} on average, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "slow down near the target and watch the contact shadow")}));
    d.needs_events = true;
    d.version = 2;  // 2: mean of the sizes, not of signed errors that cancel; from the surface, not the centre
    d.minimum_rate = 50;
    d.absent_means = AbsentMeans::failed;
    add(d, depth_err);
    d.id = "depth_err_sd";
    d.name = QT_TRANSLATE_NOOP("fulcrum::metrics", "Depth error, spread");
    d.version = 1;
    d.aggregation = A::deviation;
    d.dependencies = {"depth_err"};
    d.explanation = QT_TRANSLATE_NOOP("fulcrum::metrics", "How much the depth error varied from target to target (standard deviation).");
    d.advice_fault = QT_TRANSLATE_NOOP("fulcrum::metrics", "the depth of the first movement varied by {value}, above the limit of {limit}");
    d.advice_remedy = QT_TRANSLATE_NOOP("fulcrum::metrics", "use the same cue for depth every time");
    add(d, depth_err_sd);
    d = motion({"n_moves", QT_TRANSLATE_NOOP("fulcrum::metrics", "Movements"), "-", 1}, D::context,
               Scale::raw, A::count, E::strong, "Datta 2001, ICSAD",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of quick movements: above 50 mm/s for more than 0.2 s."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "there were {value} quick movements"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "join movements into fewer, larger ones")});
    d.minimum_rate = 50;
    add(d, n_moves);
    d = motion({"n_sub", QT_TRANSLATE_NOOP("fulcrum::metrics", "Sub-movements"), "-", 1}, D::lower,
               Scale::raw, A::count, E::moderate, "speed peaks with prominence of at least 10 mm/s",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "Number of corrections: speed peaks within movements."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "the movements contained {value} corrections, above the limit of {limit}"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "let one movement run out before correcting it")});
    d.minimum_rate = 50;
    add(d, n_sub);
    d = motion(
        {"idle", QT_TRANSLATE_NOOP("fulcrum::metrics", "Idle time"), "%", 1}, D::lower, Scale::raw, A::share,
        E::moderate, "D'Angelo 2015",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Share of the time inside the body, from the first movement on, in which the tip stood still and touched nothing."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the instrument was idle for {value} of the time, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "give the waiting hand a job: hold, expose, or get ready")});
    d.version = 2;  // 2: from the first movement on
    d.channels.push_back(Channel::tissue);
    add(d, idle);
}

/// Speed, working volume, visibility.
void add_speed_and_place(std::vector<Metric>& metrics) {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    const auto add = [&](MetricDescriptor d, Compute compute) { metrics.push_back({std::move(d), compute}); };
    add(motion({"speed_mean", QT_TRANSLATE_NOOP("fulcrum::metrics", "Mean speed"), "mm/s", 0.1}, D::context,
               Scale::raw, A::mean, E::moderate, "van Hove 2010",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "Mean speed of the tip inside the body."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "the mean speed was {value}"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "keep an even pace")}),
        speed_mean);
    add(motion({"speed_peak", QT_TRANSLATE_NOOP("fulcrum::metrics", "Peak speed"), "mm/s", 1}, D::context,
               Scale::raw, A::maximum, E::expert, "largest tip speed after the filter",
               {QT_TRANSLATE_NOOP("fulcrum::metrics", "Highest speed of the tip inside the body."),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "the peak speed was {value}"),
                QT_TRANSLATE_NOOP("fulcrum::metrics", "avoid sudden moves")}),
        speed_peak);
    MetricDescriptor d = motion(
        {"ws_volume", QT_TRANSLATE_NOOP("fulcrum::metrics", "Working volume"), "cm³", 0.1}, D::lower,
        Scale::ln, A::deviation, E::moderate, "95 % ellipsoid of tip positions",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Volume of the ellipsoid that holds 95 % of the tip's positions."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the working volume was {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "keep the tips close to where the work is")});
    d.absent_means = AbsentMeans::failed;
    add(d, ws_volume);
    d = motion(
        {"off_screen", QT_TRANSLATE_NOOP("fulcrum::metrics", "Off screen"), "%", 0.1}, D::lower, Scale::raw,
        A::share, E::strong, "instrument outside the image; a safety habit",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Share of the time inside the body, from the first movement on, in which the tip was outside the image."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the tip was out of sight for {value} of the time, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "move the camera first, then the instrument")});
    d.version = 2;  // 2: from the first movement on
    d.channels.push_back(Channel::in_view);
    add(d, off_screen);
}
// clang-format on

}  // namespace

std::vector<Metric> motion_metrics() {
    std::vector<Metric> metrics;
    add_paths(metrics);
    add_movements(metrics);
    add_speed_and_place(metrics);
    return metrics;
}

}  // namespace fulcrum
