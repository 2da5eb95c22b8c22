// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/standing_badge.h"

#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString say(const char* source, int count = -1) {
    return QCoreApplication::translate("fulcrum::ui::standing", source, nullptr, count);
}

QString classes_text(const std::vector<DeviceClass>& classes) {
    QStringList names;
    for (const DeviceClass one : classes) names << device_class_text(one);
    return names.join(QStringLiteral(", "));
}

QPainterPath tick(const QRectF& box) {
    QPainterPath path;
    path.moveTo(box.left() + 0.26 * box.width(), box.top() + 0.53 * box.height());
    path.lineTo(box.left() + 0.43 * box.width(), box.top() + 0.70 * box.height());
    path.lineTo(box.left() + 0.75 * box.width(), box.top() + 0.32 * box.height());
    return path;
}

void paint_padlock(QPainter& painter, const QRectF& box, const QColor& colour) {
    const QRectF body(box.left() + 0.2 * box.width(), box.top() + 0.46 * box.height(), 0.6 * box.width(),
                      0.44 * box.height());
    painter.setPen(QPen(colour, 0.09 * box.width()));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(QRectF(box.left() + 0.31 * box.width(), box.top() + 0.12 * box.height(),
                           0.38 * box.width(), 0.62 * box.height()),
                    0, 180 * 16);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(body, 0.06 * box.width(), 0.06 * box.width());
}

/// Yellow on white cannot be seen: the disc is filled, and rim and hands are dark in both themes.
void paint_clock(QPainter& painter, const QRectF& disc, double line, const Palette& p) {
    painter.setPen(QPen(current_theme() == Theme::light ? p.text : p.card, 0.8 * line, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(p.warning);
    painter.drawEllipse(disc);
    const QPointF centre = disc.center();
    painter.drawLine(centre, centre - QPointF(0, 0.33 * disc.height()));
    painter.drawLine(centre, centre + QPointF(0.24 * disc.width(), 0.12 * disc.height()));
}

/// A ring with three dots.
void paint_waiting(QPainter& painter, const QRectF& disc, const QPen& pen) {
    painter.setPen(pen);
    painter.drawEllipse(disc);
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen.color());
    const double dot = 0.08 * disc.width();
    for (const int place : {-1, 0, 1})
        painter.drawEllipse(disc.center() + QPointF(place * 0.24 * disc.width(), 0), dot, dot);
}

void paint_triangle(QPainter& painter, const QRectF& disc, const Palette& p) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.bad);
    painter.drawPolygon(QPolygonF({disc.topLeft(), disc.topRight(), {disc.center().x(), disc.bottom()}}));
}

/// A diamond at the corner: decided by an educator.
void paint_decision(QPainter& painter, const QRectF& box, double line, const Palette& p) {
    const double half = 0.19 * box.width();
    const QPointF centre(box.right() - half, box.bottom() - half);
    painter.setPen(QPen(p.card, 0.7 * line));
    painter.setBrush(p.accent);
    painter.drawPolygon(QPolygonF({centre - QPointF(0, half), centre + QPointF(half, 0),
                                   centre + QPointF(0, half), centre - QPointF(half, 0)}));
}

}  // namespace

void paint_standing(QPainter& painter, const QRectF& box, const TaskStanding& standing) {
    const Palette& p = colours();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = std::max(1.5, 0.085 * box.width());
    const QRectF disc = box.adjusted(1.6 * line, 1.6 * line, -1.6 * line, -1.6 * line);
    const auto pen = [&](const QColor& colour) {
        return QPen(colour, line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    painter.setBrush(Qt::NoBrush);
    switch (standing.standing) {
        case Standing::locked:
            paint_padlock(painter, box, p.muted);
            break;
        case Standing::open:
            painter.setPen(pen(p.accent));
            painter.drawEllipse(disc);
            break;
        case Standing::attempted:
            painter.setPen(pen(p.accent));
            painter.drawEllipse(disc);
            painter.setPen(Qt::NoPen);
            painter.setBrush(p.accent);
            painter.drawEllipse(disc.center(), 0.22 * disc.width(), 0.22 * disc.height());
            break;
        case Standing::passed: {
            QPen ring = pen(p.good);
            if (standing.provisional) ring.setDashPattern({1.5, 2});
            painter.setPen(ring);
            painter.drawEllipse(disc);
            painter.setPen(pen(p.good));
            painter.drawPath(tick(disc));
            break;
        }
        case Standing::awaiting_rating:
            paint_waiting(painter, disc, pen(p.good));
            break;
        case Standing::proficient:
        case Standing::maintained:
            painter.setPen(Qt::NoPen);
            painter.setBrush(p.good);
            painter.drawEllipse(disc);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(pen(p.card));
            painter.drawPath(tick(disc));
            if (standing.standing == Standing::maintained) {
                painter.setPen(QPen(p.good, 0.5 * line));
                painter.drawEllipse(disc.adjusted(-line, -line, line, line));
            }
            break;
        case Standing::due:
            paint_clock(painter, disc, line, p);
            break;
        case Standing::relapsed:
            paint_triangle(painter, disc, p);
            break;
    }
    if (standing.declared_by_decision()) paint_decision(painter, box, line, p);
    painter.restore();
}

void paint_unknown_standing(QPainter& painter, const QRectF& box) {
    painter.save();
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(0.85 * box.height())));
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(colours().muted);
    painter.drawText(box, Qt::AlignCenter, QStringLiteral("?"));
    painter.restore();
}

QString unknown_standing_name() {
    return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "not known here"));
}

QString date_text(std::int64_t utc_ms) {
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(utc_ms).date(),
                              say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "d MMM yyyy")));
}

namespace {

QString name_without_decision(const TaskStanding& standing) {
    if (standing.standing == Standing::passed && standing.provisional)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "passed (provisional)"));
    if (standing.standing == Standing::due && standing.overdue)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "check overdue"));
    return QCoreApplication::translate("fulcrum::standings", row_of(standing_names, standing.standing).title);
}

QString text_without_decision(const TaskStanding& standing) {
    switch (standing.standing) {
        case Standing::locked: {
            QStringList tasks;
            for (const std::string& task : standing.waits_for) tasks << text(task);
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "locked until proficient in %1"))
                .arg(tasks.join(QStringLiteral(", ")));
        }
        case Standing::open:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "open"));
        case Standing::attempted:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "attempted, not passed yet"));
        case Standing::passed:
            return standing.provisional
                       ? say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "passed (provisional)"))
                       : say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "passed"));
        case Standing::awaiting_rating:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "passed, awaiting rating"));
        case Standing::proficient:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "proficient since %1"))
                .arg(date_text(standing.declared_at));
        case Standing::maintained:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "proficient, last check passed"));
        case Standing::due:
            return (standing.overdue
                        ? say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "check overdue since %1"))
                        : say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "check due since %1")))
                .arg(date_text(standing.next_check));
        case Standing::relapsed:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "relapsed"));
    }
    return {};
}

/// What completes a check that is due, or restores proficiency.
QString check_detail(const TaskStanding& standing) {
    if (standing.standing == Standing::due) {
        if (standing.provisional)
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                         "Provisional limits, which judged your latest attempt, cannot "
                                         "complete the check. An educator can decide."));
        if (!standing.provisional_with.empty())
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                         "Pass twice on one day to complete the check. Provisional "
                                         "limits cannot complete it; passes with these count: %1."))
                .arg(classes_text(standing.firm_with));
        return say(
            QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Pass twice on one day to complete the check."));
    }
    if (standing.provisional)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                     "Provisional limits, which judged your latest attempt, cannot "
                                     "restore proficiency. An educator can decide."));
    if (!standing.provisional_with.empty())
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                     "Three passes in four attempts restore proficiency. Provisional "
                                     "limits cannot restore it; passes with these count: %1."))
            .arg(classes_text(standing.firm_with));
    return say(
        QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Three passes in four attempts restore proficiency."));
}

}  // namespace

QString standing_name(const TaskStanding& standing) {
    const QString name = name_without_decision(standing);
    return standing.declared_by_decision()
               ? say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "%1 (decision)")).arg(name)
               : name;
}

QString standing_text(const TaskStanding& standing) {
    const QString words = text_without_decision(standing);
    return standing.declared_by_decision()
               ? say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "%1, by decision of an educator")).arg(words)
               : words;
}

const char* standing_role(Standing standing) {
    switch (standing) {
        case Standing::passed:
        case Standing::awaiting_rating:
        case Standing::proficient:
        case Standing::maintained:
            return "good";
        case Standing::due:
            return "strong";
        case Standing::relapsed:
            return "bad";
        case Standing::locked:
        case Standing::open:
        case Standing::attempted:
            break;
    }
    return "neutral";
}

QString standing_detail(const TaskStanding& standing) {
    switch (standing.standing) {
        case Standing::locked:
        case Standing::open:
            return {};
        case Standing::attempted:
        case Standing::passed:
            break;
        case Standing::awaiting_rating:
            if (standing.rating_late)
                return say(QT_TRANSLATE_NOOP(
                               "fulcrum::ui::standing",
                               "Ratings of the attempt of %1 are missing (%2 of %3 are released): the "
                               "next pass that meets the rule is rated. An educator can decide."))
                    .arg(date_text(standing.rated_time), QString::number(standing.raters),
                         QString::number(standing.raters_needed));
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                         "Educators rate the attempt of %1: %2 of %3 ratings are released."))
                .arg(date_text(standing.rated_time), QString::number(standing.raters),
                     QString::number(standing.raters_needed));
        case Standing::proficient:
        case Standing::maintained:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Next check on %1."))
                .arg(date_text(standing.next_check));
        case Standing::due:
        case Standing::relapsed:
            return check_detail(standing);
    }
    if (standing.met_provisionally)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                     "You have enough passes, but the limits are provisional: later tasks "
                                     "are unlocked, and proficiency is not declared."));
    if (standing.never_met)
        return say(
            QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                              "Nobody can meet the rule of this task: it counts too few attempts. Ask your "
                              "educator to correct the curriculum."));
    if (standing.rated_low)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                     "The ratings of the attempt of %1 are below the limit: the next pass "
                                     "that meets the rule is rated."))
            .arg(date_text(standing.rated_time));
    if (standing.one_more_pass)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing",
                                     "You have enough passes for the present rule: the next pass that meets "
                                     "it counts."));
    if (standing.one_more_day)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Pass once more on another day."));
    if (standing.more_variants == 1)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Pass once on another variant of the task."));
    if (standing.more_variants > 1)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "Pass on %n more variants of the task."),
                   standing.more_variants);
    if (standing.stalled)
        return say(
            QT_TRANSLATE_NOOP("fulcrum::ui::standing", "%n attempts without proficiency: ask your educator."),
            standing.attempts);
    return say(QT_TRANSLATE_NOOP("fulcrum::ui::standing", "%1 % of the way to proficiency"))
        .arg(static_cast<int>(100 * standing.progress));
}

StandingBadge::StandingBadge(const TaskStanding& standing) : standing_(standing) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(standing_text(standing));
    setToolTip(standing_text(standing));
}

QSize StandingBadge::sizeHint() const {
    const int side = static_cast<int>(1.7 * fontMetrics().height());
    return {side, side};
}

void StandingBadge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint_standing(painter, QRectF(rect()), standing_);
}

}  // namespace fulcrum::ui
