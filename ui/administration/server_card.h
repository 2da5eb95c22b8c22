// SPDX-License-Identifier: GPL-3.0-or-later
// The programme server of this station: enrol with a token, exchange now. Both run in the background.
#pragma once

#include <QFrame>
#include <functional>

#include "database/sync/sync.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class BackgroundJob;

class ServerCard : public QFrame {
    Q_OBJECT
  public:
    explicit ServerCard(Context& context);
    /// What the station is enrolled for, or the form to enrol it.
    void show_link();
    /// While the page has other work to do.
    void set_busy(bool busy);

  signals:
    /// A job that the page's bar is to show; it ends with it.
    void started(BackgroundJob* job, const QString& line);
    void ended();

  private:
    QWidget* make_form();
    QWidget* make_link();
    void enrol();
    void exchange();
    void run(const QString& line, std::function<database::SyncResult(const database::SyncOptions&)> work);
    void show_result(const database::SyncResult& result);
    void update_buttons();

    Context& context_;
    QWidget *form_, *link_;
    QLineEdit *address_, *token_;
    QPushButton *enrol_, *exchange_, *again_;
    QLabel *place_, *scope_, *last_, *result_;
    bool busy_ = false, linked_ = false;
};

}  // namespace fulcrum::ui
