// SPDX-License-Identifier: GPL-3.0-or-later
// Shows where the hands are, as the theatre's picture would: to the right is to the right. A hand that is
// moved in each of the three directions gets three marks.
#pragma once

#include <QWidget>

#include "ui/services/device_service.h"

namespace fulcrum::ui {

class FrameCheck : public QWidget {
    Q_OBJECT
  public:
    explicit FrameCheck(QWidget* parent = nullptr);
    void show_readings(const DeviceReadings& readings);
    /// Where the hands are now is the middle again, and no direction was seen.
    void begin_again();
    /// One line for each hand: its marks.
    QStringList lines() const;
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    struct Point {
        QString name;
        bool exists = false, known = false;
        Vector3 middle = Vector3::Zero();
        double right = 0, up = 0, away = 0;  ///< -1 to 1
        bool seen[3] = {false, false, false};
    };
    void follow(Point& point, double right, double up, double away);
    Point points_[3];
};

}  // namespace fulcrum::ui
