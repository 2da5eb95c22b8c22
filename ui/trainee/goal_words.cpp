// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/goal_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "assessment/metrics/registry.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString goal_say(const char* source, int count = -1) {
    return QCoreApplication::translate("fulcrum::ui::goals", source, nullptr, count);
}

QString goal_figure(const database::GoalWish& wish, const std::optional<double>& value) {
    const MetricDescriptor* metric = find_metric(wish.metric);
    return figure_with_unit(value, metric == nullptr ? std::string() : metric->unit);
}

QString days_left_text(std::int64_t days) {
    return days == 1
               ? goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "Today is the last day."))
               : goal_say(QT_TRANSLATE_N_NOOP("fulcrum::ui::goals", "%n days left."), static_cast<int>(days));
}

}  // namespace

std::int64_t day_of(const QDate& date) {
    return QDate(1970, 1, 1).daysTo(date);
}

QDate date_of(std::int64_t day) {
    return QDate(1970, 1, 1).addDays(day);
}

QString goal_title(const database::GoalWish& wish, const QString& task) {
    if (wish.kind == database::GoalOf::attempts) {
        const QString number = goal_say(QT_TRANSLATE_N_NOOP("fulcrum::ui::goals", "%n attempts a week"),
                                        static_cast<int>(wish.target));
        return task.isEmpty() ? number
                              : goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "%1: %2")).arg(task, number);
    }
    const MetricDescriptor* metric = find_metric(wish.metric);
    const bool higher = metric != nullptr && metric->direction == Direction::higher;
    const QString date = QLocale().toString(date_of(wish.due_day),
                                            goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "d MMM yyyy")));
    return (higher ? goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "%1: %2 at least %3 by %4"))
                   : goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "%1: %2 at most %3 by %4")))
        .arg(task, metric_text(wish.metric), goal_figure(wish, wish.target), date);
}

QString goal_state(const database::GoalProgress& progress) {
    const database::GoalWish& wish = progress.goal.wish;
    if (wish.kind == database::GoalOf::attempts) {
        const QString done = goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "%1 of %2 this week."))
                                 .arg(progress.done)
                                 .arg(static_cast<int>(wish.target));
        return done + QLatin1Char(' ') +
               (progress.reached ? goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "Reached."))
                                 : days_left_text(progress.days_left));
    }
    if (progress.reached)
        return goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "Reached: %1."))
            .arg(goal_figure(wish, progress.best));
    const QString best =
        progress.best ? (progress.start
                             ? goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "Best so far %1, before %2."))
                                   .arg(goal_figure(wish, progress.best), goal_figure(wish, progress.start))
                             : goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "Best so far %1."))
                                   .arg(goal_figure(wish, progress.best)))
                      : goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "No completed attempt since then."));
    return best + QLatin1Char(' ') +
           (progress.missed ? goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "The day has passed."))
                            : days_left_text(progress.days_left));
}

GoalRing::GoalRing(const database::GoalProgress& progress)
    : share_(progress.share), reached_(progress.reached), missed_(progress.missed) {
    setObjectName(QStringLiteral("goal_ring"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    const QString words =
        goal_say(QT_TRANSLATE_NOOP("fulcrum::ui::goals", "%1 % of the goal")).arg(qRound(100 * share_));
    setAccessibleName(words);
    setToolTip(words);
}

QSize GoalRing::sizeHint() const {
    const int side = static_cast<int>(3.2 * fontMetrics().height());
    return {side, side};
}

void GoalRing::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& p = colours();
    const double line = std::max(3.0, 0.13 * width());
    const QRectF ring = QRectF(rect()).adjusted(line, line, -line, -line);
    painter.setPen(QPen(p.line, line));
    painter.drawEllipse(ring);
    const QColor filled = reached_ ? p.good : missed_ ? p.muted : p.accent;
    painter.setPen(QPen(filled, line, Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(ring, 90 * 16, -static_cast<int>(share_ * 360 * 16));
    const double mark = 0.16 * width();
    const QPointF centre = QRectF(rect()).center();
    painter.setPen(QPen(filled, std::max(2.0, 0.06 * width()), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (reached_) {
        painter.drawPolyline(QPolygonF({centre + QPointF(-mark, 0), centre + QPointF(-0.2 * mark, 0.7 * mark),
                                        centre + QPointF(mark, -0.7 * mark)}));
    } else if (missed_) {
        painter.drawLine(centre - QPointF(mark, 0), centre + QPointF(mark, 0));
    } else {
        painter.setPen(p.text);
        painter.drawText(rect(), Qt::AlignCenter, QString::number(static_cast<int>(100 * share_)));
    }
}

}  // namespace fulcrum::ui
