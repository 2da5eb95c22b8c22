// SPDX-License-Identifier: GPL-3.0-or-later
// For directors: what is stored about one person, a copy of it for that person, and its erasure; how long
// data of trainees are kept, and who is due. Nothing is erased without a look at what it is and a second
// press, which no key that is held does. What grows with the store is read and deleted in the background;
// what was begun to be erased is erased also after the page was left.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "database/records/people.h"
#include "database/sync/retention.h"
#include "ui/page/context.h"

class QCheckBox;
class QComboBox;
class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace fulcrum::database {
struct PersonDataExport;
}

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;

class PersonalDataPage : public Page {
    Q_OBJECT
  public:
    explicit PersonalDataPage(Context& context);
    void enter() override;
    void leave() override;
    QStringList begun_input(Ending ending) const override;
    /// Of the chosen person, to this new folder.
    void export_to(const QString& folder);

  private:
    QFrame* build_person();
    QFrame* build_retention();
    void fill_people();
    void look();
    /// Null: of nobody, or not read yet.
    void show_rows(const database::PersonDataExport* found);
    void erase();
    /// One that runs, begun here or before the page was made again.
    void follow_erasure(BackgroundJob* job);
    void show_retention();
    void show_due(std::vector<database::DuePerson> due, const QString& words);
    void save_retention();
    void erase_due();
    void update_buttons();
    std::string chosen() const;
    std::optional<int> chosen_months() const;
    void start(BackgroundJob* job, const QString& line);
    void ended();

    std::vector<database::DuePerson> due_;
    QFrame *person_card_, *retention_card_;
    QLabel* closed_;
    QComboBox* person_;
    QLabel *what_, *due_text_;
    QTableWidget *rows_, *due_table_;
    QLineEdit* reason_;
    QPushButton *export_, *erase_, *erase_sure_, *save_, *erase_due_, *erase_due_sure_;
    QCheckBox* limited_;
    QSpinBox* months_;
    JobBar *bar_, *look_bar_;
    BackgroundJob* job_ = nullptr;  ///< writes or erases
    BackgroundJob *look_job_ = nullptr, *due_job_ = nullptr;
    std::optional<int> kept_months_;  ///< as stored when they were shown
    bool entered_ = false;
};

}  // namespace fulcrum::ui
