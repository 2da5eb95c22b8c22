// SPDX-License-Identifier: GPL-3.0-or-later
// Sends attempts to other programs over OpenIGTLink: on or off, where, who listens.
#pragma once

#include <QFrame>
#include <QTimer>

#include "ui/page/context.h"

class QCheckBox;
class QLabel;

namespace fulcrum::ui {

class SendingCard : public QFrame {
    Q_OBJECT
  public:
    explicit SendingCard(Context& context);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void show_state();
    Context& context_;
    QCheckBox* wanted_;
    QLabel *state_, *trouble_;
    QTimer timer_;
};

}  // namespace fulcrum::ui
