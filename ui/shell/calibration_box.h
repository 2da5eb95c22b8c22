// SPDX-License-Identifier: GPL-3.0-or-later
// A guided calibration of the device in use: what to do, what is read, what was stored and how long it is
// valid.
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class CalibrationBox : public QWidget {
    Q_OBJECT
  public:
    explicit CalibrationBox(Context& context);
    /// The device in use may be another one; hidden where there is nothing to calibrate.
    void show_device();
    void stop();

  private:
    void begin();
    void show_state();
    Context& context_;
    QComboBox* hand_;
    QLabel *when_, *step_, *seen_, *result_;
    QWidget* steps_;
    QPushButton *begin_, *next_, *skip_, *cancel_;
    QTimer timer_;
    bool ran_ = false;
};

}  // namespace fulcrum::ui
