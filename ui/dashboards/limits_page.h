// SPDX-License-Identifier: GPL-3.0-or-later
// What attempts are held against, set by set: the limits next to each other, who would pass under each, and
// the pass mark between the experts of a set and the attempts stored here. Nothing is changed here.
#pragma once

#include <string>
#include <vector>

#include "database/scoring/limit_trial.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class ChartFrame;
class GroupsChart;
class LimitsChart;
class StationNote;
class StoreReading;

class LimitsPage : public Page {
    Q_OBJECT
  public:
    explicit LimitsPage(Context& context);
    void enter() override;
    void leave() override;

  private:
    /// A set that is compared, and the file that it was added from ("": in force).
    struct Compared {
        BenchmarkSet set;
        QString file;
    };
    QWidget* make_choice();
    QWidget* make_adding();
    QFrame* make_groups();
    void choose_task();
    void choose_set();
    /// In the background; the limits are shown without attempts until then.
    void read_attempts();
    void add_file();
    void fill();
    void fill_table();
    void show_limits_of_site();
    void show_group();
    const TaskDefinition* task();
    std::vector<BenchmarkSet> in_force_;  ///< of the task, all device classes and variants
    std::vector<Compared> sets_;          ///< of one key; the first is in force
    std::vector<TriedAttempt> attempts_;  ///< of that key
    QComboBox *tasks_, *keys_, *metrics_;
    QLineEdit* path_;
    QPushButton* add_;
    QLabel *count_, *site_, *mark_;
    LimitsChart* chart_;
    GroupsChart* groups_;
    ChartFrame* groups_frame_;
    QTableWidget* table_;
    StationNote* note_;
    StoreReading* reading_;
};

}  // namespace fulcrum::ui
