// SPDX-License-Identifier: Apache-2.0
// Division of a marked line: traction, distance from the line, divided length. Computed from the events of
// the cut; positions and distances are those of the tissue at rest.
#include <algorithm>
#include <cmath>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/trace/cut_strokes.h"

namespace fulcrum {

namespace {

constexpr double to_mm = 1e3, to_mm2 = 1e6;

/// The strokes, or the reason why there is no value.
struct Cut {
    std::vector<CutStroke> strokes;
    std::optional<Figure> absence;
};

Cut cut_of(const Analysis& analysis) {
    Cut cut;
    if (!analysis.context().cut) {
        cut.absence = absent(Absence::not_measured, StatementId::no_marked_line);
        return cut;
    }
    const Trace& trace = analysis.trace();
    cut.strokes = cut_strokes(analysis.events(), trace.tick_period, trace.end);
    const bool any = std::any_of(cut.strokes.begin(), cut.strokes.end(), [](const CutStroke& stroke) {
        return std::any_of(stroke.elements.begin(), stroke.elements.end(),
                           [](const CutElement& element) { return element.length > 0; });
    });
    if (!any) cut.absence = absent(Absence::not_done, StatementId::nothing_cut);
    return cut;
}

TimeInterval around(const CutElement& element) {
    return {std::max(0.0, element.begin - 0.5), element.end + 0.5};
}

/// A share of time or length by traction, with the stretches outside the band as evidence.
class TractionShare {
  public:
    explicit TractionShare(const CutPlan& plan) : plan_(plan) {}
    void add(double amount, double traction, const TimeInterval& when) {
        whole_ += amount;
        const double off = std::max({0.0, plan_.traction_low - traction, traction - plan_.traction_high});
        if (off <= 0) {
            inside_ += amount;
        } else if (amount > 0) {
            // Consecutive intervals are one piece of evidence with the largest score of them.
            if (!outside_.empty() && when.begin <= outside_.back().interval.end + 0.1) {
                outside_.back().interval.end = std::max(outside_.back().interval.end, when.end);
                outside_.back().score = std::max(outside_.back().score, off);
            } else {
                outside_.push_back({off, when});
            }
        }
    }
    Figure figure() const {
        if (!(whole_ > 0)) return absent(Absence::not_measured, StatementId::traction_not_recorded);
        Figure figure;
        figure.value = 100.0 * inside_ / whole_;
        figure.evidence = worst_first(outside_);
        return figure;
    }

  private:
    CutPlan plan_;
    double inside_ = 0, whole_ = 0;
    std::vector<ScoredInterval> outside_;
};

Figure no_band() {
    return absent(Absence::not_measured, StatementId::no_traction_band);
}
bool has_band(const CutPlan& plan) {
    return plan.traction_high > plan.traction_low;
}

Figure traction_eff(const Analysis& analysis, const Selection& /*row*/) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    const CutPlan& plan = *analysis.context().cut;
    if (!has_band(plan)) return no_band();
    TractionShare share(plan);
    for (const CutStroke& stroke : cut.strokes) {
        // The values of an advance apply since the previous advance; those of the last until the blade is
        // out.
        double since = stroke.begin;
        std::optional<double> traction;
        for (const CutElement& element : stroke.elements) {
            if (!element.traction) continue;
            traction = element.traction;
            share.add(running_time(analysis.trace(), since, element.end), *traction, {since, element.end});
            since = element.end;
        }
        if (traction)
            share.add(running_time(analysis.trace(), since, stroke.end), *traction, {since, stroke.end});
    }
    return share.figure();
}

Figure traction_eff_len(const Analysis& analysis, const Selection& /*row*/) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    const CutPlan& plan = *analysis.context().cut;
    if (!has_band(plan)) return no_band();
    TractionShare share(plan);
    for (const CutStroke& stroke : cut.strokes)
        for (const CutElement& element : stroke.elements)
            if (element.traction) share.add(element.length, *element.traction, {element.begin, element.end});
    return share.figure();
}

Figure cut_dev(const Analysis& analysis, const Selection& /*row*/) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    double area = 0;
    std::vector<ScoredInterval> strokes;
    for (const CutStroke& stroke : cut.strokes) {
        double beside = 0;
        for (const CutElement& element : stroke.elements) beside += area_beside(element);
        area += beside;
        if (beside > 0) strokes.push_back({beside, {stroke.begin, stroke.end}});
    }
    Figure figure;
    figure.value = area * to_mm2;
    figure.evidence = worst_first(std::move(strokes));
    return figure;
}

Figure cut_dev_max(const Analysis& analysis, const Selection& /*row*/) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    double largest = 0;
    const CutElement* where = nullptr;
    for (const CutStroke& stroke : cut.strokes) {
        for (const CutElement& element : stroke.elements) {
            const double distance = std::max(std::abs(element.from_distance), std::abs(element.distance));
            if (distance <= largest) continue;
            largest = distance;
            where = &element;
        }
    }
    Figure figure;
    figure.value = largest * to_mm;
    if (where != nullptr) figure.evidence = {around(*where)};
    return figure;
}

/// The elements beyond the tolerance, worst first; deep and shallow as asked.
std::vector<TimeInterval> off_plane(const Cut& cut, double tolerance, bool deep, bool shallow) {
    std::vector<ScoredInterval> stretches;
    for (const CutStroke& stroke : cut.strokes) {
        for (const CutElement& element : stroke.elements) {
            const double above = std::max(element.from_distance, element.distance);
            const double below = -std::min(element.from_distance, element.distance);
            const double score = std::max(deep ? above : 0.0, shallow ? below : 0.0);
            if (score <= tolerance) continue;
            const TimeInterval when = around(element);
            if (!stretches.empty() && when.begin <= stretches.back().interval.end) {
                stretches.back().interval.end = std::max(stretches.back().interval.end, when.end);
                stretches.back().score = std::max(stretches.back().score, score);
            } else {
                stretches.push_back({score, when});
            }
        }
    }
    return worst_first(std::move(stretches));
}

Figure plane_quantile(const Analysis& analysis, double share, bool size) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    Figure figure;
    figure.value = distance_quantile(cut.strokes, share, size).value_or(0.0) * to_mm;
    figure.evidence = off_plane(cut, analysis.context().cut->tolerance, true, true);
    return figure;
}
Figure plane_dev(const Analysis& analysis, const Selection& /*row*/) {
    return plane_quantile(analysis, 0.5, true);
}
Figure plane_dev_median(const Analysis& analysis, const Selection& /*row*/) {
    return plane_quantile(analysis, 0.5, false);
}
Figure plane_dev_p95(const Analysis& analysis, const Selection& /*row*/) {
    return plane_quantile(analysis, 0.95, true);
}

Figure plane_share(const Analysis& analysis, bool deep) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    const double tolerance = analysis.context().cut->tolerance;
    double beyond = 0, whole = 0;
    for (const CutStroke& stroke : cut.strokes) {
        for (CutElement element : stroke.elements) {
            whole += element.length;
            if (!deep) {
                element.from_distance = -element.from_distance;
                element.distance = -element.distance;
            }
            beyond += element.length * share_beyond(element, tolerance);
        }
    }
    Figure figure;
    figure.value = 100.0 * beyond / whole;
    figure.evidence = off_plane(cut, tolerance, deep, !deep);
    return figure;
}
Figure plane_deep(const Analysis& analysis, const Selection& /*row*/) {
    return plane_share(analysis, true);
}
Figure plane_shallow(const Analysis& analysis, const Selection& /*row*/) {
    return plane_share(analysis, false);
}

Figure area_developed(const Analysis& analysis, const Selection& /*row*/) {
    const Cut cut = cut_of(analysis);
    if (cut.absence) return *cut.absence;
    const CutPlan& plan = *analysis.context().cut;
    if (!(plan.length > 0)) return absent(Absence::not_measured, StatementId::line_without_length);
    // What tore by itself is apart, but not divided; the evidence is where it tore.
    const double divided = divided_length(cut.strokes, plan.length, plan.corridor) -
                           torn_length(cut.strokes, plan.length, plan.corridor);
    std::vector<ScoredInterval> torn;
    for (const CutStroke& stroke : cut.strokes) {
        if (stroke.hand >= 0) continue;
        double length = 0;
        for (const CutElement& element : stroke.elements) length += element.length;
        torn.push_back({length, {std::max(0.0, stroke.begin - 0.5), stroke.end + 0.5}});
    }
    Figure figure;
    figure.value = 100.0 * std::max(0.0, divided) / plan.length;
    figure.evidence = worst_first(std::move(torn));
    return figure;
}

}  // namespace

// Long because: a table, one entry for each metric.
std::vector<Metric> cutting_metrics() {
    using D = Direction;
    using A = Aggregation;
    using E = EvidenceGrade;
    std::vector<Metric> metrics;
    const auto add = [&](Naming naming, D direction, A aggregation, const char* source, Wording wording,
                         Figure (*compute)(const Analysis&, const Selection&)) {
        MetricDescriptor d = describe(std::move(naming), direction, Scale::raw, aggregation, E::expert,
                                      source, std::move(wording));
        d.filter = no_filter;
        d.hands = Hands::either;
        d.needs_events = true;
        d.absent_means = AbsentMeans::failed;
        metrics.push_back({std::move(d), compute});
    };
    const char* const traction_source =
        "events cut_advance, cut_traction; the task's band, provisional: no traction limit is published";
    add({"traction_eff", QT_TRANSLATE_NOOP("fulcrum::metrics", "Cutting time under tension"), "%", 1},
        D::higher, A::share, traction_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the cutting time during which the tissue was held with the right "
                           "tension: slack tissue "
                           "does not open, tissue held too tightly tears."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "the tension was right for {value} of the cutting time, below the required {limit}"),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "before every stroke look whether the tissue is taut, and take a new hold when it is not")},
        traction_eff);
    add({"traction_eff_len", QT_TRANSLATE_NOOP("fulcrum::metrics", "Cut length under tension"), "%", 1},
        D::higher, A::share, traction_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the length of the cut that was made with the right tension."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "{value} of the cut was made with the right tension, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "stop cutting when the tissue goes slack, take a new hold, and continue")},
        traction_eff_len);
    const char* const line_source = "event cut_advance: position along and distance from the marked line";
    add({"cut_dev", QT_TRANSLATE_NOOP("fulcrum::metrics", "Area between line and cut"), "mm²", 1}, D::lower,
        A::total, line_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Area between the marked line and the cut that was made, all strokes together."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the area between cut and line was {value}, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "make short strokes and look at the line before each")},
        cut_dev);
    add({"cut_dev_max", QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest distance from the line"), "mm", 0.1},
        D::lower, A::maximum, line_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "Largest distance of the cut from the marked line."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the cut strayed {value} from the line, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "stop the stroke as soon as the blade leaves the line and start again on it")},
        cut_dev_max);
    add({"plane_dev", QT_TRANSLATE_NOOP("fulcrum::metrics", "Typical distance from the plane"), "mm", 0.1},
        D::lower, A::mean, line_source,
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "Distance of the cut from the intended plane, whichever side: half of the cut is nearer."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "half of the cut lay further than {value} from the plane, above the limit of {limit}"),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "apply traction until the plane opens, and follow the middle of the stretched fibres")},
        plane_dev);
    add({"plane_dev_median", QT_TRANSLATE_NOOP("fulcrum::metrics", "Side of the plane"), "mm", 0.1}, D::lower,
        A::mean, line_source,
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "Median of the signed distance of the cut from the intended plane: above 0 too deep, below too "
             "shallow."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the cut lay {value} to one side of the plane, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "aim for the middle of the stretched fibres, not for their edge")},
        plane_dev_median);
    metrics.back().descriptor.absolute_value = true;
    add({"plane_dev_p95", QT_TRANSLATE_NOOP("fulcrum::metrics", "Distance from the plane, 95th percentile"),
         "mm", 0.1},
        D::lower, A::mean, line_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Distance from the intended plane that 95 % of the cut keeps."),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "a twentieth of the cut lay further than {value} from the plane, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "stop when the plane is no longer clear and restore the tension first")},
        plane_dev_p95);
    add({"plane_deep", QT_TRANSLATE_NOOP("fulcrum::metrics", "Cut too deep"), "%", 1}, D::lower, A::share,
        line_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the length of the cut that is deeper than the tolerance allows: "
                           "towards what must be "
                           "spared."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "{value} of the cut was too deep, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "keep the blade on the side of the flap that you hold")},
        plane_deep);
    add({"plane_shallow", QT_TRANSLATE_NOOP("fulcrum::metrics", "Cut too shallow"), "%", 1}, D::lower,
        A::share, line_source,
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Share of the length of the cut that is shallower than the tolerance allows: "
                           "into what is taken "
                           "away."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "{value} of the cut was too shallow, above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "follow the plane, not the edge of the flap")},
        plane_shallow);
    add({"area_developed", QT_TRANSLATE_NOOP("fulcrum::metrics", "Line divided"), "%", 1}, D::higher,
        A::share, line_source,
        {QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "Share of the marked line that was divided with a blade. What tore is not divided, also where a "
             "blade trims it afterwards."),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "{value} of the line was divided, below the required {limit}"),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "apply less traction, and go back along the line and divide the bridges that are left")},
        area_developed);
    metrics.back().descriptor.version = 3;  // 2: what tore does not count; 3: nor once it is trimmed
    return metrics;
}

}  // namespace fulcrum
