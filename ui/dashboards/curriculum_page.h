// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum: its tasks by stage with their pass rules, and what another rule would do. Rules that are
// tried are written as the file of a new version; the curriculum in force is not changed here.
#pragma once

#include <map>
#include <string>

#include "assessment/learning/pass_rule.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace fulcrum {
struct Curriculum;
}

namespace fulcrum::ui {

class PassRuleDesigner;

class CurriculumPage : public Page {
    Q_OBJECT
  public:
    explicit CurriculumPage(Context& context);
    void enter() override;

  private:
    QWidget* make_saving();
    const Curriculum& curriculum() const;
    std::string chosen() const;
    void fill();
    void write_line(int row);
    void show_task();
    void try_rule();
    void restore();
    void look();
    void save();

    std::map<std::string, PassRule> tried_;  ///< by task, those that differ from the rule in force
    QLabel *title_, *task_name_, *facts_;
    QListWidget* tasks_;  ///< user data: id of the task
    PassRuleDesigner* designer_;
    QPushButton *restore_, *save_;
    QLineEdit* path_;
};

}  // namespace fulcrum::ui
