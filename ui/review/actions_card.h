// SPDX-License-Identifier: GPL-3.0-or-later
// What may be done about an attempt that is wrong: the educator voids it or reassigns it to the person who
// performed it, the trainee asks for either. Shows only what the role may do to this attempt.
#pragma once

#include "database/records/attempts.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class ActionsCard : public QWidget {
    Q_OBJECT
  public:
    explicit ActionsCard(Context& context);
    void open(const database::AttemptSummary& attempt);

  signals:
    /// The attempt was voided or reassigned.
    void changed();

  private:
    /// The reason typed; empty after having said that one is needed.
    std::string reason(const QString& missing);
    void fill_people();
    void void_attempt();
    void reassign();
    void ask_correction();

    Context& context_;
    std::string attempt_id_, person_id_;
    QLabel* hint_;
    QLineEdit* reason_;
    QPushButton *void_, *void_sure_, *reassign_, *request_;
    QWidget* right_person_row_;
    QComboBox* right_person_;
};

}  // namespace fulcrum::ui
