// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/pathology_words.h"

#include <QCoreApplication>
#include <cmath>

#include "ui/language/language.h"
#include "ui/reports/report_texts.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString mm(double metres) {
    return decimal(metres * 1e3, 1);
}
QString mm(const std::optional<double>& metres) {
    return metres ? mm(*metres) : QStringLiteral("–");
}
QString percent(const std::optional<double>& share) {
    return share ? QString::number(std::round(100 * *share), 'f', 0) : QStringLiteral("–");
}

/// A length near a limit, in as many decimals as show on which side of it the length is.
QString near_limit(double metres, double limit) {
    for (int decimals = 1; decimals < 5; ++decimals) {
        const QString shown = decimal(metres * 1e3, decimals);
        if (shown != decimal(limit * 1e3, decimals) || metres == limit) return shown;
    }
    return decimal(metres * 1e3, 5);
}

QString reason_text(const PathologyReport& report, GradeReason reason) {
    switch (reason) {
        case GradeReason::nothing_cut:
            return ReportTexts::tr("nothing was cut");
        case GradeReason::undivided:
            return ReportTexts::tr("%1 % of the plane was divided; a grade needs %2 %")
                .arg(decimal(100 * report.divided, 1), percent(fully_divided_share));
        case GradeReason::intact:
            return ReportTexts::tr("no defect deeper than 5 mm, no coning");
        case GradeReason::defect:
            return ReportTexts::tr("a defect of %1 mm, deeper than 5 mm")
                .arg(near_limit(report.deepest_defect, deep_defect));
        case GradeReason::fat:
            return ReportTexts::tr("%1 % of the cut is more than 2 mm in the fat (limit %2 %)")
                .arg(decimal(100 * report.fat_share, 1), percent(fat_share_limit));
        case GradeReason::coning:
            return ReportTexts::tr("coning of %1 mm")
                .arg(near_limit(report.coning.value_or(0), coning_limit));
        case GradeReason::muscularis:
            return ReportTexts::tr("a defect down to the muscularis");
        case GradeReason::bulk_loss:
            return ReportTexts::tr("half of the cut is more than %1 mm in the fat")
                .arg(near_limit(report.median_fat_depth, bulk_loss_depth));
        case GradeReason::deep_coning:
            return ReportTexts::tr("coning of %1 mm, more than %2 mm")
                .arg(near_limit(report.coning.value_or(0), deep_coning_limit), mm(deep_coning_limit));
        case GradeReason::perforation:
            return ReportTexts::tr("the bowel was perforated");
    }
    return {};
}

QString grade_text(const PathologyReport& report) {
    return !report.grade        ? ReportTexts::tr("Not gradable")
           : *report.grade == 3 ? ReportTexts::tr("Grade 3, complete")
           : *report.grade == 2 ? ReportTexts::tr("Grade 2, nearly complete")
                                : ReportTexts::tr("Grade 1, incomplete");
}

QString reasons_text(const PathologyReport& report) {
    QStringList reasons;
    for (const GradeReason reason : report.reasons) reasons << reason_text(report, reason);
    return reasons.join(ReportTexts::tr("; "));
}

PathologyLine grade_line(const PathologyReport& report) {
    return {ReportTexts::tr("Mesorectum"),
            ReportTexts::tr("%1: %2.").arg(grade_text(report), reasons_text(report)),
            report.grade.value_or(0) < 3, -1};
}

PathologyLine coning_line(const PathologyReport& report) {
    PathologyLine line{ReportTexts::tr("Coning"), {}, false, -1};
    if (!report.coning) {
        line.words = ReportTexts::tr("Not assessed: fewer than three levels were at least half divided.");
        return line;
    }
    line.bad = *report.coning > coning_limit + resolution;
    const QString way =
        *report.coning >= 0 ? ReportTexts::tr("towards the rectum") : ReportTexts::tr("towards the sacrum");
    line.words = ReportTexts::tr(
                     "%1: from the first level to the last the cut moves %2 mm %3 (coning: more than %4 mm "
                     "towards the rectum).")
                     .arg(line.bad ? ReportTexts::tr("Yes") : ReportTexts::tr("None"),
                          mm(std::abs(*report.coning)), way, mm(coning_limit));
    return line;
}

Sector sector_at(const PathologyReport& report, double place) {
    const double third = report.plan.line / sector_count;
    return static_cast<Sector>(std::min(sector_count - 1, static_cast<int>(place / third)));
}

void add_defects(const PathologyReport& report, std::vector<PathologyLine>& lines) {
    if (report.defects.empty()) {
        lines.push_back({ReportTexts::tr("Defects"), ReportTexts::tr("None."), false, -1});
        return;
    }
    constexpr std::size_t shown = 5;  // the table has every sector's deepest
    for (std::size_t i = 0; i < std::min(shown, report.defects.size()); ++i) {
        const Defect& defect = report.defects[i];
        QString words =
            ReportTexts::tr("%1: %2 mm deep, %3 mm wide, at %4")
                .arg(place_text(defect.level, sector_at(report, 0.5 * (defect.from + defect.to))),
                     mm(defect.depth), mm(defect.to - defect.from), clock_text(defect.when.begin));
        if (defect.muscularis) words += ReportTexts::tr(", down to the muscularis");
        lines.push_back({i == 0 ? ReportTexts::tr("Defects") : QString(), words + QLatin1Char('.'),
                         defect.depth > deep_defect, defect.when.begin});
    }
    if (report.defects.size() > shown)
        lines.push_back(
            {{}, ReportTexts::tr("and %1 shallower ones.").arg(report.defects.size() - shown), false, -1});
}

PathologyLine circumferential_line(const PathologyReport& report) {
    PathologyLine line{ReportTexts::tr("Circumferential margin"), {}, false, -1};
    const Margin& margin = report.circumferential;
    if (margin.absence == MarginAbsence::no_tumour) {
        line.words = ReportTexts::tr("The case has no tumour.");
    } else if (!margin.distance) {
        line.words = ReportTexts::tr("Not given: the plane next to the tumour was not divided.");
        line.bad = true;
    } else {
        line.bad = margin_is_positive(margin);
        line.time = margin.when.begin;
        line.words = ReportTexts::tr(
                         "%1 mm, %2 (positive: 1 mm or less). Tumour at %3, its edge %4 mm outside the "
                         "muscularis.")
                         .arg(near_limit(*margin.distance, positive_margin),
                              line.bad ? ReportTexts::tr("positive") : ReportTexts::tr("negative"),
                              place_text(report.plan.tumour->level, report.plan.tumour->sector),
                              mm(report.plan.tumour->depth));
    }
    return line;
}

PathologyLine distal_line(const PathologyReport& report) {
    PathologyLine line{ReportTexts::tr("Distal margin"), {}, false, -1};
    const Margin& margin = report.distal;
    if (margin.absence == MarginAbsence::no_tumour) {
        line.words = ReportTexts::tr("The case has no tumour.");
    } else if (!margin.distance) {
        line.words = ReportTexts::tr(
            "No transection was done in this task, and the dissection did not reach below the tumour.");
        line.bad = true;
    } else {
        line.words =
            ReportTexts::tr(
                "No transection was done in this task: the distal margin is the distance from the tumour's "
                "lower edge to the lowest level that was divided from side to side, %1 mm (level %2).")
                .arg(mm(*margin.distance))
                .arg(report.lowest_level + 1);
    }
    return line;
}

QStringList row_of(const QString& level, const QString& sector, double divided, const PlaneDeviation& plane,
                   double defect) {
    return {level,
            sector,
            percent(divided),
            mm(plane.median),
            mm(plane.p95),
            mm(plane.worst),
            percent(plane.in_plane),
            percent(plane.too_deep),
            percent(plane.too_shallow),
            mm(defect)};
}

}  // namespace

QString sector_text(Sector sector) {
    switch (sector) {
        case Sector::right:
            return ReportTexts::tr("right");
        case Sector::mid:
            return ReportTexts::tr("midline");
        case Sector::left:
            return ReportTexts::tr("left");
    }
    return {};
}

QString place_text(int level, Sector sector) {
    return ReportTexts::tr("level %1, %2").arg(level + 1).arg(sector_text(sector));
}

std::vector<PathologyLine> pathology_lines(const PathologyReport& report) {
    std::vector<PathologyLine> lines;
    lines.push_back(
        {ReportTexts::tr("Specimen"),
         ReportTexts::tr("Rectum in its mesorectal envelope, posterior sector, %1 levels; %2 % of the plane "
                         "divided, not transected.")
             .arg(report.plan.levels)
             .arg(percent(report.divided)),
         false, -1});
    lines.push_back(grade_line(report));
    lines.push_back(coning_line(report));
    add_defects(report, lines);
    lines.push_back(circumferential_line(report));
    lines.push_back(distal_line(report));
    return lines;
}

std::vector<PathologyLabel> pathology_labels(const PathologyReport& report) {
    std::vector<PathologyLabel> labels;
    labels.push_back({ReportTexts::tr("Mesorectum"), grade_text(report), reasons_text(report),
                      report.grade.value_or(0) < 3});
    labels.push_back({ReportTexts::tr("Plane divided"),
                      ReportTexts::tr("%1 %").arg(percent(report.divided)),
                      {},
                      report.divided < fully_divided_share - 1e-9});
    const Margin& round = report.circumferential;
    PathologyLabel around{ReportTexts::tr("Circumferential margin"), {}, {}, false};
    PathologyLabel below{ReportTexts::tr("Distal margin"), {}, {}, false};
    if (round.absence == MarginAbsence::no_tumour) {
        around.value = below.value = ReportTexts::tr("no tumour");
    } else {
        around.value = round.distance ? ReportTexts::tr("%1 mm, %2")
                                            .arg(near_limit(*round.distance, positive_margin),
                                                 margin_is_positive(round) ? ReportTexts::tr("positive")
                                                                           : ReportTexts::tr("negative"))
                                      : ReportTexts::tr("not given");
        if (!round.distance) around.why = ReportTexts::tr("the plane next to the tumour was not divided");
        around.bad = !round.distance || margin_is_positive(round);
        below.value = report.distal.distance ? ReportTexts::tr("%1 mm").arg(mm(*report.distal.distance))
                                             : ReportTexts::tr("not given");
        if (!report.distal.distance)
            below.why = ReportTexts::tr("the dissection did not reach below the tumour");
        below.bad = !report.distal.distance;
    }
    labels.push_back(std::move(around));
    labels.push_back(std::move(below));
    return labels;
}

QString sector_words(const PathologyReport& report, const SectorFinding& finding) {
    const QString place = place_text(finding.level, finding.sector);
    if (!finding.plane.p95)
        return ReportTexts::tr("%1: not divided.").arg(place.left(1).toUpper() + place.mid(1));
    const PlaneDeviation& plane = finding.plane;
    QString words = ReportTexts::tr(
                        "%1: %2 % divided. Distance from the plane: median %3 mm, 95th percentile %4 mm; "
                        "%5 % of the cut within %6 mm of the plane, %7 % too deep (towards the sacrum), %8 % "
                        "too shallow (into the mesorectum).")
                        .arg(place.left(1).toUpper() + place.mid(1), percent(finding.divided),
                             mm(plane.median), mm(plane.p95), percent(plane.in_plane),
                             mm(report.plan.tolerance), percent(plane.too_deep), percent(plane.too_shallow));
    if (finding.defect > least_defect)
        words += ReportTexts::tr(" Deepest defect %1 mm.").arg(mm(finding.defect));
    return words;
}

QStringList pathology_columns() {
    return {ReportTexts::tr("Level"),      ReportTexts::tr("Sector"),  ReportTexts::tr("Divided %"),
            ReportTexts::tr("Median mm"),  ReportTexts::tr("95th mm"), ReportTexts::tr("Worst mm"),
            ReportTexts::tr("In plane %"), ReportTexts::tr("Deep %"),  ReportTexts::tr("Shallow %"),
            ReportTexts::tr("Defect mm")};
}

std::vector<QStringList> pathology_rows(const PathologyReport& report) {
    std::vector<QStringList> rows;
    for (const SectorFinding& finding : report.findings)
        rows.push_back(row_of(QString::number(finding.level + 1), sector_text(finding.sector),
                              finding.divided, finding.plane, finding.defect));
    for (const SectorFinding& finding : report.sectors)
        rows.push_back(row_of(ReportTexts::tr("all"), sector_text(finding.sector), finding.divided,
                              finding.plane, finding.defect));
    rows.push_back(row_of(ReportTexts::tr("all"), ReportTexts::tr("all"), report.divided, report.plane,
                          report.deepest_defect));
    return rows;
}

QString pathology_legend(const PathologyReport& report) {
    QString legend =
        ReportTexts::tr(
            "Levels from cranial to caudal, sides of the patient. Distances of the cut from the intended "
            "plane: median and 95th percentile of their size; the worst is positive towards the sacrum "
            "(too "
            "deep), negative into the mesorectum (too shallow); in plane within %1 mm. Simulated: from the "
            "cut surface of this attempt at rest.")
            .arg(mm(report.plan.tolerance));
    const QString asked = mm(report.plan.asked_length()), whole = mm(report.plan.levels * report.plan.line);
    if (asked != whole)
        legend += ReportTexts::tr(" The task asks for %1 of %2 mm of the line; shares divided are of that.")
                      .arg(asked, whole);
    return legend;
}

}  // namespace fulcrum::ui
