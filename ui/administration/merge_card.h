// SPDX-License-Identifier: GPL-3.0-or-later
// On the page of people: merges the selected account into another one of the same person. First it says what
// follows, then it asks for the reason; it undoes a merge in the same place.
#pragma once

#include <QFrame>
#include <vector>

#include "database/records/people.h"
#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class MergeCard : public QFrame {
    Q_OBJECT
  public:
    explicit MergeCard(Context& context);
    /// Of `person`, among `people`; hidden for simulated people.
    void show_for(const database::Person& person, const std::vector<database::Person>& people);

  signals:
    void merged();

  private:
    void look();
    void merge();
    void undo();
    std::string chosen() const;
    Context& context_;
    std::string person_;
    QLabel *what_ = nullptr, *plan_ = nullptr;
    QWidget* choice_ = nullptr;
    QComboBox* into_ = nullptr;
    QLineEdit* reason_ = nullptr;
    QPushButton *merge_ = nullptr, *undo_ = nullptr;
};

}  // namespace fulcrum::ui
