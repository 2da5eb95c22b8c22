// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown while the window is locked: nothing of the content; the password of the person who is signed
// in, or another user.
#pragma once

#include <QPointer>

#include "ui/page/background_job.h"
#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class LockPage : public Page {
    Q_OBJECT
  public:
    explicit LockPage(Context& context);
    void enter() override;
    void set_notice(const QString& line);

  signals:
    void unlocked();
    void switch_user();

  private:
    void unlock();
    QLabel *who_, *notice_, *problem_;
    QLineEdit* password_;
    QPushButton *unlock_, *other_;
    JobBar* job_;
    QPointer<BackgroundJob> checking_;  ///< the password
};

}  // namespace fulcrum::ui
