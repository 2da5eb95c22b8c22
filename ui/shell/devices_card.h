// SPDX-License-Identifier: GPL-3.0-or-later
// The devices for the hands: what is connected, what is not, why and what to do; the newest readings of the
// one in use; a test of it; how it moves the instruments and how much of the model's force it gives.
#pragma once

#include <QFrame>
#include <QTimer>

#include "ui/page/context.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class BackgroundJob;
class DeviceTest;

/// A text of the list of devices in the reader's language; what the system says stays as it is.
QString device_words(const std::string& english);

class DevicesCard : public QFrame {
    Q_OBJECT
  public:
    explicit DevicesCard(Context& context);
    /// Looks for devices in the background, unless it is looking already.
    void look();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* build_force();
    void show_use();
    void show_readings();
    void show_list(const std::vector<ListedDevice>& devices);
    Context& context_;
    QLabel *use_, *trouble_, *readings_;
    QWidget* force_;
    DeviceTest* test_;
    QComboBox* scale_;
    QVBoxLayout* list_;
    QPushButton* again_;
    QString shown_;  ///< what the list was made from
    BackgroundJob* job_ = nullptr;
    QTimer look_timer_, readings_timer_;
};

}  // namespace fulcrum::ui
