// SPDX-License-Identifier: GPL-3.0-or-later
// Which version of the curriculum a person follows and since when; for the person's educators, what another
// version would change and the move to it.
#pragma once

#include <QWidget>
#include <string>

#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class CurriculumCard : public QWidget {
    Q_OBJECT
  public:
    explicit CurriculumCard(Context& context);
    /// Hidden where the session may not read the person's progress.
    void show_person(const std::string& person_id);
    /// Reads again what is shown; a reason that was begun and the version that was chosen stay.
    void refresh();

  signals:
    /// Standings may have changed.
    void moved();

  private:
    void fill();
    void preview();
    void move();

    Context& context_;
    std::string person_id_;
    QVBoxLayout* lines_;
    QWidget* choice_;
    QComboBox* versions_;  ///< data: name
    QLineEdit* reason_;
    QLabel* changes_;
};

}  // namespace fulcrum::ui
