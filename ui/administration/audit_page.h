// SPDX-License-Identifier: GPL-3.0-or-later
// The audit log: who did what, in which role, when and to whom, newest first; by person, kind and period.
// Above it whether the chain holds. What is said of an attempt is withheld here (database/store/audit.h).
#pragma once

#include <vector>

#include "database/store/audit.h"
#include "ui/page/context.h"

class QComboBox;
class QDateEdit;
class QLabel;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;

class AuditPage : public Page {
    Q_OBJECT
  public:
    explicit AuditPage(Context& context);
    void enter() override;
    void leave() override;
    /// Rows asked for at a time.
    static constexpr int at_once = 200;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* build_filters();
    void fill_people();
    void fill_kinds(const std::vector<std::string>& found);
    void load();
    void load_older();
    void show_entries(const std::vector<database::AuditEntry>& entries);
    /// Reads the whole log in the background: whether it holds, and which kinds of rows it has.
    void verify();
    database::AuditFilter filter() const;

    QLabel *chain_, *count_;
    QComboBox *person_, *kind_, *period_;
    QWidget* days_;
    QDateEdit *from_, *until_;
    QTableWidget* table_;
    QPushButton* older_;
    std::int64_t oldest_ = -1;  ///< sequence of the last row shown
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
