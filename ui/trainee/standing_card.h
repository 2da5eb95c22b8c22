// SPDX-License-Identifier: GPL-3.0-or-later
// Where a person stands in one task, the decisions of educators on it, and for those who may decide: unlock
// the task, declare the person proficient or confirm a check that is due, with a reason.
#pragma once

#include "ui/page/context.h"

class QComboBox;
class QLineEdit;
class QVBoxLayout;

namespace fulcrum::ui {

class StandingCard : public QWidget {
    Q_OBJECT
  public:
    explicit StandingCard(Context& context);
    /// Hidden for a task that does not belong to the curriculum.
    void show_task(const std::string& person_id, const std::string& task_id);

  signals:
    /// The standing has changed, and with it what follows from it: certificates, the version that is
    /// followed.
    void decided();

  private:
    void fill();
    void decide();

    Context& context_;
    std::string person_id_, task_id_;
    QVBoxLayout* lines_;
    QWidget* decision_;
    QComboBox* kind_;
    QLineEdit* reason_;
};

}  // namespace fulcrum::ui
