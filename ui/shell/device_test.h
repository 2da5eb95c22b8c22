// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the device in use without an attempt: opens it, shows where the hands are and whether each direction
// is right, gives a gentle force that can be stopped at any time, and sets how it moves the instruments.
// Shows only what the device can do.
#pragma once

#include <QWidget>

#include "ui/page/context.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class CalibrationBox;
class FrameCheck;
class WorkspaceFit;

class DeviceTest : public QWidget {
    Q_OBJECT
  public:
    explicit DeviceTest(Context& context);
    /// Called with each new reading; null: the device is not open.
    void show_readings(const DeviceReadings* readings, bool trouble);
    /// The device in use may be another one.
    void show_settings();
    /// Nothing runs after it.
    void stop();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QWidget* build_try();
    QWidget* build_settings();
    void show_force();
    void show_clutch(const DeviceReadings& readings);
    QWidget* build_pedal();
    void change_slots(int changed);
    Context& context_;
    QPushButton *open_, *force_, *stop_, *again_, *shake_;
    QLabel *marks_, *force_line_, *motion_note_, *away_note_, *clutch_note_;
    QWidget *tried_, *slots_row_, *pedal_row_;
    FrameCheck* frame_;
    WorkspaceFit* reach_;
    CalibrationBox* calibration_;
    QComboBox *motion_, *slot_[3], *pedal_;
    QCheckBox* rumble_;
    bool was_open_ = false, forced_ = false, gives_force_ = false;
};

}  // namespace fulcrum::ui
