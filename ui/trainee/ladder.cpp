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
    setAccessibleName(tr("Your way through the curriculum"));
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
                const QPointF begin(a.right() + 1, a.center().y()), end(b.left() - 7, b.center().y());
                QPainterPath path(begin);
                const double middle = 0.5 * (begin.x() + end.x());
                path.cubicTo({middle, begin.y()}, {middle, end.y()}, end);
                painter.setPen(
                    QPen(step.unlocked ? p.good : p.muted, 2, step.unlocked ? Qt::SolidLine : Qt::DashLine));
                painter.setBrush(Qt::NoBrush);
                painter.drawPath(path);
                painter.setPen(Qt::NoPen);
                painter.setBrush(step.unlocked ? p.good : p.muted);
                painter.drawPolygon(
                    QPolygonF({end + QPointF(7, 0), end + QPointF(-1, -5), end + QPointF(-1, 5)}));
            }
        }
    }
}

}  // namespace fulcrum::ui

#include "moc_ladder.cpp"
