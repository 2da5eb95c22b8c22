// SPDX-License-Identifier: GPL-3.0-or-later
// Sound during attempts: on or off, how loud, a test, and why there is none.
#pragma once

#include <QFrame>
#include <QTimer>

#include "ui/page/context.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class SoundCard : public QFrame {
    Q_OBJECT
  public:
    explicit SoundCard(Context& context);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void choose();
    void show_state();
    Context& context_;
    QCheckBox* wanted_;
    QComboBox* volume_;
    QPushButton* test_;
    QLabel* trouble_;
    QTimer timer_;
};

}  // namespace fulcrum::ui
