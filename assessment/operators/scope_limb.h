// SPDX-License-Identifier: Apache-2.0
// The hands that hold a scope where it is the only instrument: one moves the lens as a limb moves a tip, the
// other turns light post and camera head.
#pragma once

#include "assessment/operators/limb.h"
#include "assessment/operators/skill.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/random.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Allocates nothing, never throws. Patient frame, m, rad, s.
class ScopeLimb {
  public:
    ScopeLimb(const Skill& skill, const CameraSpec& camera, double tick_period, const Random& random);

    /// Advances one tick; returns the reading of the scope's device.
    DeviceSample tick() noexcept;
    /// The limb that moves the lens.
    Limb& lens() noexcept { return lens_; }
    /// Starts a turn to an angle, at a hand's pace; replaces one under way.
    void turn_post(double angle) noexcept { post_.start(angle, time_, pace_); }
    void turn_head(double angle) noexcept { head_.start(angle, time_, pace_); }
    /// Where the turns lead, rad.
    double post() const noexcept { return post_.to; }
    double head() const noexcept { return head_.to; }
    /// Whether a turn is under way.
    bool turning() const noexcept { return time_ < post_.end() || time_ < head_.end(); }
    double time() const noexcept { return time_; }
    const ScopeModel& model() const noexcept { return model_; }

    /// The scope's pose with the lens at a place and these turns.
    CameraPose pose(const Vector3& lens, double post, double head) const noexcept;

  private:
    struct Turn {
        double from = 0, to = 0, begin = 0, duration = 0;  // rad, s
        double at(double time) const noexcept;
        double end() const noexcept { return begin + duration; }
        void start(double angle, double now, double pace) noexcept;
    };

    Limb lens_;
    ScopeModel model_;
    double period_, pace_, time_ = 0;
    Turn post_, head_;
    DeviceSample last_;
};

}  // namespace fulcrum
