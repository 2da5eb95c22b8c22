// SPDX-License-Identifier: GPL-3.0-or-later
// The attempts that the acting role may read, newest first, with filters; any of them opens in the debrief.
// The corrections that trainees asked for stand above. Trainees see their own.
#pragma once

#include <vector>

#include "database/attempts.h"
#include "ui/shell/context.h"

class QComboBox;
class QFrame;
class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace fulcrum::ui {

class AttemptsPage : public Page {
    Q_OBJECT
  public:
    explicit AttemptsPage(Context& context);
    void enter() override;

  private:
    void fill_filters();
    void fill_requests();
    void load();
    void open_row(int row);

    std::vector<database::AttemptSummary> attempts_;
    QLabel *title_, *count_;
    QFrame* requests_card_;
    QVBoxLayout* requests_;
    QComboBox *cohort_, *person_, *task_;
    QTableWidget* table_;
};

}  // namespace fulcrum::ui
