// SPDX-License-Identifier: GPL-3.0-or-later
// Changing one's own password: asked for at the first sign-in with a one-time password, offered at any other
// time.
#pragma once

#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class JobBar;

class PasswordPage : public Page {
    Q_OBJECT
  public:
    explicit PasswordPage(Context& context);
    void enter() override;
    /// No password stays on a page that is not shown.
    void leave() override;

  private:
    void change();
    QLabel *why_, *problem_;
    QLineEdit *old_, *new_, *again_;
    QPushButton *change_, *cancel_;
    JobBar* job_;
};

}  // namespace fulcrum::ui
