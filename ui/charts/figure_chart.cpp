// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/figure_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/style/announce.h"

namespace fulcrum::ui {

FigureChart::FigureChart(const char* name, QWidget* parent) : QWidget(parent) {
    setObjectName(QString::fromLatin1(name));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(tr("Arrow keys choose a part, Enter shows what is behind it."));
}

void FigureChart::show_figure(Figure figure, ChartTable table, const QString& words, const QString& nothing) {
    figure_ = std::move(figure);
    table_ = std::move(table);
    words_ = words;
    nothing_ = nothing;
    selected_ = -1;
    spots_.clear();
    setAccessibleDescription(is_empty(figure_) ? nothing_
                                               : (words_ + QLatin1Char(' ') + toolTip()).trimmed());
    updateGeometry();
    update();
    values_changed();
}

QRectF FigureChart::room() const {
    return QRectF(rect()).adjusted(6, 4, -6, -4);
}

QSize FigureChart::sizeHint() const {
    return {440, static_cast<int>(figure_lines(figure_) * fontMetrics().height()) + 8};
}

QSize FigureChart::minimumSizeHint() const {
    return {240, sizeHint().height()};
}

QRectF FigureChart::place_of(const QString& key) const {
    for (const FigureSpot& spot : spots_)
        if (spot.key == key) return spot.place;
    return {};
}

void FigureChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& p = colours();
    painter.fillRect(rect(), p.card);
    if (is_empty(figure_)) {
        painter.setPen(p.muted);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, nothing_);
        return;
    }
    spots_ = paint_figure(painter, room(), figure_, p, 1);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(p.accent, 1, Qt::DotLine));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    if (selected_ < 0 || selected_ >= static_cast<int>(spots_.size())) return;
    painter.setPen(QPen(p.text, 1.5));
    painter.drawRect(spots_[static_cast<std::size_t>(selected_)].place.adjusted(-2, -1, 2, 1));
}

int FigureChart::spot_at(const QPointF& position) const {
    for (std::size_t i = spots_.size(); i-- > 0;)
        if (spots_[i].place.contains(position)) return static_cast<int>(i);
    return -1;
}

void FigureChart::select(int spot) {
    selected_ = spot;
    setAccessibleDescription(spots_[static_cast<std::size_t>(spot)].words);
    update();
}

void FigureChart::select_by_key(int spot) {
    select(spot);
    const FigureSpot& part = spots_[static_cast<std::size_t>(spot)];
    announce(this, part.words);
    QToolTip::showText(mapToGlobal(part.place.bottomLeft().toPoint()), part.words, this);
}

void FigureChart::mousePressEvent(QMouseEvent* event) {
    const int spot = spot_at(event->localPos());
    if (spot < 0 || event->button() != Qt::LeftButton) return;
    select(spot);
    // What it leads to may replace the figure.
    const QString key = spots_[static_cast<std::size_t>(spot)].key;
    emit part_chosen(key);
}

void FigureChart::mouseMoveEvent(QMouseEvent* event) {
    setCursor(spot_at(event->localPos()) >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void FigureChart::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(spots_.size()) - 1;
    switch (event->key()) {
        case Qt::Key_Right:
        case Qt::Key_Down:
            if (last >= 0) select_by_key(std::min(selected_ + 1, last));
            return;
        case Qt::Key_Left:
        case Qt::Key_Up:
            if (last >= 0) select_by_key(selected_ < 0 ? last : std::max(selected_ - 1, 0));
            return;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (event->isAutoRepeat()) return;  // what it shows has a key of its own
            if (selected_ < 0 || selected_ > last) break;
            emit part_chosen(QString(spots_[static_cast<std::size_t>(selected_)].key));
            return;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

bool FigureChart::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int spot = spot_at(help->pos());
        if (spot >= 0)
            QToolTip::showText(help->globalPos(), spots_[static_cast<std::size_t>(spot)].words, this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

}  // namespace fulcrum::ui

#include "moc_figure_chart.cpp"
