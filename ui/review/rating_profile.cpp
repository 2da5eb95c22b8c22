// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/rating_profile.h"

#include <QPainter>
#include <algorithm>

#include "ui/reports/rating_words.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {
namespace {

constexpr double mark_size = 11;  // px
constexpr double margin = 14;     // px, at both ends of a scale

QColor rater_colour(int number) {
    const Palette& p = colours();
    const QColor all[] = {p.left_hand, p.right_hand, p.good, p.limit};
    return all[number % 4];
}

}  // namespace

void paint_rater_mark(QPainter& painter, QPointF centre, double size, int number) {
    const QColor colour = rater_colour(number);
    const bool outline = number % 8 >= 4;
    const double r = size / 2;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(outline ? colour : colours().card, outline ? 2.2 : 1.2));
    painter.setBrush(outline ? colours().card : colour);
    switch (number % 4) {
        case 0:
            painter.drawEllipse(centre, r, r);
            break;
        case 1:
            painter.drawRect(QRectF(centre.x() - r * 0.9, centre.y() - r * 0.9, 1.8 * r, 1.8 * r));
            break;
        case 2:
            painter.drawPolygon(QPolygonF({centre - QPointF(1.25 * r, 0), centre - QPointF(0, 1.25 * r),
                                           centre + QPointF(1.25 * r, 0), centre + QPointF(0, 1.25 * r)}));
            break;
        default:
            painter.drawPolygon(QPolygonF({centre + QPointF(-1.15 * r, r), centre + QPointF(1.15 * r, r),
                                           centre - QPointF(0, 1.15 * r)}));
    }
    painter.restore();
}

RaterMark::RaterMark(int number, QWidget* parent) : QWidget(parent), number_(number) {
    setFixedSize(sizeHint());
}

QSize RaterMark::sizeHint() const {
    return {18, 18};
}

void RaterMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint_rater_mark(painter, QRectF(rect()).center(), mark_size, number_);
}

RatingProfile::RatingProfile(ObserverForm form, std::vector<RatingLine> lines, QWidget* parent)
    : QWidget(parent), form_(std::move(form)), lines_(std::move(lines)) {
    setObjectName(QStringLiteral("rating_profile"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(form_text(form_.title));
    QStringList rows;
    for (std::size_t i = 0; i < form_.items.size(); ++i) {
        QStringList given;
        for (const RatingLine& line : lines_)
            given << line.rater + QLatin1Char(' ') + rating_answer_text(form_.items[i], line.answers[i]);
        rows << form_text(form_.items[i].title) + QStringLiteral(": ") + given.join(QStringLiteral(", "));
    }
    setAccessibleDescription(rows.join(QStringLiteral("; ")));
    setToolTip(rows.join(QLatin1Char('\n')));
}

double RatingProfile::row_height() const {
    return std::max(1.7 * fontMetrics().height(), 0.9 * mark_size * static_cast<double>(lines_.size()));
}

QSize RatingProfile::minimumSizeHint() const {
    const double rows = static_cast<double>(form_.items.size()) + 0.8;
    return {24 * fontMetrics().averageCharWidth(), static_cast<int>(rows * row_height())};
}

QSize RatingProfile::sizeHint() const {
    return minimumSizeHint() + QSize(40 * fontMetrics().averageCharWidth(), 0);
}

double RatingProfile::label_width() const {
    int widest = 0;
    for (const FormItem& item : form_.items)
        widest = std::max(widest, fontMetrics().horizontalAdvance(form_text(item.title)));
    return std::min(widest + 12.0, 0.45 * width());
}

QPointF RatingProfile::place_of(std::size_t item, int rating) const {
    const FormItem& scale = form_.items[item];
    const double left = label_width() + margin, room = width() - left - margin;
    const double share = static_cast<double>(rating - scale.lowest) / (scale.highest - scale.lowest);
    return {left + share * room, (static_cast<double>(item) + 1.3) * row_height()};
}

double RatingProfile::set_apart(std::size_t line) const {
    const double count = static_cast<double>(lines_.size());
    return (static_cast<double>(line) - (count - 1) / 2) * std::min(0.8 * mark_size, row_height() / count);
}

void RatingProfile::paint_scales(QPainter& painter) const {
    const Palette& p = colours();
    const QFontMetricsF metrics(font(), this);
    const double line = metrics.height();
    for (std::size_t i = 0; i < form_.items.size(); ++i) {
        const FormItem& item = form_.items[i];
        const QPointF first = place_of(i, item.lowest), last = place_of(i, item.highest);
        if (std::none_of(lines_.begin(), lines_.end(),
                         [&](const RatingLine& one) { return one.answers[i].has_value(); })) {
            painter.setPen(p.muted);
            painter.drawText(QRectF(first.x(), first.y() - 1.3 * line, last.x() - first.x(), line),
                             Qt::AlignCenter, rating_answer_text(item, std::nullopt));
        }
        painter.setPen(QPen(p.line, 2));
        painter.drawLine(first, last);
        const bool sparse = item.highest - item.lowest > 12;
        const bool new_scale =
            i == 0 || item.lowest != form_.items[i - 1].lowest || item.highest != form_.items[i - 1].highest;
        for (int rating = item.lowest; rating <= item.highest; ++rating) {
            if (sparse && rating != item.lowest && rating != item.highest) continue;
            const QPointF at = place_of(i, rating);
            painter.setPen(QPen(p.line, 2));
            painter.drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
            if (!new_scale) continue;
            painter.setPen(p.muted);
            painter.drawText(QRectF(at.x() - 20, at.y() - 0.75 * row_height() - line / 2, 40, line),
                             Qt::AlignCenter, QString::number(rating));
        }
        painter.setPen(p.text);
        const double room = label_width() - 8;
        painter.drawText(QRectF(0, first.y() - line / 2, room, line), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(form_text(item.title), Qt::ElideRight, room));
    }
}

void RatingProfile::paint_line(QPainter& painter, std::size_t line) const {
    const RatingLine& shown = lines_[line];
    QColor colour = rater_colour(shown.mark);
    colour.setAlphaF(0.55);
    const QPointF apart(0, set_apart(line));
    for (std::size_t i = 1; i < shown.answers.size(); ++i) {
        if (!shown.answers[i] || !shown.answers[i - 1]) continue;
        painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(place_of(i - 1, *shown.answers[i - 1]) + apart,
                         place_of(i, *shown.answers[i]) + apart);
    }
    for (std::size_t i = 0; i < shown.answers.size(); ++i)
        if (shown.answers[i])
            paint_rater_mark(painter, place_of(i, *shown.answers[i]) + apart, mark_size, shown.mark);
}

void RatingProfile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_scales(painter);
    for (std::size_t i = 0; i < lines_.size(); ++i) paint_line(painter, i);
}

}  // namespace fulcrum::ui
