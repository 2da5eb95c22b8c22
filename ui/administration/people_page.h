// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts: add people, alone or from a list, change names, logins and roles, one-time passwords, deactivate;
// the sign-in picker. No scores here.
#pragma once

#include <string>
#include <vector>

#include "database/records/people.h"
#include "ui/page/context.h"

class QCheckBox;
class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class ImportCard;
class MergeCard;

class PeoplePage : public Page {
    Q_OBJECT
  public:
    explicit PeoplePage(Context& context);
    void enter() override;
    void leave() override;
    QStringList begun_input(Ending ending) const override;
    /// A one-time password that is shown until it is handed over, for the page that is made in place of this
    /// one.
    struct Issued {
        std::string person_id;
        QString who;
        std::string password;
    };
    const std::vector<Issued>& issued() const { return issued_; }
    /// Next to those that are shown; in place of an earlier one of the same person, which has ended.
    void show_issued(const Issued& issued);

  private:
    QFrame* build_editor();
    QFrame* build_add();
    void fill();
    void select();
    const database::Person* selected() const;
    void add();
    void save();
    void issue();
    void toggle_active();

    std::vector<database::Person> people_;
    std::vector<Issued> issued_;
    QTableWidget* table_;
    QLineEdit *new_login_ = nullptr, *new_name_ = nullptr, *name_ = nullptr, *login_ = nullptr;
    std::vector<QCheckBox*> new_roles_, roles_;
    QLabel *who_ = nullptr, *secret_text_ = nullptr;
    QFrame *editor_ = nullptr, *secret_ = nullptr;
    QPushButton* active_ = nullptr;
    QCheckBox* picker_ = nullptr;
    ImportCard* import_ = nullptr;
    MergeCard* merge_ = nullptr;
};

}  // namespace fulcrum::ui
