// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/specimen_view.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <QStringList>
#include <cmath>

#include "ui/reports/pathology_words.h"
#include "ui/reports/specimen_map.h"
#include "ui/review/specimen_solid.h"

namespace fulcrum::ui {

SpecimenCell::SpecimenCell(const PathologyReport& report, const SectorFinding& finding, QWidget* parent)
    : QAbstractButton(parent) {
    setObjectName(QStringLiteral("specimen_cell_%1_%2")
                      .arg(finding.level + 1)
                      .arg(QString::fromLatin1(sector_name(finding.sector))));
    const QString words = sector_words(report, finding);
    setAccessibleName(words);
    setToolTip(words);
    setCheckable(true);
    setAutoExclusive(true);
    setCursor(Qt::PointingHandCursor);
}

void SpecimenCell::paintEvent(QPaintEvent*) {
    if (!isChecked() && !hasFocus() && !underMouse()) return;
    QPainter painter(this);
    const Palette& p = colours();
    painter.setPen(QPen(isChecked() || hasFocus() ? p.accent : p.muted, isChecked() ? 3 : 2,
                        hasFocus() && !isChecked() ? Qt::DashLine : Qt::SolidLine));
    painter.drawRect(rect().adjusted(2, 2, -3, -3));
}

void SpecimenCell::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up:
            emit move_wanted(-1, 0);
            break;
        case Qt::Key_Down:
            emit move_wanted(1, 0);
            break;
        case Qt::Key_Left:
            emit move_wanted(0, -1);
            break;
        case Qt::Key_Right:
            emit move_wanted(0, 1);
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            click();
            break;
        default:
            QAbstractButton::keyPressEvent(event);
    }
}

SpecimenView::SpecimenView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("specimen_map"));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSizePolicy(policy);
    solid_ = new SpecimenSolid(this);
    solid_->hide();
    connect(solid_, &SpecimenSolid::sector_chosen, this, [this](int finding) {
        if (static_cast<std::size_t>(finding) < cells_.size())
            cells_[static_cast<std::size_t>(finding)]->setChecked(true);
        emit sector_chosen(finding);
    });
}

void SpecimenView::show_solid(bool solid) {
    solid_->setVisible(solid && has_sectors());
    for (SpecimenCell* cell : cells_) cell->setVisible(solid_->isHidden());
    arrange();
    update();
}

double SpecimenView::least_grid() const {
    constexpr double lines = 19;
    return solid_->isHidden() ? 0 : lines;
}

void SpecimenView::open(const PathologyReport& report) {
    report_ = report;
    for (SpecimenCell* cell : cells_) delete cell;
    cells_.clear();
    const std::size_t drawn =
        specimen_map_layout(report_, std::max(1, width()), QFontMetricsF(font()), 1).cells.size();
    for (std::size_t i = 0; i < drawn; ++i) {
        auto* cell = new SpecimenCell(report_, report_.findings[i], this);
        cell->setFocusPolicy(i == 0 ? Qt::StrongFocus : Qt::ClickFocus);
        const int index = static_cast<int>(i);
        connect(cell, &QAbstractButton::clicked, this, [this, index] {
            solid_->choose(index);
            emit sector_chosen(index);
        });
        connect(cell, &SpecimenCell::move_wanted, this,
                [this, index](int levels, int sectors) { move(index, levels, sectors); });
        cell->show();
        cells_.push_back(cell);
    }
    solid_->open(report_);
    solid_->hide();
    QStringList words;
    for (const PathologyLabel& label : pathology_labels(report_))
        words << label.title + QStringLiteral(": ") + label.value +
                     (label.why.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(label.why));
    setAccessibleName(tr("Specimen map"));
    setAccessibleDescription(words.join(QStringLiteral(". ")));
    arrange();
    update();
}

void SpecimenView::arrange() {
    const SpecimenMapLayout layout =
        specimen_map_layout(report_, width(), QFontMetricsF(font()), 1, least_grid());
    solid_->setGeometry(QRectF(QPointF(0, 0), layout.grid.bottomRight()).toAlignedRect());
    for (std::size_t i = 0; i < cells_.size() && i < layout.cells.size(); ++i)
        cells_[i]->setGeometry(layout.cells[i].toAlignedRect());
    const int height = static_cast<int>(std::ceil(layout.height));
    if (minimumHeight() != height) setFixedHeight(height);
}

QSize SpecimenView::sizeHint() const {
    return {600, minimumHeight()};
}

void SpecimenView::move(int from, int levels, int sectors) {
    const SectorFinding& here = report_.findings[static_cast<std::size_t>(from)];
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const SectorFinding& other = report_.findings[i];
        if (other.level != here.level + levels ||
            static_cast<int>(other.sector) != static_cast<int>(here.sector) + sectors)
            continue;
        cells_[i]->setFocus(Qt::OtherFocusReason);
        cells_[i]->click();
        return;
    }
}

void SpecimenView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (solid_->isHidden())
        paint_specimen_map(painter, {0, 0}, width(), report_, colours(), 1);
    else
        paint_around_specimen_map(painter, width(), report_, colours(), least_grid());
}

void SpecimenView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void SpecimenView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange && event->type() != QEvent::StyleChange) return;
    arrange();
    update();
}

}  // namespace fulcrum::ui

#include "moc_specimen_view.cpp"
