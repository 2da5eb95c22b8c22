// SPDX-License-Identifier: GPL-3.0-or-later
// Waits before an attempt until the handles of a device are where the scene is in the middle of their
// workspace, where the person chose that (page of settings). Nothing is on the clock yet; Enter begins at
// once.
#pragma once

#include <QStringList>

#include "assessment/attempt/scene_reach.h"
#include "ui/services/device_service.h"

namespace fulcrum::ui {

/// "23 mm to the left, 10 mm up": parts below 1 mm are left out; empty where all are.
QString step_words(const Vector3& step);

/// The part of the device that moves this hand and has a workspace; null: none.
const DeviceReadings::Slot* slot_of_hand(const DeviceReadings& readings, const SlotChoice& choice, int hand);

class BeginPlace {
  public:
    /// Of a new attempt.
    void reset() { *this = BeginPlace(); }
    /// What to do, a line for each hand that is not there; none: the attempt may begin.
    QStringList look(DeviceService& devices, const Scene& scene, const WorldSnapshot& at_start);
    /// The person does not want to wait.
    void skip() { done_ = true; }

  private:
    bool known_ = false, done_ = false;
    SceneReach reach_;
};

}  // namespace fulcrum::ui
