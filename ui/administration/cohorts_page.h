// SPDX-License-Identifier: GPL-3.0-or-later
// Who belongs to which cohort, and which educators see it.
#pragma once

#include <vector>

#include "database/records/people.h"
#include "ui/page/context.h"

class QFrame;
class QLineEdit;
class QListWidget;

namespace fulcrum::ui {

class StationNote;

class CohortsPage : public Page {
    Q_OBJECT
  public:
    explicit CohortsPage(Context& context);
    void enter() override;
    QStringList begun_input(Ending ending) const override;

  private:
    void fill();
    void select();
    void add();
    void save();
    const database::Cohort* selected() const;

    std::vector<database::Cohort> cohorts_;
    std::vector<database::Person> people_;
    QListWidget *list_, *members_, *educators_;
    QLineEdit *new_name_, *name_;
    QFrame* editor_;
    StationNote* note_;
};

}  // namespace fulcrum::ui
