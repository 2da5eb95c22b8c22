// SPDX-License-Identifier: Apache-2.0
// Smoothness of movement: per movement segment, never over a whole attempt.
#include <algorithm>
#include <cmath>

#include "assessment/learning/statistics.h"
#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/signal.h"

namespace fulcrum {

namespace {

constexpr std::size_t fewest_segments = 5;
constexpr double noise_limit = 5e-6;  // m

/// The value of each segment that has one, and where.
struct SegmentValues {
    std::vector<double> values;
    std::vector<ScoredInterval> where;  ///< score: roughness, so that the worst come first
};

/// Median over segments, or the reason why there is none. The segments must hold half of the `moving`
/// samples.
Figure median_over(const std::vector<Segment>& segments, std::size_t moving, SegmentValues found,
                   StatementId few) {
    if (found.values.size() < fewest_segments)
        return absent(Absence::not_done, {few,
                                          {{"count", static_cast<double>(found.values.size())},
                                           {"least", static_cast<double>(fewest_segments)}}});
    std::size_t held = 0;
    for (const Segment& segment : segments) held += segment.core.size();
    if (2 * held < moving) return absent(Absence::not_done, StatementId::movements_hold_little);
    Figure figure;
    figure.count = static_cast<int>(found.values.size());
    figure.value = median_of(std::move(found.values));
    figure.evidence = worst_first(std::move(found.where));
    if (figure.evidence.size() > fewest_segments) figure.evidence.resize(fewest_segments);
    return figure;
}

std::vector<double> part_of(const std::vector<double>& series, std::size_t first, std::size_t last) {
    return {series.begin() + static_cast<std::ptrdiff_t>(first),
            series.begin() + static_cast<std::ptrdiff_t>(last)};
}

/// Of contact-free movements: tissue that is held or cut slows the hand and shakes it, whoever moves it.
template <typename Value>
SegmentValues speed_values(const HandAnalysis& hand, Value value) {
    SegmentValues found;
    for (const Segment& segment : hand.free_segments) {
        const MotionBlock& block = hand.motion[segment.block];
        const double x = value(part_of(block.speed, segment.whole.first, segment.whole.last), motion_rate);
        if (std::isnan(x)) continue;
        found.values.push_back(x);
        found.where.push_back({-x, block.interval(segment.whole)});
    }
    return found;
}

Figure sparc_of(const Analysis& analysis, const Selection& row) {
    const HandAnalysis& hand = analysis.hand(row.hand);
    return median_over(hand.free_segments, hand.free_moving_samples, speed_values(hand, sparc),
                       StatementId::few_movements);
}

}  // namespace

Figure log_jerk(const HandAnalysis& hand) {
    if (hand.noise_at_rest && *hand.noise_at_rest > noise_limit)
        return absent(Absence::not_measured,
                      {StatementId::device_noise,
                       {{"noise_um", *hand.noise_at_rest * 1e6}, {"limit_um", noise_limit * 1e6}}});
    return median_over(hand.free_segments, hand.free_moving_samples, speed_values(hand, ldlj),
                       StatementId::few_movements);
}

namespace {

Figure ldlj_of(const Analysis& analysis, const Selection& row) {
    return log_jerk(analysis.hand(row.hand));
}

/// Sums of the power of tip acceleration over all windows, and where the tremor band was strongest.
struct BandPower {
    double tremor = 0, all = 0;
    std::vector<ScoredInterval> windows;
};

void add_run(const std::array<std::vector<double>, 3>& position, const Run& run, double begin,
             BandPower& out) {
    constexpr std::size_t window = 2000, hop = 1000;  // 2 s, half overlap
    constexpr double bin_hz = 0.5;
    if (run.size() < window + 2) return;
    std::array<std::vector<double>, 3> acceleration;
    for (std::size_t c = 0; c < 3; ++c) {
        acceleration[c].reserve(run.size());
        for (std::size_t i = run.first + 1; i + 1 < run.last; ++i)
            acceleration[c].push_back((position[c][i + 1] - 2.0 * position[c][i] + position[c][i - 1]) *
                                      force_rate * force_rate);
    }
    for (std::size_t first = 0; first + window <= acceleration[0].size(); first += hop) {
        double tremor = 0;
        for (const auto& component : acceleration) {
            const std::vector<double> power = window_power(component, first, force_rate);
            for (std::size_t k = 1; k < power.size(); ++k) {
                const double hz = static_cast<double>(k) * bin_hz;
                if (hz >= 6.0 && hz <= 12.0) tremor += power[k];
                if (hz >= 0.25 && hz <= 20.0) out.all += power[k];
            }
        }
        out.tremor += tremor;
        const double t = begin + static_cast<double>(run.first + first) / force_rate;
        out.windows.push_back({tremor, {t, t + 2.0}});
    }
}

Figure tremor(const Analysis& analysis, const Selection& row) {
    const HandTrace& hand = analysis.trace().hand[static_cast<std::size_t>(row.hand)];
    BandPower power;
    double active_s = 0;
    for (const UniformGrid& grid : analysis.grids()) {
        const std::array<std::vector<double>, 3> position = {
            grid.interpolate(hand.px), grid.interpolate(hand.py), grid.interpolate(hand.pz)};
        std::vector<std::uint8_t> inside(grid.size(), 1);
        if (hand.has(Channel::inside)) inside = grid.hold(hand.inside);
        for (const Run& run : runs_of(inside.size(), [&](std::size_t i) { return inside[i] != 0; })) {
            active_s += static_cast<double>(run.size()) / force_rate;
            add_run(position, run, grid.begin(), power);
        }
    }
    if (active_s < 4.0 || power.windows.empty())
        return absent(Absence::not_done, {StatementId::short_inside, {{"least_s", 4.0}}});
    if (!(power.all > 0)) return absent(Absence::not_done, StatementId::hand_still);
    Figure figure;
    figure.value = power.tremor / power.all;
    figure.count = static_cast<int>(power.windows.size());
    figure.evidence = worst_first(std::move(power.windows));
    if (figure.evidence.size() > fewest_segments) figure.evidence.resize(fewest_segments);
    return figure;
}

Figure f_sparc(const Analysis& analysis, const Selection& row) {
    constexpr std::size_t factor = 10;  // force samples a motion sample
    const HandAnalysis& hand = analysis.hand(row.hand);
    SegmentValues found;
    for (const Segment& segment : hand.segments) {
        const ForceBlock& block = hand.force[segment.block];
        const std::size_t first = segment.whole.first * factor;
        const std::size_t last = std::min((segment.whole.last - 1) * factor + 1, block.norm.size());
        const auto begin = block.norm.begin();
        const double peak = *std::max_element(begin + static_cast<std::ptrdiff_t>(first),
                                              begin + static_cast<std::ptrdiff_t>(last));
        if (peak <= contact_force) continue;
        std::vector<double> rate;
        rate.reserve(last - first);
        for (std::size_t i = std::max<std::size_t>(first, 1); i + 1 < std::min(last + 1, block.norm.size());
             ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            rate.push_back((block.force.col(k + 1) - block.force.col(k - 1)).norm() * force_rate / 2.0);
        }
        const double x = sparc(rate, force_rate);
        if (std::isnan(x)) continue;
        found.values.push_back(x);
        found.where.push_back({-x, hand.motion[segment.block].interval(segment.whole)});
    }
    return median_over(hand.segments, hand.moving_samples, std::move(found),
                       StatementId::few_loaded_movements);
}

}  // namespace

std::vector<Metric> smoothness_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add = [&](MetricDescriptor d, Figure (*compute)(const Analysis&, const Selection&)) {
        if (d.filter.empty()) d.filter = motion_filter;
        if (d.minimum_rate == 0) d.minimum_rate = 50;
        d.channels.insert(d.channels.begin(), Channel::position);
        metrics.push_back({std::move(d), compute});
    };
    MetricDescriptor d = describe(
        {"sparc", QT_TRANSLATE_NOOP("fulcrum::metrics", "Smoothness (SPARC)"), "-", 0.01}, D::higher,
        Scale::raw, A::median_of_segments, E::strong, "Balasubramanian 2015",
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "Spectral arc length of tip speed, median over movements in which the instrument neither holds "
             "nor cuts tissue. Nearer to 0 is smoother; a single smooth reach has about -1.4."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "movements were made of many corrections: smoothness {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "start each move slowly and let it run out in one stroke")});
    d.version = 2;  // 2: contact-free movements, divided at deep minima of speed
    // A movement with one correction lies 0.07 below one without: half of a correction is no difference in
    // skill.
    d.least_deviation = 0.035;
    add(std::move(d), sparc_of);
    d = describe(
        {"ldlj", QT_TRANSLATE_NOOP("fulcrum::metrics", "Smoothness (log jerk)"), "-", 0.01}, D::higher,
        Scale::raw, A::median_of_segments, E::moderate, "Balasubramanian 2015, Hogan 2009",
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "Minus the logarithm of the dimensionless jerk of tip speed, median over movements in which the "
             "instrument neither holds nor cuts tissue. Nearer to 0 is smoother; absent where the device's "
             "position noise would decide it."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "movements were jerky: log jerk {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "relax the grip and accelerate gently")});
    // 2: noise at rest is what lies above 50 Hz, so that tremor is not taken for the device's. 3:
    // contact-free movements, divided at deep minima of speed.
    d.version = 3;
    add(std::move(d), ldlj_of);
    d = describe(
        {"tremor", QT_TRANSLATE_NOOP("fulcrum::metrics", "Tremor share"), "-", 0.01}, D::lower, Scale::raw,
        A::share, E::expert, "6-12 Hz share of the power of tip acceleration, Welch",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the tip's acceleration that is in the tremor band of 6 to 12 Hz."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "tremor made up {value} of the acceleration, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "rest the forearms and hold the handles loosely")});
    d.filter = "linear to 1 kHz, not low-passed";
    d.minimum_rate = 100;
    add(std::move(d), tremor);
    d = describe({"f_sparc", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force smoothness (SPARC)"), "-", 0.01},
                 D::higher, Scale::raw, A::median_of_segments, E::expert,
                 "SPARC of the rate of change of force",
                 {QT_TRANSLATE_NOOP(
                      "fulcrum::metrics",
                      "Spectral arc length of the rate at which the force on tissue changed, median over "
                      "movements in contact."),
                  QT_TRANSLATE_NOOP(
                      "fulcrum::metrics",
                      "force was applied in bursts: force smoothness {value}, below the required {limit}"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "take up the tension slowly and keep it")});
    d.filter = force_filter;
    d.version = force_filter_version;
    d.channels = {Channel::force};
    add(std::move(d), f_sparc);
    return metrics;
}

}  // namespace fulcrum
