// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts to be rated with an observer form, first those that the curriculum waits for, then newest first,
// without names and scores, so that whoever opens
// one here can rate it blind.
#pragma once

#include <string>
#include <vector>

#include "database/records/ratings.h"
#include "ui/page/context.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class StoreReading;

class ToRatePage : public Page {
    Q_OBJECT
  public:
    explicit ToRatePage(Context& context);
    void enter() override;
    void leave() override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Reads in the background; what is shown stays until then.
    void load();
    /// All that were read, or those alone that are not rated yet.
    void fill();
    void open_row(int row);
    /// Were changed here since they were read.
    void note_handed_in(const std::string& attempt_id);
    void note_voided(const std::string& attempt_id);

    std::vector<database::RatableAttempt> all_, attempts_;  ///< as read; a row each
    QString failed_;                                        ///< why they could not be read; empty: they could
    QCheckBox* rated_;
    QLabel* count_;
    QTableWidget* table_;
    QPushButton* open_;
    StoreReading* reading_;
};

}  // namespace fulcrum::ui
