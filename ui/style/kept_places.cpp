// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/kept_places.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>

namespace fulcrum::ui {
namespace {

QVariant key_of(const QAbstractItemModel& model, int row) {
    return model.index(row, 0).data(Qt::UserRole);
}

int row_of_key(const QAbstractItemModel& model, const QVariant& key, int before) {
    if (!key.isValid() || key_of(model, before) == key) return before;
    int row = 0;
    while (row < model.rowCount() && key_of(model, row) != key) ++row;
    return row;
}

void scroll_to(QAbstractScrollArea& area, int across, int down) {
    area.horizontalScrollBar()->setValue(across);
    area.verticalScrollBar()->setValue(down);
}

}  // namespace

KeptPlaces::KeptPlaces(QWidget* part) {
    for (auto* area : part->findChildren<QAbstractScrollArea*>())
        // A list that a choice opens is a window of its own.
        if (area->window() == part->window() && qobject_cast<QHeaderView*>(area) == nullptr) keep(area);
    for (QWidget* up = part; up != nullptr; up = up->parentWidget())
        if (auto* area = qobject_cast<QAbstractScrollArea*>(up)) keep(area);
}

void KeptPlaces::keep(QAbstractScrollArea* area) {
    Place place;
    place.area = area;
    place.across = area->horizontalScrollBar()->value();
    place.down = area->verticalScrollBar()->value();
    const auto* table = qobject_cast<QTableView*>(area);
    if (table != nullptr && table->model() != nullptr && table->currentIndex().isValid()) {
        place.row = table->currentIndex().row();
        place.column = table->currentIndex().column();
        place.key = key_of(*table->model(), place.row);
    }
    places_.push_back(std::move(place));
}

KeptPlaces::~KeptPlaces() {
    for (const Place& place : places_) {
        if (place.area.isNull()) continue;
        if (auto* table = qobject_cast<QTableView*>(place.area.data());
            table != nullptr && table->model() != nullptr) {
            const QAbstractItemModel& model = *table->model();
            const QModelIndex cell = place.row < 0
                                         ? QModelIndex()
                                         : model.index(row_of_key(model, place.key, place.row), place.column);
            if (cell.isValid()) table->setCurrentIndex(cell);
            if (table->isVisible()) table->doItemsLayout();  // its length is known only then
        }
        scroll_to(*place.area, place.across, place.down);
        // What was made now is laid out later.
        QTimer::singleShot(0, place.area.data(),
                           [area = place.area.data(), across = place.across, down = place.down] {
                               scroll_to(*area, across, down);
                           });
    }
}

}  // namespace fulcrum::ui
