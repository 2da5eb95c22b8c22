// SPDX-License-Identifier: GPL-3.0-or-later
// Shown where the store cannot be used, with what is wrong and what can be done; and where an administrator,
// or whoever sets up a new machine, wants to put a backup in its place. No store is open while it is shown.
#pragma once

#include "database/store/backup_list.h"
#include "ui/page/context.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;

class RepairPage : public Page {
    Q_OBJECT
  public:
    explicit RepairPage(Context& context);
    void enter() override;
    void leave() override;
    /// `damaged`: the file itself, so that a backup can help; else something is in its way.
    void show_trouble(const QString& problem, const QString& hint, bool damaged);
    /// Nothing is wrong: a backup is to take the store's place.
    void show_restore();
    /// Adds the backups of this folder.
    void look_in(const QString& folder);
    /// The store is this file from now on.
    void open_other(const QString& file);

  signals:
    /// Also after something was done: open the store.
    void try_again();
    void look_around_wanted();
    /// The backup is in place, and what to say about it.
    void restored(const QString& line);

  private:
    QFrame* build_problem();
    QFrame* build_restore();
    QFrame* build_other_ways();
    void look();
    void show_backups();
    const database::FoundBackup* selected() const;
    void update_buttons();
    void restore();
    void put_aside();
    void set_busy(bool busy);
    std::string store_path() const;

    QLabel *title_, *problem_, *place_, *searched_, *refused_;
    QFrame *problem_card_, *restore_card_, *other_card_, *aside_confirm_;
    QPushButton *again_, *restore_, *folder_, *aside_, *other_, *look_around_, *quit_;
    QTableWidget* table_;
    QLineEdit *login_, *password_;
    JobBar *search_bar_, *restore_bar_;
    BackgroundJob* job_ = nullptr;  ///< the search or the restore, one at a time
    std::vector<database::FoundBackup> backups_;
    std::vector<std::string> folders_;
    bool damaged_ = false, trouble_ = false, busy_ = false;
};

}  // namespace fulcrum::ui
