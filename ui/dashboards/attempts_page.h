// SPDX-License-Identifier: GPL-3.0-or-later
// The attempts that the acting role may read, newest first, with filters; any of them opens in the debrief.
// The corrections that trainees asked for stand above, and the scores that older metrics or limits gave, for
// those who may compute them again. Educators import traces from elsewhere. Trainees see their own.
#pragma once

#include <vector>

#include "database/records/attempts.h"
#include "ui/page/context.h"

class QComboBox;
class QFrame;
class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;
class TraceImportCard;

class StationNote;

class AttemptsPage : public Page {
    Q_OBJECT
  public:
    explicit AttemptsPage(Context& context);
    void enter() override;
    void leave() override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QFrame* build_stale();
    QWidget* build_buttons();
    void count_stale();
    void recompute();
    void fill_filters();
    void hide_columns();
    void fill_requests();
    /// Reads every attempt: in the background.
    void look_for_cut_off();
    void show_cut_off(const std::vector<database::CutOffSeries>& series);
    void load();
    void open_row(int row);

    std::vector<database::AttemptSummary> attempts_;
    QLabel *title_, *count_;
    QFrame *requests_card_, *cut_off_card_;
    QVBoxLayout *requests_, *cut_off_;
    QFrame* stale_card_;
    QLabel *stale_, *stale_names_;
    QPushButton* recompute_;
    JobBar* bar_;
    BackgroundJob *job_ = nullptr, *cut_off_job_ = nullptr;
    QComboBox *cohort_, *person_, *task_;
    QTableWidget* table_;
    TraceImportCard* import_;
    QPushButton* show_import_;
    StationNote* note_;
};

}  // namespace fulcrum::ui
