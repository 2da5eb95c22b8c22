// SPDX-License-Identifier: GPL-3.0-or-later
// Sign-in: a login field, and a picker of those who signed in here in the last 30 days. In the demo: the
// people of the demo, no password. Also the last administrator's way back with the recovery code.
#pragma once

#include "ui/page/context.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class JobBar;

class SignInPage : public Page {
    Q_OBJECT
  public:
    explicit SignInPage(Context& context);
    void enter() override;
    /// No password and no recovery code stays on a page that is not shown.
    void leave() override;

  signals:
    /// From the demo back to the first screen.
    void leave_demo();

  private:
    QFrame* build_recovery();
    QFrame* build_new_code();
    void set_busy(bool busy);
    void fill_picker();
    void fill_demo();
    void sign_in();
    void recover();

    QLabel *programme_, *problem_, *notice_, *new_code_;
    QFrame *form_, *picker_, *demo_, *recovery_;
    QFrame* new_code_card_;  ///< while there is a recovery code that nobody has confirmed
    QVBoxLayout *picker_list_, *demo_list_;
    QLineEdit *login_, *password_;
    QLineEdit *recovery_login_, *recovery_code_, *recovery_password_;
    QPushButton *button_, *recover_, *noted_;
    JobBar* job_;
    bool busy_ = false;
};

/// Runs People::sign_in on a worker thread and hands the session, or the refusal in words, to the UI thread.
class BackgroundJob;
BackgroundJob* sign_in_job(QObject* parent, const std::string& store_path, const std::string& login,
                           const std::string& password, std::optional<database::Role> role,
                           std::function<void(const database::Session&)> done,
                           std::function<void(const QString&)> refused);

}  // namespace fulcrum::ui
