// SPDX-License-Identifier: Apache-2.0
// Coordination of the two hands. Their motion blocks have the same grids.
#include <cmath>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/signal.h"

namespace fulcrum {

namespace {

Figure handed(const Analysis& analysis, const Selection&) {
    double path[hand_count] = {0, 0};
    for (int h = 0; h < hand_count; ++h)
        for (const MotionBlock& block : analysis.hand(h).motion) path[h] += path_length(block.position);
    const double sum = path[0] + path[1];
    if (!(sum > 0)) return absent(Absence::not_done, StatementId::all_still);
    Figure figure;
    figure.value = 100.0 * std::abs(path[0] / sum - 0.5);
    return figure;
}

/// Speeds of both hands over the time in which both are active, one after the other over blocks.
Figure correlation(const Analysis& analysis, bool angular) {
    std::vector<double> left, right;
    const auto& blocks = analysis.hand(0).motion;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const MotionBlock& l = blocks[b];
        const MotionBlock& r = analysis.hand(1).motion[b];
        for (std::size_t i = 0; i < l.size(); ++i) {
            if (l.active[i] == 0 || r.active[i] == 0) continue;
            left.push_back(angular ? l.angular_speed[i] : l.speed[i]);
            right.push_back(angular ? r.angular_speed[i] : r.speed[i]);
        }
    }
    const double r = pearson(left, right);
    if (std::isnan(r)) return absent(Absence::not_done, StatementId::one_hand_still);
    Figure figure;
    figure.value = r;
    return figure;
}

Figure bimanual_r(const Analysis& analysis, const Selection&) {
    return correlation(analysis, false);
}
Figure bimanual_r_ang(const Analysis& analysis, const Selection&) {
    return correlation(analysis, true);
}

Figure simul(const Analysis& analysis, const Selection&) {
    constexpr double moving = 0.010;  // m/s
    std::size_t active = 0, both = 0;
    std::vector<ScoredInterval> runs;
    const auto& blocks = analysis.hand(0).motion;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const MotionBlock& l = blocks[b];
        const MotionBlock& r = analysis.hand(1).motion[b];
        for (std::size_t i = 0; i < l.size(); ++i) active += l.active[i] != 0 || r.active[i] != 0 ? 1 : 0;
        for (const Run& run : runs_of(l.size(), [&](std::size_t i) {
                 return l.active[i] != 0 && r.active[i] != 0 && l.speed[i] > moving && r.speed[i] > moving;
             })) {
            both += run.size();
            runs.push_back({static_cast<double>(run.size()), l.interval(run)});
        }
    }
    if (active == 0) return absent(Absence::not_done, StatementId::nobody_inside);
    Figure figure;
    figure.value = 100.0 * static_cast<double>(both) / static_cast<double>(active);
    figure.evidence = worst_first(std::move(runs));
    return figure;
}

}  // namespace

std::vector<Metric> coordination_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add = [&](MetricDescriptor d, Figure (*compute)(const Analysis&, const Selection&)) {
        d.filter = motion_filter;
        d.minimum_rate = 20;
        d.hands = Hands::both;
        metrics.push_back({std::move(d), compute});
    };
    MetricDescriptor d = describe(
        {"handed", QT_TRANSLATE_NOOP("fulcrum::metrics", "Handedness"), "%", 0.1}, D::lower, Scale::raw,
        A::share, E::moderate, "Hofstad 2013",
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "How unevenly the path is shared between the hands: 0 is half each, 50 is one hand alone."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "one hand did most of the travelling: {value} from an even share, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "pass work to the other hand on its own side")});
    d.channels = {Channel::position};
    d.dependencies = {"path_len"};
    add(d, handed);
    d = describe(
        {"bimanual_r", QT_TRANSLATE_NOOP("fulcrum::metrics", "Bimanual coordination"), "-", 0.01}, D::higher,
        Scale::raw, A::ratio, E::strong, "Hofstad 2013, Pearson r of tip speeds",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "How much the two tips sped up and slowed down together (correlation of speeds)."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "the hands moved one after the other: coordination {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "start the second hand's move before the first hand's ends")});
    d.channels = {Channel::position};
    add(d, bimanual_r);
    d = describe(
        {"bimanual_r_ang", QT_TRANSLATE_NOOP("fulcrum::metrics", "Bimanual coordination, angular"), "-",
         0.01},
        D::higher, Scale::raw, A::ratio, E::moderate, "Hofstad 2013, Pearson r of shaft angular speeds",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "How much the two shafts turned together (correlation of angular speeds)."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "the shafts turned one after the other: coordination {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "move both instruments towards the working point together")});
    d.channels = {Channel::position, Channel::axis};
    add(d, bimanual_r_ang);
    d = describe(
        {"simul", QT_TRANSLATE_NOOP("fulcrum::metrics", "Simultaneous movement"), "%", 1}, D::higher,
        Scale::raw, A::share, E::moderate, "share of time with both tips above 10 mm/s",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Share of the time in which both tips were moving."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "both hands moved together for only {value} of the time, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "let the left hand prepare while the right hand works")});
    d.channels = {Channel::position};
    add(d, simul);
    return metrics;
}

}  // namespace fulcrum
