// SPDX-License-Identifier: GPL-3.0-or-later
// A page, or a part of one, that is filled again shows the place that it showed before. UI thread.
#pragma once

#include <QAbstractScrollArea>
#include <QPointer>
#include <QVariant>
#include <vector>

namespace fulcrum::ui {

/// The scroll positions and the current cells of tables in and around a part of a page that is filled again
/// while this is there. The row of a current cell is found again by Qt::UserRole of its first cell, where
/// rows have one, else by its number.
class KeptPlaces {
  public:
    explicit KeptPlaces(QWidget* part);
    ~KeptPlaces();
    KeptPlaces(const KeptPlaces&) = delete;
    KeptPlaces& operator=(const KeptPlaces&) = delete;

  private:
    struct Place {
        QPointer<QAbstractScrollArea> area;
        int across = 0, down = 0;   ///< of the scroll bars
        int row = -1, column = -1;  ///< of the current cell of a table
        QVariant key;
    };
    void keep(QAbstractScrollArea* area);
    std::vector<Place> places_;
};

}  // namespace fulcrum::ui
