// SPDX-License-Identifier: Apache-2.0
// The hand that holds the scope: it re-aims when the point of attention leaves the middle of the image.
#pragma once

#include "assessment/operators/skill.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// Allocates nothing, never throws. A scene without a camera has a hand that never moves.
class CameraHand {
  public:
    CameraHand(const Skill& skill, const Scene& scene);
    /// The point of attention, m; call once per decision.
    void look_at(const Vector3& point) noexcept;
    /// Advances one tick; returns the reading of the scope's device.
    DeviceSample tick() noexcept;
    /// Line of sight of the last sample, unit.
    Vector3 view() const noexcept { return view_; }

  private:
    void renew(const Vector3& axis) noexcept;

    bool present_ = false;
    double period_ = 1e-3, duration_ = 1, limit_ = 0.45, insertion_ = 0.05;
    ScopeModel scope_;
    CameraPose pose_;
    DeviceSample sample_;
    Vector3 from_ = Vector3(0, 0, -1), to_ = Vector3(0, 0, -1), view_ = Vector3(0, -0.70710678, -0.70710678);
    double progress_ = 1;  ///< of the re-aiming, 0 .. 1
};

}  // namespace fulcrum
