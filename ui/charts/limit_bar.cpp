// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/limit_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr double spare = 0.15;  // of the span, beyond the values
constexpr int bar_height = 12;  // px

QString with_unit(double value, const QString& unit) {
    return unit.isEmpty() ? figure(value) : QStringLiteral("%1 %2").arg(figure(value), unit);
}

QColor faint(const QColor& ground, const QColor& ink, double share) {
    const auto part = [share](double a, double b) { return a + (b - a) * share; };
    return QColor::fromRgbF(part(ground.redF(), ink.redF()), part(ground.greenF(), ink.greenF()),
                            part(ground.blueF(), ink.blueF()));
}

}  // namespace

LimitBarSpan limit_bar_span(const LimitBarData& data) {
    LimitBarSpan span{0, 0};
    for (const std::optional<double>& value : {data.limit, data.experts_low, data.experts_high, data.last}) {
        if (!value || !std::isfinite(*value)) continue;
        span.low = std::min(span.low, *value);
        span.high = std::max(span.high, *value);
    }
    const double width = span.high - span.low;
    if (!(width > 0)) return {span.low, span.low + 1};
    if (span.high > 0) span.high += spare * width;
    if (span.low < 0) span.low -= spare * width;
    return span;
}

LimitBar::LimitBar(LimitBarData data, QWidget* parent) : QWidget(parent), data_(std::move(data)) {
    setObjectName(QStringLiteral("limit_bar"));
    QStringList parts{data_.limit_words};
    if (data_.experts_low && data_.experts_high)
        parts << tr("experts %1 to %2")
                     .arg(figure(*data_.experts_low), with_unit(*data_.experts_high, data_.unit));
    parts << (data_.last ? tr("your last value %1").arg(with_unit(*data_.last, data_.unit))
                         : tr("no value of yours yet"));
    setAccessibleName(data_.name + QStringLiteral(": ") + parts.join(QStringLiteral("; ")));
    setToolTip(accessibleName());
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize LimitBar::minimumSizeHint() const {
    return {12 * fontMetrics().height(), 2 * fontMetrics().height() + bar_height + 10};
}

QSize LimitBar::sizeHint() const {
    return minimumSizeHint() * 1.0 + QSize(8 * fontMetrics().height(), 0);
}

QRectF LimitBar::bar() const {
    return {4.0, fontMetrics().height() + 3.0, width() - 8.0, double(bar_height)};
}

double LimitBar::x_of(double value) const {
    const LimitBarSpan span = limit_bar_span(data_);
    const QRectF room = bar();
    return room.left() + room.width() * std::clamp((value - span.low) / (span.high - span.low), 0.0, 1.0);
}

void LimitBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& p = colours();
    const QRectF room = bar();
    const QFontMetricsF metrics(font(), this);
    const double line = metrics.height();
    const double limit_room = std::min(metrics.horizontalAdvance(data_.limit_words), 0.55 * width());
    painter.setPen(p.text);
    painter.drawText(QRectF(0, 0, width() - limit_room - 8, line), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(data_.name, Qt::ElideRight, width() - limit_room - 8));
    painter.setPen(p.muted);
    painter.drawText(QRectF(width() - limit_room, 0, limit_room, line), Qt::AlignRight | Qt::AlignVCenter,
                     metrics.elidedText(data_.limit_words, Qt::ElideRight, limit_room));
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.raised);
    painter.drawRoundedRect(room, 3, 3);
    if (data_.limit) {
        const double x = x_of(*data_.limit);
        const QRectF met = data_.higher_is_better ? QRectF(QPointF(x, room.top()), room.bottomRight())
                                                  : QRectF(room.topLeft(), QPointF(x, room.bottom()));
        painter.setBrush(faint(p.raised, p.good, 0.4));
        painter.drawRoundedRect(met, 3, 3);
    }
    if (data_.experts_low && data_.experts_high) {
        const double a = x_of(*data_.experts_low), b = x_of(*data_.experts_high);
        painter.setPen(QPen(p.text, 1.2));
        painter.setBrush(faint(p.card, p.neutral, 0.55));
        painter.drawRect(QRectF(a, room.top() + 2, std::max(b - a, 3.0), room.height() - 4));
    }
    if (data_.limit) {
        const double x = x_of(*data_.limit);
        painter.setPen(QPen(p.limit, 3));
        painter.drawLine(QPointF(x, room.top() - 3), QPointF(x, room.bottom() + 3));
    }
    if (!data_.last) return;
    const double x = x_of(*data_.last), middle = room.center().y(), r = 6.5;
    painter.setPen(QPen(p.card, 1.5));
    painter.setBrush(p.text);
    painter.drawPolygon(QPolygonF(
        {QPointF(x - r, middle), QPointF(x, middle - r), QPointF(x + r, middle), QPointF(x, middle + r)}));
    const QString words = tr("you: %1").arg(with_unit(*data_.last, data_.unit));
    const double wide = metrics.horizontalAdvance(words);
    painter.setPen(p.text);
    painter.drawText(QRectF(std::clamp(x - wide / 2, 0.0, std::max(0.0, width() - wide)), room.bottom() + 4,
                            wide + 2, line),
                     Qt::AlignLeft | Qt::AlignVCenter, words);
}

}  // namespace fulcrum::ui

#include "moc_limit_bar.cpp"
