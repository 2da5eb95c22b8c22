// SPDX-License-Identifier: GPL-3.0-or-later
// The care of this machine: check its store (a sample of attempts is simulated again) and back it up, both in
// the background with progress and a way to stop; the key with which it signs; its programme server; the
// other stations.
#pragma once

#include "database/store/store.h"
#include "ui/page/context.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;
class ServerCard;
class StationsCard;

class StationPage : public Page {
    Q_OBJECT
  public:
    explicit StationPage(Context& context);
    void enter() override;
    void leave() override;
    void check();
    void back_up_to(const QString& path);

  private:
    QFrame* build_check();
    QFrame* build_backup();
    QFrame* build_key();
    /// Versions of the curriculum that people follow and that are not here.
    void show_curricula();
    void show_keys();
    void change_key();
    void ask_backup();
    static QString verdict_of(const database::CheckReport& report);
    void show_report(const database::CheckReport& report);
    void start(BackgroundJob* job, const QString& line);
    void ended();
    void free_buttons();

    QLabel *place_, *curricula_, *verdict_;
    QTableWidget *items_, *keys_;
    QFrame* key_card_;
    QLineEdit* key_reason_;
    QPushButton *check_, *backup_, *restore_, *restore_sure_, *change_key_;
    JobBar* bar_;
    ServerCard* server_;
    StationsCard* stations_;
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
