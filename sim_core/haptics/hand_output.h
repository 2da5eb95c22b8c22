// SPDX-License-Identifier: Apache-2.0
// From the loads on an instrument to the force that its hand's device renders (docs/THEORY.md, sections 4 and
// 6):
//
//   1. virtual work through the trocar (lever.h), with the stiffness and damping as they are at the hand;
//   2. the force scale of the device;
//   3. Eq. 8 with the device's own b and greatest stiffness, for the largest eigenvalue: B is reduced first,
//   then K
//      in the directions that are too stiff;
//   4. safety (safety.h) within the device's peak force and what its motors hold for long;
//   5. the passivity controller on the motion of the hand, while Eq. 8 softens the model or where the scene
//   asks
//      for it.
// What is recorded and scored of the tissue is not touched. Haptic thread: no allocation, lock or exception;
// the result is finite and within the device's limits for every input.
#pragma once

#include <optional>

#include "sim_core/contact/tool_contact.h"
#include "sim_core/haptics/safety.h"
#include "sim_core/haptics/stability.h"
#include "sim_core/instrument/device.h"

namespace fulcrum {

/// One hand at one tick; loads are those of the instrument on what it touches.
struct HandTick {
    Vector3 handle = Vector3::Zero();  ///< m, from the trocar, of the instrument that the loads act on
    Vector3 device = Vector3::Zero();  ///< m, where the device is, in any fixed frame turned as the patient's
    SplitLoad load;                    ///< tissue and the other instrument
    SplitLoad old_load;                ///< by the model before, at this pose; read if model_changed
    bool model_changed = false;
    std::uint32_t model_age = 0;  ///< ticks
    bool connected = true;        ///< the device answers and the attempt is not paused
    double carried = 0;           ///< m, by which the other instrument or its hand moved against this one
};

/// What the device gets.
struct HandForce {
    Vector3 force = Vector3::Zero();  ///< N on the hand, patient frame
    double torque = 0;                ///< N m about the shaft
    std::uint16_t flags = 0;          ///< SafetyFlag mask
    bool limited = false;             ///< Eq. 8 reduced B or K
    double stiffness = 0;             ///< N/m, largest that is rendered
};

class HandOutput {
  public:
    /// A hand without a force device until set_device. The limits are those of the scene.
    explicit HandOutput(const SafetyLimits& limits = {}, bool passivity_control = false)
        : limits_(limits), passivity_control_(passivity_control) {}

    /// None: no force is sent. A device with values that are not usable gets no force either.
    void set_device(const std::optional<ForceOutput>& device);
    /// As new, with the same device and the warmth of its motors: force begins at zero.
    void restart() noexcept;
    bool has_device() const { return device_.has_value(); }
    HandForce step(const HandTick& tick) noexcept;

  private:
    Vector3 move(const HandTick& tick) noexcept;
    double peak_now(double sent) noexcept;
    double explained(const HandTick& tick, const Matrix3& stiffness, double damping,
                     const Vector3& velocity) noexcept;
    Vector3 keep_passive(const Vector3& force, const Vector3& velocity, bool touching) noexcept;
    double share_of_model(double stiffest, double allowed) noexcept;
    double slew_torque(double wanted, bool live) noexcept;

    SafetyLimits limits_;
    bool passivity_control_;
    std::optional<ForceOutput> device_;
    SafetyState safety_;
    PassivityController passivity_;
    double share_ = 1;                       // of the model's force
    double foreseen_ = 0;                    // J to the hand, by the force sent last
    Vector3 sent_before_ = Vector3::Zero();  // N
    double heat_ = 0;  // N2, mean square of the force sent, over the motors' time constant
    Vector3 device_before_ = Vector3::Zero(), handle_before_ = Vector3::Zero(),
            velocity_before_ = Vector3::Zero();
    bool moved_before_ = false;
    double slope_before_ = 0;  // N/m
    double torque_sent_ = 0;
};

/// m, lever over which a torque about the shaft follows at the force's slew limit.
inline constexpr double slew_arm = 0.01;

/// Largest eigenvalue of a symmetric matrix; 0 if it is not finite.
double largest_eigenvalue(const Matrix3& matrix);

}  // namespace fulcrum
