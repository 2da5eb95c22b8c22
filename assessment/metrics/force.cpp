// SPDX-License-Identifier: Apache-2.0
// Force of the instrument on tissue, after the 50 Hz filter at 1 kHz; live events use the unfiltered tick.
#include <algorithm>
#include <cmath>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/metrics/signal.h"

namespace fulcrum {

namespace {

constexpr double step = 1.0 / force_rate;
constexpr double no_force = 1e-6;  // N: below the record's resolution

/// `any`, or `one` of the row's tissue.
Statement on_tissue(const Analysis& analysis, const Selection& row, StatementId any, StatementId one) {
    if (row.tissue < 0) return any;
    return {one, {{"tissue", analysis.tissues()[static_cast<std::size_t>(row.tissue)]}}};
}

Figure no_contact(const Analysis& analysis, const Selection& row) {
    return absent(Absence::not_done,
                  on_tissue(analysis, row, StatementId::no_force, StatementId::no_force_on));
}

/// Largest of series(block)[i] over the row's samples, with half a second around it as evidence.
struct Largest {
    double value = -1;
    TimeInterval where;
};
template <typename Series>
Largest largest_of(const Analysis& analysis, const Selection& row, Series series) {
    Largest largest;
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        for (std::size_t i = 0; i < block.norm.size(); ++i) {
            if (!block.on(i, row.tissue)) continue;
            const double value = series(block, i);
            if (value <= largest.value) continue;
            largest.value = value;
            largest.where = {block.time(i < 250 ? 0 : i - 250),
                             block.time(std::min(i + 250, block.norm.size() - 1))};
        }
    }
    return largest;
}

Figure f_max(const Analysis& analysis, const Selection& row) {
    const Largest largest =
        largest_of(analysis, row, [](const ForceBlock& block, std::size_t i) { return block.norm[i]; });
    if (largest.value <= no_force) return no_contact(analysis, row);
    Figure figure;
    figure.value = largest.value;
    figure.evidence = {largest.where};
    return figure;
}

/// Calls use(block, i) for every sample of the row that fulfils test(block, i).
template <typename Test, typename Use>
void each_sample(const Analysis& analysis, const Selection& row, Test test, Use use) {
    for (const ForceBlock& block : analysis.hand(row.hand).force)
        for (std::size_t i = 0; i < block.norm.size(); ++i)
            if (block.on(i, row.tissue) && test(block, i)) use(block, i);
}

bool pressing(const ForceBlock& block, std::size_t i) {
    return block.norm[i] > contact_force;
}

Figure f_sd(const Analysis& analysis, const Selection& row) {
    const auto touching = [](const ForceBlock& block, std::size_t i) { return block.tissue[i] >= 0; };
    double sum = 0, square = 0, count = 0;
    each_sample(analysis, row, touching,
                [&](const ForceBlock& block, std::size_t i) { sum += block.norm[i], ++count; });
    if (count == 0) return no_contact(analysis, row);
    const double mean = sum / count;
    each_sample(analysis, row, touching, [&](const ForceBlock& block, std::size_t i) {
        square += (block.norm[i] - mean) * (block.norm[i] - mean);
    });
    Figure figure;
    figure.value = std::sqrt(square / count);
    return figure;
}

Figure f_mean_nz(const Analysis& analysis, const Selection& row) {
    double sum = 0, count = 0;
    each_sample(analysis, row, pressing,
                [&](const ForceBlock& block, std::size_t i) { sum += block.norm[i], ++count; });
    if (count == 0) return no_contact(analysis, row);
    Figure figure;
    figure.value = sum / count;
    return figure;
}

Figure impulse(const Analysis& analysis, const Selection& row) {
    double sum = 0;
    std::vector<ScoredInterval> contacts;
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        for (std::size_t i = 0; i < block.norm.size(); ++i)
            if (block.on(i, row.tissue)) sum += block.norm[i] * step;
        for (const Run& run : runs_of(block.norm.size(), [&](std::size_t i) {
                 return block.on(i, row.tissue) && pressing(block, i);
             })) {
            double part = 0;
            for (std::size_t i = run.first; i < run.last; ++i) part += block.norm[i];
            contacts.push_back({part, block.interval(run)});
        }
    }
    if (sum <= no_force) return no_contact(analysis, row);
    Figure figure;
    figure.value = sum;
    figure.evidence = worst_first(std::move(contacts));
    return figure;
}

/// Limits by tissue of a row, or the reason why there are none. Samples of tissues without a limit do not
/// count.
std::vector<std::optional<double>> limits_of(const Analysis& analysis, const Selection& row) {
    std::vector<std::optional<double>> limits;
    for (std::size_t k = 0; k < analysis.tissues().size(); ++k) {
        const auto tissue = static_cast<int>(k);
        limits.push_back(row.tissue < 0 || row.tissue == tissue ? analysis.force_limit(tissue)
                                                                : std::nullopt);
    }
    return limits;
}

/// How far a sample lies above the limit of the tissue it is on, N; negative below, absent without a limit.
std::optional<double> excess_at(const ForceBlock& block, std::size_t i,
                                const std::vector<std::optional<double>>& limits) {
    const std::int16_t tissue = block.tissue[i];
    if (tissue < 0 || static_cast<std::size_t>(tissue) >= limits.size()) return std::nullopt;
    const std::optional<double>& limit = limits[static_cast<std::size_t>(tissue)];
    if (!limit) return std::nullopt;
    return block.norm[i] - *limit;
}

std::optional<Figure> no_limit(const Analysis& analysis, const Selection& row) {
    const bool known =
        row.tissue < 0 ? analysis.any_force_limit() : analysis.force_limit(row.tissue).has_value();
    if (known) return std::nullopt;
    return absent(Absence::not_measured,
                  on_tissue(analysis, row, StatementId::no_force_limit, StatementId::no_force_limit_for));
}

Figure f_peaks(const Analysis& analysis, const Selection& row) {
    if (const auto missing = no_limit(analysis, row)) return *missing;
    const auto limits = limits_of(analysis, row);
    int count = 0;
    std::vector<ScoredInterval> where;
    for (const ForceBlock& block : analysis.hand(row.hand).force)
        for (const std::size_t peak : find_peaks(block.norm, 0.5, 200)) {
            const std::optional<double> excess = excess_at(block, peak, limits);
            if (!excess || *excess <= 0) continue;
            ++count;
            where.push_back({*excess,
                             {block.time(peak < 250 ? 0 : peak - 250),
                              block.time(std::min(peak + 250, block.norm.size() - 1))}});
        }
    Figure figure;
    figure.value = count;
    figure.evidence = worst_first(std::move(where));
    return figure;
}

Figure dfdt_max(const Analysis& analysis, const Selection& row) {
    const Largest largest = largest_of(analysis, row, [](const ForceBlock& block, std::size_t i) {
        if (i == 0 || i + 1 == block.norm.size()) return 0.0;
        return std::abs(block.norm[i + 1] - block.norm[i - 1]) * force_rate / 2.0;
    });
    if (largest.value <= no_force) return no_contact(analysis, row);
    Figure figure;
    figure.value = largest.value;
    figure.evidence = {largest.where};
    return figure;
}

Figure f_volume(const Analysis& analysis, const Selection& row) {
    std::vector<Vector3> forces;
    each_sample(analysis, row, pressing, [&](const ForceBlock& block, std::size_t i) {
        forces.emplace_back(block.force.col(static_cast<Eigen::Index>(i)));
    });
    if (static_cast<double>(forces.size()) < force_rate)
        return absent(Absence::not_done, {StatementId::short_force, {{"least_s", 1.0}}});
    Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(forces.size()));
    for (std::size_t i = 0; i < forces.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = forces[i];
    Figure figure;
    figure.value = ellipsoid_volume(matrix, 1.0);
    return figure;
}

/// Time above the limit and the impulse above it, over the row's tissues.
struct Over {
    double time = 0, impulse = 0;
    std::vector<ScoredInterval> where;
};
Over over_limit(const Analysis& analysis, const Selection& row) {
    const auto limits = limits_of(analysis, row);
    Over over;
    for (const ForceBlock& block : analysis.hand(row.hand).force) {
        for (const Run& run : runs_of(block.norm.size(), [&](std::size_t i) {
                 const std::optional<double> excess = excess_at(block, i, limits);
                 return excess && *excess > 0;
             })) {
            double part = 0;
            for (std::size_t i = run.first; i < run.last; ++i) part += *excess_at(block, i, limits) * step;
            over.time += static_cast<double>(run.size()) * step;
            over.impulse += part;
            over.where.push_back({part, block.interval(run)});
        }
    }
    return over;
}

template <double Over::*figure_of>
Figure over(const Analysis& analysis, const Selection& row) {
    if (const auto missing = no_limit(analysis, row)) return *missing;
    Over above = over_limit(analysis, row);
    Figure figure;
    figure.value = above.*figure_of;
    figure.evidence = worst_first(std::move(above.where));
    return figure;
}

}  // namespace

// Long because: a table, one entry for each metric.
std::vector<Metric> force_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add = [&](MetricDescriptor d, std::vector<Channel> more,
                         Figure (*compute)(const Analysis&, const Selection&)) {
        d.filter = force_filter;
        d.version = force_filter_version;
        d.per_tissue = true;
        d.channels = {Channel::force};
        d.channels.insert(d.channels.end(), more.begin(), more.end());
        d.absent_means = AbsentMeans::failed;
        // Nobody keeps a force more exactly than it is felt: the smallest difference felt is 7 % (Jones
        // 1989).
        if (d.id == "f_max") d.least_deviation = 0.07;
        metrics.push_back({std::move(d), compute});
    };
    add(describe(
            {"f_max", QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest force"), "N", 0.1}, D::lower, Scale::ln,
            A::maximum, E::strong, "Horeman 2012; Trejos 2014",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest force of the instrument on tissue."),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "the force rose to {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "approach slowly, and stop when the tissue no longer yields")}),
        {}, f_max);
    add(describe(
            {"f_sd", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force variation"), "N", 0.01}, D::lower,
            Scale::raw, A::deviation, E::moderate, "Trejos 2014",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "Standard deviation of the force while in contact."),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "the force varied by {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "take up tension once and keep it even")}),
        {Channel::tissue}, f_sd);
    add(describe(
            {"f_mean_nz", QT_TRANSLATE_NOOP("fulcrum::metrics", "Mean force in contact"), "N", 0.01},
            D::lower, Scale::raw, A::mean, E::strong, "Horeman 2012, mean non-zero force",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "Mean force over the time in which it was above 0.1 N."),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "the mean force was {value}, above the limit of {limit}"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "hold tissue with the least force that moves it")}),
        {}, f_mean_nz);
    add(describe({"impulse", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force-time product"), "N·s", 0.1},
                 D::lower, Scale::ln, A::total, E::moderate, "Trejos 2014, integral of force",
                 {QT_TRANSLATE_NOOP("fulcrum::metrics", "Force integrated over time."),
                  QT_TRANSLATE_NOOP("fulcrum::metrics",
                                    "the force-time product was {value}, above the limit of {limit}"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "release tissue that need not be held")}),
        {}, impulse);
    add(describe({"f_peaks", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force peaks"), "-", 1}, D::lower,
                 Scale::raw, A::count, E::moderate,
                 "peaks above the tissue's limit, prominence 0.5 N, 0.2 s apart",
                 {QT_TRANSLATE_NOOP("fulcrum::metrics",
                                    "Number of times the force peaked above the tissue's limit."),
                  QT_TRANSLATE_NOOP("fulcrum::metrics",
                                    "the force exceeded the tissue's limit {value} times (limit {limit})"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "move more slowly when tissue is taut")}),
        {Channel::tissue}, f_peaks);
    MetricDescriptor d = describe(
        {"dfdt_max", QT_TRANSLATE_NOOP("fulcrum::metrics", "Steepest force change"), "N/s", 1}, D::lower,
        Scale::ln, A::maximum, E::moderate, "Trejos 2014, derivative of force",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Fastest rise or fall of the force."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "the force changed by {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "touch tissue slowly and release it slowly")});
    d.minimum_rate = 500;  // slower samples hide how steep a rise was
    add(std::move(d), {}, dfdt_max);
    add(describe({"f_volume", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force volume"), "N³", 0.01}, D::lower,
                 Scale::raw, A::deviation, E::strong, "Horeman 2012, ellipsoid of one standard deviation",
                 {QT_TRANSLATE_NOOP(
                      "fulcrum::metrics",
                      "Volume of the ellipsoid that one standard deviation of the force vector spans."),
                  QT_TRANSLATE_NOOP(
                      "fulcrum::metrics",
                      "the force varied in all directions: volume {value}, above the limit of {limit}"),
                  QT_TRANSLATE_NOOP("fulcrum::metrics", "decide on one direction of traction and keep it")}),
        {}, f_volume);
    add(describe(
            {"over_time", QT_TRANSLATE_NOOP("fulcrum::metrics", "Time above the force limit"), "s", 0.01},
            D::lower, Scale::raw, A::total, E::expert, "limit of the tissue, see its source",
            {QT_TRANSLATE_NOOP("fulcrum::metrics", "How long the force was above the tissue's limit."),
             QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "the force exceeded the tissue's limit for {value} (limit {limit})"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "ease off as soon as the force bar turns")}),
        {Channel::tissue}, over<&Over::time>);
    add(describe(
            {"over_impulse", QT_TRANSLATE_NOOP("fulcrum::metrics", "Force-time product above the limit"),
             "N·s", 0.01},
            D::lower, Scale::raw, A::total, E::expert, "limit of the tissue, see its source",
            {QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "The part of the force above the tissue's limit, added up over time."),
             QT_TRANSLATE_NOOP("fulcrum::metrics",
                               "the force-time product above the tissue's limit was {value} (limit {limit})"),
             QT_TRANSLATE_NOOP("fulcrum::metrics", "ease off as soon as the force bar turns")}),
        {Channel::tissue}, over<&Over::impulse>);
    return metrics;
}

}  // namespace fulcrum
