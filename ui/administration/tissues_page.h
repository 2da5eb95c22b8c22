// SPDX-License-Identifier: GPL-3.0-or-later
// What blades meet in a task's tissues: the scene's values, and the site's own in their place, set by
// educators with a reason. Directors read.
#pragma once

#include <vector>

#include "ui/page/context.h"

class QFrame;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class TissuesPage : public Page {
    Q_OBJECT
  public:
    explicit TissuesPage(Context& context);
    void enter() override;

  private:
    QWidget* build_editor();
    /// A blade cuts its tissue, or this site has values for tissue of it.
    bool is_listed(const TaskDefinition& task) const;
    void fill();
    void select();
    void show_values();
    void show_history();
    void save();
    void back_to_scene();
    void set(const database::TissueValues& values, const QString& said);
    std::string task_id() const;

    std::vector<std::string> tasks_;  ///< in the order of the list
    SiteTissues site_;
    QListWidget* list_;
    QTableWidget *table_, *history_;
    QLabel* no_history_;
    QLabel* trouble_;                ///< why no attempt can begin
    QLabel *state_, *note_, *none_;  ///< none_: shown where no task has such tissue
    QWidget* editor_;
    QLineEdit* reason_;
    QPushButton *save_, *back_;
    QFrame* change_;
    std::vector<QLineEdit*> edits_;  ///< in the order of site_.values
};

}  // namespace fulcrum::ui
