// SPDX-License-Identifier: Apache-2.0
// One arm of a synthetic operator: minimum-jerk sub-movements that may overlap, signal-dependent noise,
// tremor and drift, jaws that close at a hand's pace, and the conversion from the wanted tip to the device's
// handle.
#pragma once

#include <array>

#include "assessment/operators/skill.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {

/// Allocates nothing, never throws. Patient frame, m, s.
class Limb {
  public:
    Limb(const Skill& skill, const InstrumentSpec& spec, double tick_period, const Random& random);

    /// Advances one tick; call once per tick, before sample().
    void tick() noexcept;
    /// The wanted position of the tip, with noise.
    Vector3 tip() const noexcept { return planned_ + wander_; }
    /// The position of the tip after all current sub-movements, without noise.
    Vector3 destination() const noexcept;
    /// Time until the last sub-movement ends; negative: since it ended.
    double remaining() const noexcept { return end_time_ - time_; }
    /// Starts a sub-movement with the individual's gain and noise towards a displacement from destination().
    /// `width` (m) is the size of the target: smaller takes longer. `slowness` multiplies the duration.
    void reach(const Vector3& displacement, double width, double slowness = 1) noexcept;
    /// A smooth movement of exactly this displacement in this time: for tissue that is held.
    void carry(const Vector3& displacement, double duration) noexcept;
    /// The share of the individual's noise of paths and their ends that this arm has from now on; 1 at first.
    void steady(double share) noexcept { steadiness_ = share; }
    /// Ends all sub-movements where they are, within a tenth of a second.
    void stop() noexcept;
    /// Wanted jaw opening (rad) and closing force (N); they change at the speed of a hand.
    void jaws(double opening, double grip) noexcept {
        jaw_wish_ = opening;
        grip_wish_ = grip;
    }
    /// The device's primary button: a blade cuts while it is held.
    void press(bool down) noexcept { pressed_ = down; }
    /// Buttons other than the primary one (DeviceButton mask) from now on.
    void hold_buttons(std::uint16_t buttons) noexcept { buttons_ = buttons; }
    double jaw() const noexcept { return jaw_; }
    double grip() const noexcept { return grip_; }
    /// The reading of the device.
    DeviceSample sample() noexcept;
    /// Time since the attempt began.
    double time() const noexcept { return time_; }
    Random& random() noexcept { return random_; }
    const InstrumentSpec& spec() const noexcept { return spec_; }
    const Trocar& trocar() const noexcept { return trocar_; }

  private:
    struct SubMovement {
        double start = 0, duration = 0;
        Vector3 displacement = Vector3::Zero();
    };
    void add(const SubMovement& movement) noexcept;
    /// One tick of a random walk that returns to zero: standard deviation `strength`, correlation time
    /// `time`.
    Vector3 wandering(const Vector3& value, double time, double strength) noexcept;

    Skill skill_;
    InstrumentSpec spec_;
    Trocar trocar_;
    double period_;
    Random random_;
    double time_ = 0, end_time_ = 0, steadiness_ = 1;
    std::array<SubMovement, 6> movements_;
    int count_ = 0;
    Vector3 settled_, planned_;
    Vector3 wander_ = Vector3::Zero();  // tremor + drift + path noise
    Vector3 path_raw_ = Vector3::Zero(), path_velocity_ = Vector3::Zero(), path_ = Vector3::Zero();
    Vector3 drift_raw_ = Vector3::Zero(), drift_ = Vector3::Zero();
    std::array<double, 3> phase_{}, frequency_{}, loudness_{};
    double jaw_ = 0, jaw_wish_ = 0, grip_ = 0, grip_wish_ = 0;
    bool pressed_ = false;
    std::uint16_t buttons_ = 0;
    DeviceSample last_;
};

/// Goal-directed movement on top of a limb: a first sub-movement, then corrections until the goal is near
/// enough.
class Reach {
  public:
    explicit Reach(const Skill& skill) : skill_(skill) {}
    /// A new goal: the first sub-movement starts after `delay` s and misjudges depth along `view` (unit).
    /// `patience` multiplies the distance that counts as near enough.
    void start(Limb& limb, const Vector3& goal, const Vector3& view, double width, double delay,
               double patience = 1) noexcept;
    /// The goal has moved a little (tissue moves, a press is adjusted); what was misjudged stays so.
    void follow(const Vector3& goal) noexcept { goal_ = goal; }
    /// Decides about the next sub-movement; `seen` is the tip as it was seen a reaction time ago.
    void update(Limb& limb, const Vector3& seen) noexcept;
    /// Near enough, and no sub-movement under way.
    bool arrived() const noexcept { return arrived_; }
    /// The first sub-movement has begun.
    bool started() const noexcept { return !first_; }
    int corrections() const noexcept { return corrections_; }

  private:
    Skill skill_;
    Vector3 goal_ = Vector3::Zero(), misjudged_ = Vector3::Zero();
    double next_ = 0, width_ = 0.01, tolerance_ = 0.001;
    int corrections_ = 0;
    bool arrived_ = true, first_ = false;
};

}  // namespace fulcrum
