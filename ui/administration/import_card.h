// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts for many people from a list: what would be done is shown before anything is, and the one-time
// passwords go to a file that only its owner can read.
#pragma once

#include <QFrame>
#include <vector>

#include "database/roster/roster_import.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;

class ImportCard : public QFrame {
    Q_OBJECT
  public:
    explicit ImportCard(Context& context);
    ~ImportCard() override;
    /// Stops a running import, or the reading of a list; who was created before keeps a password in the file.
    void stop();

  signals:
    /// Accounts were created or changed. Only while somebody is signed in.
    void imported();

  private:
    QWidget* make_path_row();
    void choose(bool folder);
    /// Reads the list in the background and shows what an import would do.
    void look();
    void stop_looking();
    void show_plan();
    void import();
    void finish(const std::vector<database::PersonImport>& steps, const QString& passwords);
    void forget();

    Context& context_;
    std::vector<database::PersonImport> plan_;
    QStringList left_out_;
    QLineEdit *path_, *passwords_;
    QPushButton *look_, *import_;
    QTableWidget* table_;
    QLabel* summary_;
    QWidget* details_;
    JobBar* bar_;
    BackgroundJob *job_ = nullptr, *look_job_ = nullptr;
};

}  // namespace fulcrum::ui
