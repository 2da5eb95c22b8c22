// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that write themselves, and files for research. The schedules of this station: listed, added,
// removed, written now. What is due is written while a director's window is open (ui/shell/schedule_watch.h)
// or by `fulcrum schedule run`.
#pragma once

#include <vector>

#include "database/records/people.h"
#include "database/schedules/schedules.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class JobBar;

class StationNote;

class SchedulesPage : public Page {
    Q_OBJECT
  public:
    explicit SchedulesPage(Context& context);
    void enter() override;
    void leave() override;

  private:
    QWidget* build_list();
    QLayout* build_adding();
    QWidget* build_research();
    void fill();
    void look();
    void choose_folder(QLineEdit* into, const QString& title);
    void add();
    void remove();
    void write(const std::string& only);
    void export_research();
    std::string chosen() const;

    std::vector<database::ReportSchedule> schedules_;
    std::vector<database::Cohort> cohorts_;
    BackgroundJob* job_ = nullptr;
    QTableWidget* table_;
    QLabel *none_, *no_cohort_, *research_result_;
    QPushButton *add_, *remove_, *remove_sure_, *write_one_, *write_due_, *export_;
    QComboBox *cohort_, *format_, *every_;
    QLineEdit *folder_, *research_folder_;
    JobBar *bar_, *research_bar_;
    StationNote* note_;
};

}  // namespace fulcrum::ui
