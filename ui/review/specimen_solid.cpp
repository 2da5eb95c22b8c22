// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/specimen_solid.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/reports/pathology_words.h"
#include "ui/reports/report_texts.h"
#include "ui/reports/specimen_map.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {
namespace {

constexpr double solid_pi = 3.14159265358979323846;
constexpr int steps_a_sector = 10, steps_in_front = 30;
constexpr double key_turn = 15 * solid_pi / 180, turn_a_pixel = 0.01, steepest = 1.2;
constexpr SolidPose first_pose{-0.35, 0.35};
constexpr double filled = 0.46;        // of the area, by the sphere around the specimen
constexpr double least_wall = 0.3;     // radius of the muscularis over that of the specimen
constexpr double defect_height = 0.6;  // of a level: its craniocaudal size is not known
constexpr double hatch_step = 6;       // pixels
constexpr double least_open = 0.005;   // share of a sector that is shown as undivided

QColor blend(const QColor& ground, const QColor& ink, double share) {
    const auto part = [share](double a, double b) { return a + (b - a) * share; };
    return QColor::fromRgbF(part(ground.redF(), ink.redF()), part(ground.greenF(), ink.greenF()),
                            part(ground.blueF(), ink.blueF()));
}

/// A place on the specimen: `along` the marked line from the patient's right, 0 to 1 over the back half and
/// on to 2 over the front; `down` in levels from the cranial end; `radius` in m.
class SolidView {
  public:
    SolidView(const PathologyReport& report, const SolidPose& pose, const QRectF& area)
        : plan_(report.plan),
          pose_(pose),
          centre_(area.center()),
          radius_(report.plan.line / solid_pi),
          length_(report.plan.levels * report.plan.spacing) {
        const double around = std::hypot(0.5 * length_, radius_);
        scale_ = around > 0 ? filled * std::min(area.width(), area.height()) / around : 0;
    }
    bool drawable() const { return plan_.levels > 0 && radius_ > 0 && length_ > 0 && scale_ > 0; }
    double radius() const { return radius_; }
    double wall() const { return std::max(least_wall * radius_, radius_ + plan_.plane - plan_.fat); }
    /// Radius at which something lies that is so deep in the fat.
    double at_depth(double depth) const {
        return std::max(wall(), radius_ + plan_.plane - plan_.areolar - depth);
    }
    QPointF at(double along, double down, double radius) const {
        // From behind the patient's right is on the right.
        const double angle = (0.5 - along) * solid_pi + pose_.yaw;
        const double x = radius * std::sin(angle), near = radius * std::cos(angle);
        const double z = 0.5 * length_ - down * plan_.spacing;
        const double up = z * std::cos(pose_.pitch) - near * std::sin(pose_.pitch);
        return centre_ + scale_ * QPointF(x, -up);
    }
    /// To the right of the specimen, at the height of its axis.
    QPointF right_of(double down) const {
        const double z = 0.5 * length_ - down * plan_.spacing;
        return centre_ + scale_ * QPointF(radius_, -z * std::cos(pose_.pitch));
    }
    bool faces(double along) const { return std::cos((0.5 - along) * solid_pi + pose_.yaw) > 0; }
    bool from_above() const { return pose_.pitch >= 0; }
    /// The part of a stretch that faces the viewer, in strips; empty where none does.
    QPolygonF patch(double from, double to, double top, double bottom, double radius, int steps) const {
        std::vector<double> seen;
        for (int i = 0; i <= steps; ++i) {
            const double along = from + (to - from) * i / steps;
            if (faces(along)) seen.push_back(along);
        }
        if (seen.size() < 2) return {};
        QPolygonF outline;
        for (const double along : seen) outline << at(along, top, radius);
        for (auto along = seen.rbegin(); along != seen.rend(); ++along) outline << at(*along, bottom, radius);
        return outline;
    }
    QPolygonF ring(double down, double radius) const {
        QPolygonF outline;
        for (int i = 0; i < 2 * steps_in_front; ++i) outline << at(i / double(steps_in_front), down, radius);
        return outline;
    }

  private:
    const SpecimenPlan& plan_;
    SolidPose pose_;
    QPointF centre_;
    double radius_, length_, scale_ = 0;
};

QPolygonF sector_patch(const SolidView& view, const SectorFinding& finding, double top, double bottom) {
    const double from = static_cast<double>(finding.sector) / sector_count;
    return view.patch(from, from + 1.0 / sector_count, finding.level + top, finding.level + bottom,
                      view.radius(), steps_a_sector);
}

/// Draws the parts of one picture, from the back to the front.
class SolidPainter {
  public:
    SolidPainter(QPainter& painter, const PathologyReport& report, const SolidView& view)
        : painter_(painter), report_(report), view_(view), palette_(colours()) {}
    void front();
    void sectors(int chosen);
    void defects();
    void tumour();
    void ends();
    void names();

  private:
    void hatched(const QPolygonF& strip);
    void sign(const QPolygonF& face, const SectorFinding& finding);
    QColor fat() const { return blend(palette_.card, palette_.warning, 0.28); }

    QPainter& painter_;
    const PathologyReport& report_;
    const SolidView& view_;
    const Palette& palette_;
};

void SolidPainter::front() {
    // Not dissected here, and not judged.
    const QPolygonF face = view_.patch(1, 2, 0, report_.plan.levels, view_.radius(), steps_in_front);
    painter_.setPen(QPen(palette_.muted, 1));
    painter_.setBrush(blend(palette_.card, palette_.muted, 0.22));
    painter_.drawPolygon(face);
}

void SolidPainter::hatched(const QPolygonF& strip) {
    painter_.save();
    QPainterPath path;
    path.addPolygon(strip);
    painter_.setClipPath(path, Qt::IntersectClip);
    painter_.fillPath(path, palette_.card);
    painter_.setPen(QPen(blend(palette_.card, palette_.text, 0.55), 1.2));
    const QRectF box = strip.boundingRect();
    for (double x = box.left() - box.height(); x < box.right(); x += hatch_step)
        painter_.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    painter_.restore();
}

void SolidPainter::sign(const QPolygonF& face, const SectorFinding& finding) {
    const QString words = deviation_sign(deviation_of(finding, report_.plan.tolerance));
    const QRectF box = face.boundingRect();
    if (words.isEmpty() || box.width() < painter_.fontMetrics().horizontalAdvance(words) + 8) return;
    painter_.setPen(palette_.text);
    painter_.drawText(box.adjusted(0, 3, 0, 0), Qt::AlignHCenter | Qt::AlignTop, words);
}

void SolidPainter::sectors(int chosen) {
    QPolygonF outlined;
    for (std::size_t i = 0; i < report_.findings.size(); ++i) {
        const SectorFinding& finding = report_.findings[i];
        const QPolygonF face = sector_patch(view_, finding, 0, 1);
        if (face.isEmpty()) continue;
        painter_.setPen(QPen(palette_.card, 2));
        painter_.setBrush(deviation_colour(deviation_of(finding, report_.plan.tolerance), palette_));
        painter_.drawPolygon(face);
        const double open = 1 - std::clamp(finding.divided, 0.0, 1.0);
        if (open > least_open) hatched(sector_patch(view_, finding, 0, open));
        sign(face, finding);
        if (static_cast<int>(i) == chosen) outlined = face;
    }
    const QPolygonF all = view_.patch(0, 1, 0, report_.plan.levels, view_.radius(), 3 * steps_a_sector);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(palette_.muted, 1));
    painter_.drawPolygon(all);
    if (outlined.isEmpty()) return;
    painter_.setPen(QPen(palette_.accent, 3));
    painter_.drawPolygon(outlined);
}

void SolidPainter::defects() {
    for (auto defect = report_.defects.rbegin(); defect != report_.defects.rend(); ++defect) {
        if (defect->level < 0 || defect->level >= report_.plan.levels) continue;
        const double from = defect->from / report_.plan.line, to = defect->to / report_.plan.line;
        const double middle = defect->level + 0.5;
        const double top = middle - 0.5 * defect_height, bottom = middle + 0.5 * defect_height;
        const QPolygonF rim = view_.patch(from, to, top, bottom, view_.radius(), steps_a_sector);
        if (rim.isEmpty()) continue;
        const bool bad = defect->depth > deep_defect + resolution || defect->muscularis;
        const QColor wall = bad ? palette_.bad : blend(palette_.card, palette_.text, 0.3);
        painter_.save();
        QPainterPath opening;
        opening.addPolygon(rim);
        painter_.fillPath(opening, wall);
        // The floor is further in: it moves against the rim when the specimen is turned.
        painter_.setClipPath(opening, Qt::IntersectClip);
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(blend(wall, palette_.text, 0.35));
        painter_.drawPolygon(
            view_.patch(from, to, top, bottom, view_.at_depth(defect->depth), steps_a_sector));
        painter_.restore();
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(QPen(palette_.text, 1.2));
        painter_.drawPolygon(rim);
    }
}

void SolidPainter::tumour() {
    if (!report_.plan.tumour) return;
    const Tumour& tumour = *report_.plan.tumour;
    const double half =
        report_.plan.spacing > 0 ? std::min(0.5, 0.5 * tumour.length / report_.plan.spacing) : 0.5;
    const double from = static_cast<double>(tumour.sector) / sector_count;
    const QPolygonF place =
        view_.patch(from + 0.03, from + 1.0 / sector_count - 0.03, tumour.level + 0.5 - half,
                    tumour.level + 0.5 + half, view_.radius(), steps_a_sector);
    if (place.isEmpty()) return;
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(palette_.text, 1.6, Qt::DashLine));
    painter_.drawPolygon(place);
}

void SolidPainter::ends() {
    const double down = view_.from_above() ? 0 : report_.plan.levels;
    painter_.setPen(QPen(palette_.muted, 1));
    painter_.setBrush(fat());
    painter_.drawPolygon(view_.ring(down, view_.radius()));
    painter_.setBrush(blend(palette_.card, palette_.bad, 0.35));
    painter_.drawPolygon(view_.ring(down, view_.wall()));
    painter_.setBrush(blend(palette_.card, palette_.text, 0.7));
    painter_.drawPolygon(view_.ring(down, 0.6 * view_.wall()));
}

void SolidPainter::names() {
    painter_.setPen(palette_.muted);
    const double line = painter_.fontMetrics().height();
    const auto name = [&](double down, const QString& words) {
        const QPointF place = view_.right_of(down);
        painter_.drawText(QRectF(place.x() + 8, place.y() - 0.5 * line, 1e4, line),
                          Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, words);
    };
    name(0, ReportTexts::tr("cranial"));
    name(report_.plan.levels, ReportTexts::tr("caudal"));
}

/// What the picture says of where one looks from.
struct SolidTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::SolidTexts)
};

QString side_words(const SolidPose& pose) {
    const double turned = std::remainder(pose.yaw, 2 * solid_pi);
    if (std::abs(turned) < 0.25 * solid_pi) return SolidTexts::tr("from behind");
    if (std::abs(turned) > 0.75 * solid_pi) return SolidTexts::tr("from the front (not judged)");
    return turned < 0 ? SolidTexts::tr("from the patient's right")
                      : SolidTexts::tr("from the patient's left");
}

}  // namespace

std::vector<SolidFace> facing_sectors(const PathologyReport& report, const SolidPose& pose,
                                      const QRectF& area) {
    std::vector<SolidFace> faces;
    const SolidView view(report, pose, area);
    if (!view.drawable()) return faces;
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        QPolygonF outline = sector_patch(view, report.findings[i], 0, 1);
        if (!outline.isEmpty()) faces.push_back({std::move(outline), static_cast<int>(i)});
    }
    return faces;
}

SpecimenSolid::SpecimenSolid(QWidget* parent) : QWidget(parent), pose_(first_pose) {
    setObjectName(QStringLiteral("specimen_solid"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Specimen in three dimensions"));
    turned();
}

void SpecimenSolid::open(const PathologyReport& report) {
    report_ = report;
    chosen_ = -1;
    pose_ = first_pose;
    turned();
}

void SpecimenSolid::choose(int finding) {
    chosen_ = finding;
    update();
}

QRectF SpecimenSolid::area() const {
    const double line = fontMetrics().height() + 4;
    return QRectF(rect()).adjusted(0, line, 0, -line);
}

void SpecimenSolid::turn(double yaw, double pitch) {
    pose_.yaw = std::remainder(pose_.yaw + yaw, 2 * solid_pi);
    pose_.pitch = std::clamp(pose_.pitch + pitch, -steepest, steepest);
    turned();
}

void SpecimenSolid::turned() {
    setAccessibleDescription(tr("Seen %1. Arrow keys turn it, Home turns it back.").arg(side_words(pose_)));
    update();
}

void SpecimenSolid::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& p = colours();
    const SolidView view(report_, pose_, area());
    if (view.drawable()) {
        SolidPainter solid(painter, report_, view);
        solid.front();
        solid.sectors(chosen_);
        solid.tumour();
        solid.defects();
        solid.ends();
        solid.names();
    }
    painter.setPen(p.muted);
    painter.drawText(rect().adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignTop,
                     tr("seen %1").arg(side_words(pose_)));
    painter.drawText(rect().adjusted(6, 4, -6, -4), Qt::AlignLeft | Qt::AlignBottom,
                     tr("drag or use the arrow keys to turn it"));
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(p.accent, 2, Qt::DashLine));
    painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

void SpecimenSolid::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    last_ = event->pos();
    dragged_ = false;
}

void SpecimenSolid::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0) return;
    const QPoint by = event->pos() - last_;
    if (!dragged_ && by.manhattanLength() < 4) return;
    dragged_ = true;
    last_ = event->pos();
    turn(turn_a_pixel * by.x(), turn_a_pixel * by.y());
}

void SpecimenSolid::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || dragged_) return;
    for (const SolidFace& face : facing_sectors(report_, pose_, area())) {
        if (!face.outline.containsPoint(event->localPos(), Qt::OddEvenFill)) continue;
        choose(face.finding);
        emit sector_chosen(face.finding);
    }
}

void SpecimenSolid::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            turn(-key_turn, 0);
            break;
        case Qt::Key_Right:
            turn(key_turn, 0);
            break;
        case Qt::Key_Up:
            turn(0, -key_turn);
            break;
        case Qt::Key_Down:
            turn(0, key_turn);
            break;
        case Qt::Key_Home:
            pose_ = first_pose;
            turned();
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void SpecimenSolid::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void SpecimenSolid::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace fulcrum::ui

#include "moc_specimen_solid.cpp"
