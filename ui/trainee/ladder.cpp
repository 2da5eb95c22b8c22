// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/ladder.h"

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QResizeEvent>
#include <map>

#include "ui/style/palette.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int gap = 28;  // between columns, for the lines
constexpr int step_gap = 14;

}  // namespace

Ladder::Ladder(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("ladder"));
    setAccessibleName(tr("Your progress through the curriculum"));
    layout_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
    layout_->setContentsMargins(0, 0, 0, 0);
}

void Ladder::set_stages(std::vector<Stage> stages) {
    clear_layout(layout_);
    stages_ = std::move(stages);
    for (const Stage& stage : stages_) {
        auto* column = new QWidget;
        auto* steps = new QVBoxLayout(column);
        steps->setContentsMargins(0, 0, 0, 0);
        steps->setSpacing(step_gap);
        steps->addWidget(make_label(stage.title, "heading"));
        // A short column stands in the middle of a long one, so that the lines stay short.
        steps->addStretch(1);
        for (const Step& step : stage.steps) steps->addWidget(step.card);
        steps->addStretch(1);
        layout_->addWidget(column, 1);
    }
    arrange();
}

int Ladder::widest_card() const {
    int widest = 0;
    for (const Stage& stage : stages_)
        for (const Step& step : stage.steps) widest = std::max(widest, step.card->minimumSizeHint().width());
    return widest;
}

QSize Ladder::minimumSizeHint() const {
    // One column is always possible; the height is that of the present arrangement.
    return {widest_card(), QWidget::minimumSizeHint().height()};
}

void Ladder::arrange() {
    const int stages = std::max<int>(1, static_cast<int>(stages_.size()));
    in_columns_ = (width() - (stages - 1) * gap) / stages >= widest_card();
    layout_->setDirection(in_columns_ ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    layout_->setSpacing(in_columns_ ? gap : step_gap);
    update();
}

void Ladder::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void Ladder::paintEvent(QPaintEvent*) {
    if (!in_columns_) return;
    std::map<std::string, const QFrame*> cards;
    for (const Stage& stage : stages_)
        for (const Step& step : stage.steps) cards[step.task] = step.card;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& p = colours();
    for (const Stage& stage : stages_) {
        for (const Step& step : stage.steps) {
            for (const std::string& before : step.after) {
                const auto from = cards.find(before);
                if (from == cards.end()) continue;
                const auto here = [this](const QFrame& card) {
                    return QRect(card.mapTo(this, QPoint(0, 0)), card.size());
                };
                const QRect a = here(*from->second), b = here(*step.card);
                // From side to side; between cards of one stage from the bottom to the top.
                const bool below = b.top() > a.bottom() && b.left() < a.right();
                const QPointF begin =
                    below ? QPointF(a.center().x(), a.bottom() + 1) : QPointF(a.right() + 1, a.center().y());
                const QPointF tip =
                    below ? QPointF(b.center().x(), b.top()) : QPointF(b.left(), b.center().y());
                const QPointF ahead = below ? QPointF(0, 1) : QPointF(1, 0), aside(ahead.y(), ahead.x());
                const QPointF end = tip - 7 * ahead;
                QPainterPath path(begin);
                const double middle = 0.5 * (begin.x() + end.x());
                if (below) {
                    path.lineTo(end);
                } else {
                    path.cubicTo({middle, begin.y()}, {middle, end.y()}, end);
                }
                painter.setPen(
                    QPen(step.unlocked ? p.good : p.muted, 2, step.unlocked ? Qt::SolidLine : Qt::DashLine));
                painter.setBrush(Qt::NoBrush);
                painter.drawPath(path);
                painter.setPen(Qt::NoPen);
                painter.setBrush(step.unlocked ? p.good : p.muted);
                painter.drawPolygon(QPolygonF({tip, end - ahead - 5 * aside, end - ahead + 5 * aside}));
            }
        }
    }
}

}  // namespace fulcrum::ui

#include "moc_ladder.cpp"
