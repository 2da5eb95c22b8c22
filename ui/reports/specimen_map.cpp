// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/specimen_map.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/language/language.h"
#include "ui/reports/pathology_words.h"
#include "ui/reports/report_texts.h"

namespace fulcrum::ui {
namespace {

constexpr double row_lines = 3.0;        // height of a level, in lines of text
constexpr double side_lines = 34;        // a map at least as wide has its labels on the right
constexpr double grid_share = 0.58;      // of the width, with labels on the right
constexpr double widest_lines = 30;      // of the grid
constexpr double hatch_spacing = 6;      // pixels
constexpr double least_hatched = 0.005;  // share of a sector

QColor mixed(const QColor& ground, const QColor& ink, double share) {
    const auto part = [share](double a, double b) { return a + (b - a) * share; };
    return QColor::fromRgbF(part(ground.redF(), ink.redF()), part(ground.greenF(), ink.greenF()),
                            part(ground.blueF(), ink.blueF()));
}

QString mm(double metres) {
    return with_decimal_sign(QString::number(metres * 1e3, 'g', 3));
}

/// Whether there are levels and sectors to draw.
bool has_map(const PathologyReport& report) {
    const SpecimenPlan& plan = report.plan;
    return plan.levels > 0 && plan.line > 0 && !report.findings.empty();
}

/// The grid's room for its heads.
struct Heads {
    double left = 0, top = 0;
};
Heads heads_of(const PathologyReport& report, const QFontMetricsF& metrics, double unit) {
    double widest = std::max(metrics.horizontalAdvance(ReportTexts::tr("cranial")),
                             metrics.horizontalAdvance(ReportTexts::tr("caudal")));
    for (int level = 0; level < report.plan.levels; ++level)
        widest = std::max(widest, metrics.horizontalAdvance(ReportTexts::tr("level %1").arg(level + 1)));
    return {widest + 8 * unit, metrics.height() + 4 * unit};
}

struct LegendEntry {
    SectorDeviation deviation;
    QString words;
};
std::vector<LegendEntry> legend_of(const PathologyReport& report) {
    const double tolerance = report.plan.tolerance;
    const QString within = ReportTexts::tr("to %1").arg(mm(0.5 * tolerance));
    const QString near = ReportTexts::tr("to %1").arg(mm(tolerance));
    const QString out = ReportTexts::tr("to %1").arg(mm(2 * tolerance));
    const QString far = ReportTexts::tr("> %1").arg(mm(2 * tolerance));
    return {{{DeviationStep::far_outside, true}, far},  {{DeviationStep::outside, true}, out},
            {{DeviationStep::near_limit, true}, near},  {{DeviationStep::in_plane, false}, within},
            {{DeviationStep::near_limit, false}, near}, {{DeviationStep::outside, false}, out},
            {{DeviationStep::far_outside, false}, far}};
}

double wrapped_height(const QFontMetricsF& metrics, double width, const QString& words) {
    if (words.isEmpty()) return 0;
    return metrics.boundingRect(QRectF(0, 0, width, 1e6), Qt::TextWordWrap, words).height();
}

QString label_line(const PathologyLabel& label) {
    return (label.bad ? QStringLiteral("✕ ") : QStringLiteral("✓ ")) + label.value;
}

double labels_height(const PathologyReport& report, double width, const QFontMetricsF& metrics, double unit) {
    double height = 0;
    // The value is bold, a little wider than the metrics say.
    for (const PathologyLabel& label : pathology_labels(report))
        height += wrapped_height(metrics, width, label.title) +
                  wrapped_height(metrics, width * 0.88, label_line(label)) +
                  wrapped_height(metrics, width, label.why) + 8 * unit;
    return height;
}

QString colour_words() {
    return ReportTexts::tr(
        "Colour: 95 % of the sector's cut is no further from the plane (mm). ▼ towards the sacrum, too "
        "deep. ▲ into the mesorectum, too shallow. Hatched: not divided. Notches: defects in the fat, "
        "with their depth (mm).");
}

/// Lines at 45° over a rectangle; a brush pattern would have the size of the paper's dots.
void hatch(QPainter& painter, const QRectF& area, const QColor& ink, double unit) {
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.setPen(QPen(ink, 1.2 * unit));
    const double step = hatch_spacing * unit;
    for (double x = area.left() - area.height(); x < area.right(); x += step)
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x + area.height(), area.top()));
    painter.restore();
}

/// Draws the parts of one map.
class MapPainter {
  public:
    MapPainter(QPainter& painter, const PathologyReport& report, const Palette& palette,
               SpecimenMapLayout layout, double unit)
        : painter_(painter),
          report_(report),
          palette_(palette),
          layout_(std::move(layout)),
          metrics_(painter.font(), painter.device()),
          unit_(unit) {}
    void heads();
    void sectors();
    void defects();
    void tumour();
    void labels();
    void legend();

  private:
    double at(int level, double share) const {
        return layout_.grid.top() + layout_.grid.height() * (level + share) / report_.plan.levels;
    }
    void signs(const QRectF& cell, const SectorDeviation& deviation);
    QColor ink() const { return mixed(palette_.card, palette_.text, 0.55); }

    QPainter& painter_;
    const PathologyReport& report_;
    const Palette& palette_;
    SpecimenMapLayout layout_;
    QFontMetricsF metrics_;
    double unit_;
};

void MapPainter::heads() {
    const double line = metrics_.height();
    painter_.setPen(palette_.muted);
    for (int sector = 0; sector < sector_count; ++sector) {
        const double width = layout_.grid.width() / sector_count;
        painter_.drawText(QRectF(layout_.grid.left() + sector * width, 0, width, line), Qt::AlignCenter,
                          sector_text(static_cast<Sector>(sector)));
    }
    for (int level = 0; level < report_.plan.levels; ++level) {
        const QRectF room(0, at(level, 0), layout_.grid.left() - 8 * unit_, at(level, 1) - at(level, 0));
        painter_.drawText(room, Qt::AlignRight | Qt::AlignVCenter,
                          ReportTexts::tr("level %1").arg(level + 1));
        const bool first = level == 0, last = level + 1 == report_.plan.levels;
        if (first && !last)
            painter_.drawText(room, Qt::AlignRight | Qt::AlignTop, ReportTexts::tr("cranial"));
        if (last && !first)
            painter_.drawText(room, Qt::AlignRight | Qt::AlignBottom, ReportTexts::tr("caudal"));
    }
}

void MapPainter::signs(const QRectF& cell, const SectorDeviation& deviation) {
    const QString sign = deviation_sign(deviation);
    if (sign.isEmpty()) return;
    painter_.setPen(palette_.text);
    painter_.drawText(cell.adjusted(6 * unit_, 3 * unit_, -6 * unit_, 0), Qt::AlignRight | Qt::AlignTop,
                      sign);
}

void MapPainter::sectors() {
    for (std::size_t i = 0; i < layout_.cells.size(); ++i) {
        const SectorFinding& finding = report_.findings[i];
        const QRectF& cell = layout_.cells[i];
        const SectorDeviation deviation = deviation_of(finding, report_.plan.tolerance);
        painter_.fillRect(cell, deviation_colour(deviation, palette_));
        const double open = 1 - std::clamp(finding.divided, 0.0, 1.0);
        if (open > least_hatched) {
            const QRectF strip(cell.left(), cell.top(), cell.width(), cell.height() * open);
            painter_.fillRect(strip, palette_.card);
            hatch(painter_, strip, ink(), unit_);
        }
        signs(cell, deviation);
        painter_.setPen(QPen(palette_.card, 2 * unit_));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawRect(cell);
    }
    painter_.setPen(QPen(palette_.muted, unit_));
    painter_.drawRect(layout_.grid);
}

void MapPainter::defects() {
    const double fat = std::max(report_.plan.fat - report_.plan.areolar, 1e-9);
    std::vector<QRectF> labelled;
    painter_.save();
    painter_.setClipRect(layout_.grid.adjusted(-unit_, -unit_, unit_, unit_), Qt::IntersectClip);
    for (const Defect& defect : report_.defects) {
        if (defect.level < 0 || defect.level >= report_.plan.levels) continue;
        const double left = layout_.grid.left() + layout_.grid.width() * defect.from / report_.plan.line;
        const double right = layout_.grid.left() + layout_.grid.width() * defect.to / report_.plan.line;
        const double row = at(defect.level, 1) - at(defect.level, 0);
        const double deep = row * std::clamp(defect.depth / fat, 0.0, 1.0);
        const bool bad = defect.depth > deep_defect + resolution || defect.muscularis;
        QPainterPath notch;
        const double foot = at(defect.level, 1);
        notch.moveTo(left, foot);
        notch.quadTo(left + 0.15 * (right - left), foot - 1.15 * deep, 0.5 * (left + right), foot - deep);
        notch.quadTo(right - 0.15 * (right - left), foot - 1.15 * deep, right, foot);
        notch.closeSubpath();
        painter_.setPen(QPen(palette_.text, 1.2 * unit_));
        painter_.setBrush(bad ? palette_.bad : mixed(palette_.card, palette_.text, 0.3));
        painter_.drawPath(notch);
        const QString words = decimal(defect.depth * 1e3, 1);
        QRectF room(0, 0, metrics_.horizontalAdvance(words) + 6 * unit_, metrics_.height());
        room.moveCenter({0.5 * (left + right), foot - deep - 0.5 * metrics_.height() - 2 * unit_});
        if (room.top() < at(defect.level, 0)) room.moveTop(at(defect.level, 0));
        if (room.left() < layout_.grid.left()) room.moveLeft(layout_.grid.left());
        if (room.right() > layout_.grid.right()) room.moveRight(layout_.grid.right());
        const auto hit = [&](const QRectF& other) { return other.intersects(room); };
        if (std::any_of(labelled.begin(), labelled.end(), hit)) continue;  // the deepest comes first
        labelled.push_back(room);
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(palette_.card);
        painter_.drawRoundedRect(room, 3 * unit_, 3 * unit_);
        painter_.setPen(bad ? palette_.bad : palette_.text);
        painter_.drawText(room, Qt::AlignCenter, words);
    }
    painter_.restore();
}

void MapPainter::tumour() {
    if (!report_.plan.tumour) return;
    const Tumour& tumour = *report_.plan.tumour;
    const double width = layout_.grid.width() / sector_count;
    const double half =
        report_.plan.spacing > 0 ? std::min(0.5, 0.5 * tumour.length / report_.plan.spacing) : 0.5;
    const QRectF place(layout_.grid.left() + static_cast<int>(tumour.sector) * width,
                       at(tumour.level, 0.5 - half), width,
                       at(tumour.level, 0.5 + half) - at(tumour.level, 0.5 - half));
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(palette_.text, 1.6 * unit_, Qt::DashLine));
    painter_.drawRoundedRect(place.adjusted(5 * unit_, 0, -5 * unit_, 0), 10 * unit_, 10 * unit_);
    painter_.drawText(place.adjusted(14 * unit_, 2 * unit_, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                      ReportTexts::tr("tumour"));
}

void MapPainter::labels() {
    const QFont usual = painter_.font();
    QFont bold = usual;
    bold.setBold(true);
    QRectF room = layout_.labels;
    const auto line = [&](const QString& words, const QColor& ink, const QFont& font) {
        if (words.isEmpty()) return;
        painter_.setFont(font);
        painter_.setPen(ink);
        QRectF used;
        painter_.drawText(QRectF(room.left(), room.top(), room.width(), 1e6), Qt::TextWordWrap, words, &used);
        room.setTop(used.bottom());
    };
    for (const PathologyLabel& label : pathology_labels(report_)) {
        line(label.title, palette_.muted, usual);
        line(label_line(label), label.bad ? palette_.bad : palette_.text, bold);
        line(label.why, palette_.muted, usual);
        room.setTop(room.top() + 8 * unit_);
    }
    painter_.setFont(usual);
}

void MapPainter::legend() {
    const std::vector<LegendEntry> entries = legend_of(report_);
    const double width = layout_.legend.width() / static_cast<double>(entries.size());
    const double line = metrics_.height();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF box(layout_.legend.left() + static_cast<double>(i) * width, layout_.legend.top(), width,
                         line + 2 * unit_);
        painter_.fillRect(box, deviation_colour(entries[i].deviation, palette_));
        painter_.setPen(QPen(palette_.card, 2 * unit_));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawRect(box);
        painter_.setPen(palette_.text);
        painter_.drawText(box, Qt::AlignCenter, deviation_sign(entries[i].deviation));
        painter_.setPen(palette_.muted);
        painter_.drawText(box.translated(0, line + 3 * unit_), Qt::AlignCenter,
                          metrics_.elidedText(entries[i].words, Qt::ElideRight, width));
    }
    painter_.setPen(palette_.muted);
    painter_.drawText(QRectF(layout_.legend.left(), layout_.legend.top() + 2 * line + 8 * unit_,
                             layout_.legend.width(), 1e6),
                      Qt::TextWordWrap, colour_words());
}

}  // namespace

SectorDeviation deviation_of(const SectorFinding& finding, double tolerance) {
    const PlaneDeviation& plane = finding.plane;
    SectorDeviation deviation;
    if (!plane.p95) return deviation;
    const double deep = plane.too_deep.value_or(0), shallow = plane.too_shallow.value_or(0);
    deviation.deep = deep != shallow ? deep > shallow : plane.side.value_or(0) > 0;
    const double beyond = *plane.p95 - resolution;
    deviation.step = beyond <= 0.5 * tolerance ? DeviationStep::in_plane
                     : beyond <= tolerance     ? DeviationStep::near_limit
                     : beyond <= 2 * tolerance ? DeviationStep::outside
                                               : DeviationStep::far_outside;
    return deviation;
}

QColor deviation_colour(const SectorDeviation& deviation, const Palette& palette) {
    // Blue and orange of the data colours: all common colour vision deficiencies tell them apart.
    const QColor& ink = deviation.deep ? palette.left_hand : palette.right_hand;
    switch (deviation.step) {
        case DeviationStep::none:
            return palette.card;
        case DeviationStep::in_plane:
            return palette.raised;
        case DeviationStep::near_limit:
            return mixed(palette.raised, ink, 0.25);
        case DeviationStep::outside:
            return mixed(palette.raised, ink, 0.55);
        case DeviationStep::far_outside:
            return mixed(palette.raised, ink, 0.85);
    }
    return palette.card;
}

QString deviation_sign(const SectorDeviation& deviation) {
    const QString sign = deviation.deep ? QStringLiteral("▼") : QStringLiteral("▲");
    if (deviation.step == DeviationStep::outside) return sign;
    return deviation.step == DeviationStep::far_outside ? sign + sign : QString();
}

SpecimenMapLayout specimen_map_layout(const PathologyReport& report, double width,
                                      const QFontMetricsF& metrics, double unit, double least_grid) {
    SpecimenMapLayout layout;
    const double line = metrics.height();
    if (!has_map(report)) {
        layout.labels = QRectF(0, 0, width, labels_height(report, width, metrics, unit));
        layout.height = layout.labels.bottom();
        return layout;
    }
    const Heads heads = heads_of(report, metrics, unit);
    const bool side = width >= side_lines * line;
    const double room = (side ? grid_share * width : width) - heads.left - unit;
    const double grid_width = std::max(std::min(room, widest_lines * line), 3.0);
    const double row =
        std::max(row_lines * line, (least_grid * line - heads.top) / std::max(1, report.plan.levels));
    layout.grid = QRectF(heads.left, heads.top, grid_width, row * report.plan.levels);
    for (const SectorFinding& finding : report.findings) {
        const double w = layout.grid.width() / sector_count, h = row;
        layout.cells.emplace_back(layout.grid.left() + static_cast<int>(finding.sector) * w,
                                  layout.grid.top() + finding.level * h, w, h);
    }
    const double legend_top = layout.grid.bottom() + 8 * unit;
    layout.legend =
        QRectF(layout.grid.left(), legend_top, layout.grid.width(),
               2 * line + 8 * unit + wrapped_height(metrics, layout.grid.width(), colour_words()));
    if (side) {
        const double left = layout.grid.right() + 22 * unit;
        layout.labels = QRectF(left, 0, width - left, labels_height(report, width - left, metrics, unit));
    } else {
        layout.labels =
            QRectF(0, layout.legend.bottom() + 10 * unit, width, labels_height(report, width, metrics, unit));
    }
    layout.height = std::max(layout.legend.bottom(), layout.labels.bottom()) + 2 * unit;
    return layout;
}

void paint_specimen_map(QPainter& painter, const QPointF& top_left, double width,
                        const PathologyReport& report, const Palette& palette, double unit) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(top_left);
    const QFontMetricsF metrics(painter.font(), painter.device());
    MapPainter map(painter, report, palette, specimen_map_layout(report, width, metrics, unit), unit);
    if (has_map(report)) {
        map.heads();
        map.sectors();
        map.tumour();
        map.defects();
        map.legend();
    }
    map.labels();
    painter.restore();
}

void paint_around_specimen_map(QPainter& painter, double width, const PathologyReport& report,
                               const Palette& palette, double least_grid) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(painter.font(), painter.device());
    MapPainter map(painter, report, palette, specimen_map_layout(report, width, metrics, 1, least_grid), 1);
    if (has_map(report)) map.legend();
    map.labels();
    painter.restore();
}

}  // namespace fulcrum::ui
