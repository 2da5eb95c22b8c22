// SPDX-License-Identifier: GPL-3.0-or-later
// How far a device reaches in a task's scene: pictures of each hand's workspace, what share of the scene is
// reached, where to hold the handle when an attempt begins, and a button that chooses the scale of the
// movement with which all of it is reached. Hidden where the device states no workspace.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/page/context.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class BackgroundJob;
class WorkspaceView;

/// The scales that can be chosen, in percent.
inline constexpr int motion_percents[] = {50, 75, 100, 125, 150, 175, 200};
/// The smallest of them, from 100 % on, with which the device reaches all of the scene with some room to
/// spare; the largest where none does.
int fitting_percent(double scale_to_fit);

class WorkspaceFit : public QWidget {
    Q_OBJECT
  public:
    /// `changed`: another scale was chosen.
    WorkspaceFit(Context& context, std::function<void()> changed);
    void show_readings(const DeviceReadings& readings);

  private:
    void look();
    void fit();
    void draw();
    QString line_of(int hand, const DeviceReadings::Slot& slot, double motion);
    /// The part of the device that moves this hand; null: none.
    const DeviceReadings::Slot* slot_of(int hand) const;

    Context& context_;
    std::function<void()> changed_;
    QComboBox* task_;
    WorkspaceView* view_[hand_count];
    QLabel* lines_;
    QPushButton* fit_;
    QCheckBox* ring_;
    DeviceReadings readings_;
    SceneReach reach_;
    std::string known_;  ///< task that reach_ is of
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
