// SPDX-License-Identifier: Apache-2.0
// Values of the pathology report as metrics: grade, margins, deepest defect, distance from the plane by
// sector.
#include "assessment/metrics/analysis.h"
#include "assessment/metrics/descriptor_text.h"
#include "assessment/metrics/registry.h"
#include "assessment/pathology/pathology.h"
#include "assessment/trace/cut_strokes.h"

namespace fulcrum {

namespace {

constexpr double to_mm = 1e3;

/// The report, or the reason why there is none.
struct Finding {
    PathologyReport report;
    std::optional<Figure> absence;
};

Finding finding_of(const Analysis& analysis) {
    Finding finding;
    if (!analysis.context().specimen) {
        finding.absence = absent(Absence::not_measured, StatementId::no_specimen);
        return finding;
    }
    const Trace& trace = analysis.trace();
    finding.report =
        pathology_of_events(analysis.events(), trace.tick_period, trace.end, *analysis.context().specimen);
    if (!(finding.report.plane.length > 0))
        finding.absence = absent(Absence::not_done, StatementId::nothing_cut);
    return finding;
}

/// The deepest parts of the cut in the fat, the deepest first.
std::vector<TimeInterval> defect_times(const PathologyReport& report) {
    std::vector<TimeInterval> times;
    for (const Defect& defect : report.defects)
        times.push_back({std::max(0.0, defect.when.begin - 0.5), defect.when.end + 0.5});
    return times;
}

Figure tme_grade(const Analysis& analysis, const Selection& /*row*/) {
    const Finding finding = finding_of(analysis);
    if (finding.absence) return *finding.absence;
    if (!finding.report.grade)
        return absent(Absence::not_done,
                      {StatementId::specimen_undivided,
                       {{"percent", 100 * finding.report.divided}, {"least", 100 * fully_divided_share}}});
    Figure figure;
    figure.value = *finding.report.grade;
    figure.evidence = defect_times(finding.report);
    return figure;
}

Figure tme_defect(const Analysis& analysis, const Selection& /*row*/) {
    const Finding finding = finding_of(analysis);
    if (finding.absence) return *finding.absence;
    Figure figure;
    figure.value = finding.report.deepest_defect * to_mm;
    figure.evidence = defect_times(finding.report);
    return figure;
}

Figure margin(const Margin& margin, StatementId not_divided) {
    if (margin.absence == MarginAbsence::no_tumour)
        return absent(Absence::not_measured, StatementId::no_tumour);
    if (!margin.distance) return absent(Absence::not_done, not_divided);
    Figure figure;
    figure.value = *margin.distance * to_mm;
    return figure;
}

Figure crm_mm(const Analysis& analysis, const Selection& /*row*/) {
    const Finding finding = finding_of(analysis);
    if (finding.absence) return *finding.absence;
    Figure figure = margin(finding.report.circumferential, StatementId::tumour_plane_undivided);
    if (figure.value) {
        const TimeInterval& when = finding.report.circumferential.when;
        figure.evidence = {{std::max(0.0, when.begin - 0.5), when.end + 0.5}};
    }
    return figure;
}

Figure drm_mm(const Analysis& analysis, const Selection& /*row*/) {
    const Finding finding = finding_of(analysis);
    if (finding.absence) return *finding.absence;
    return margin(finding.report.distal, StatementId::not_beyond_tumour);
}

Figure plane_dev_in(const Analysis& analysis, Sector sector) {
    const Finding finding = finding_of(analysis);
    if (finding.absence) return *finding.absence;
    const PlaneDeviation& plane = finding.report.sectors[static_cast<std::size_t>(sector)].plane;
    if (!plane.median) return absent(Absence::not_done, StatementId::sector_uncut);
    Figure figure;
    figure.value = *plane.median * to_mm;
    return figure;
}
Figure plane_dev_right(const Analysis& analysis, const Selection& /*row*/) {
    return plane_dev_in(analysis, Sector::right);
}
Figure plane_dev_mid(const Analysis& analysis, const Selection& /*row*/) {
    return plane_dev_in(analysis, Sector::mid);
}
Figure plane_dev_left(const Analysis& analysis, const Selection& /*row*/) {
    return plane_dev_in(analysis, Sector::left);
}

}  // namespace

// Long because: a table, one entry for each metric.
std::vector<Metric> specimen_metrics() {
    using D = Direction;
    using A = Aggregation;
    std::vector<Metric> metrics;
    constexpr int of_asked_line = 3;  // 3: of the line as far as the task asks for it
    const auto add = [&](Naming naming, D direction, A aggregation, EvidenceGrade grade, const char* source,
                         Wording wording, Figure (*compute)(const Analysis&, const Selection&)) {
        MetricDescriptor d = describe(std::move(naming), direction, Scale::raw, aggregation, grade, source,
                                      std::move(wording));
        d.version = 2;  // 2: graded only where the line is divided; bulk loss, fat and perforation count
        d.filter = no_filter;
        d.hands = Hands::either;
        d.needs_events = true;
        d.absent_means = AbsentMeans::failed;
        metrics.push_back({std::move(d), compute});
    };
    add({"tme_grade", QT_TRANSLATE_NOOP("fulcrum::metrics", "Mesorectal grade"), "-", 1}, D::higher, A::grade,
        EvidenceGrade::moderate,
        "Quirke: 3 complete (no defect deeper than 5 mm, no coning), 2 nearly complete, 1 down to the "
        "muscularis; limits for fat, bulk loss and coning are this program's; from event cut_advance",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Grade that a pathologist would give the specimen: 3 complete, 2 nearly complete, "
                           "1 incomplete."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the specimen is of grade {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "stay on the shiny surface of the mesorectum and stop as soon as fat shows in "
                           "front of the blade")},
        tme_grade);
    metrics.back().descriptor.version = of_asked_line;
    add({"tme_defect", QT_TRANSLATE_NOOP("fulcrum::metrics", "Deepest defect of the mesorectum"), "mm", 0.1},
        D::lower, A::maximum, EvidenceGrade::moderate,
        "event cut_advance: distance beyond the areolar layer, into the fat",
        {QT_TRANSLATE_NOOP("fulcrum::metrics", "How deep the cut went into the fat that should stay intact."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the cut went {value} into the fat, above the limit of {limit}"),
         QT_TRANSLATE_NOOP(
             "fulcrum::metrics",
             "keep the blade in the white fibres; where you see yellow you are too close to the rectum")},
        tme_defect);
    add({"crm_mm", QT_TRANSLATE_NOOP("fulcrum::metrics", "Circumferential margin"), "mm", 0.1}, D::higher,
        A::minimum, EvidenceGrade::strong,
        "least distance of the cut to the tumour's edge; positive at 1 mm or less",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Least distance between the cut and the edge of the tumour. At 1 mm or less the "
                           "margin is positive."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the cut passed the tumour at {value}, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "know where the tumour is and keep to the plane next to it")},
        crm_mm);
    metrics.back().descriptor.version = of_asked_line;
    add({"drm_mm", QT_TRANSLATE_NOOP("fulcrum::metrics", "Distal reach below the tumour"), "mm", 1},
        D::higher, A::maximum, EvidenceGrade::moderate,
        "tumour's lower edge to the lowest level fully divided; nothing is transected",
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "How far below the tumour the dissection reached: the distal margin that a "
                           "transection there would "
                           "leave."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "the dissection reached {value} below the tumour, below the required {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "divide every level from side to side before you go deeper, down to the levator")},
        drm_mm);
    metrics.back().descriptor.version = of_asked_line;
    const char* const sector_source = "event cut_advance, in this third of every level";
    const auto add_sector = [&](Naming naming, Wording wording,
                                Figure (*compute)(const Analysis&, const Selection&)) {
        add(std::move(naming), D::lower, A::mean, EvidenceGrade::expert, sector_source, std::move(wording),
            compute);
    };
    add_sector({"plane_dev_right", QT_TRANSLATE_NOOP("fulcrum::metrics", "Distance from the plane, right"),
                "mm", 0.1},
               {QT_TRANSLATE_NOOP("fulcrum::metrics",
                                  "Distance of the cut from the intended plane on the patient's right, "
                                  "whichever side: half of the cut is nearer."),
                QT_TRANSLATE_NOOP("fulcrum::metrics",
                                  "on the patient's right half of the cut lay further than {value} from the "
                                  "plane, above the limit of {limit}"),
                QT_TRANSLATE_NOOP("fulcrum::metrics",
                                  "restore the tension on the patient's right before you cut there")},
               plane_dev_right);
    add_sector(
        {"plane_dev_mid", QT_TRANSLATE_NOOP("fulcrum::metrics", "Distance from the plane, midline"), "mm",
         0.1},
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Distance of the cut from the intended plane in the midline, whichever side: half "
                           "of the cut is nearer."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "in the midline half of the cut lay further than {value} from the plane, above "
                           "the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics", "restore the tension in the midline before you cut there")},
        plane_dev_mid);
    add_sector(
        {"plane_dev_left", QT_TRANSLATE_NOOP("fulcrum::metrics", "Distance from the plane, left"), "mm", 0.1},
        {QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "Distance of the cut from the intended plane on the patient's left, whichever "
                           "side: half of the cut is nearer."),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "on the patient's left half of the cut lay further than {value} from the plane, "
                           "above the limit of {limit}"),
         QT_TRANSLATE_NOOP("fulcrum::metrics",
                           "restore the tension on the patient's left before you cut there")},
        plane_dev_left);
    return metrics;
}

}  // namespace fulcrum
