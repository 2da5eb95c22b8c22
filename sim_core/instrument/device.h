// SPDX-License-Identifier: Apache-2.0
// The device interface: hand input as integers, quantised before anything uses it.
//
// A device is sampled once per haptic tick by the haptic thread. The reading is quantised here (0.1 um, 1e-6
// rad, 1 mN) and only the quantised sample is used or recorded, so an attempt is a pure function of its
// record.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "sim_core/instrument/rig_use.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr double device_length_unit = 1e-7;  ///< m per count
inline constexpr double device_angle_unit = 1e-6;   ///< rad per count
inline constexpr double device_force_unit = 1e-3;   ///< N per count

/// Buttons of one device, bit mask.
enum DeviceButton : std::uint16_t {
    button_none = 0,
    button_primary = 1,
    button_clutch = 2,
    button_energy = 4,
    button_exchange = 8
};

/// One device at one tick. The handle position is that of the instrument's handle in its trocar's frame
/// (origin at the pivot, +z into the body along the nominal shaft, +y up, +x completing a right-handed
/// frame): a handle outside the body has z < 0, and the tip is on the other side of the pivot (the fulcrum
/// effect).
struct DeviceSample {
    std::int32_t handle[3] = {0, 0, 0};  ///< 0.1 um
    std::int32_t roll = 0;               ///< 1e-6 rad, about the shaft, positive from trocar to tip
    std::int32_t jaw = 0;                ///< 1e-6 rad, requested jaw opening angle, 0 closed
    std::int32_t grip = 0;               ///< mN, requested closing force of the jaws, >= 0
    std::uint16_t buttons = 0;           ///< DeviceButton mask
    std::uint8_t present = 1;            ///< 0: the device did not answer this tick
    std::uint8_t faulty =
        0;  ///< 1: it answered with NaN, infinity or an impossible jump; the pose is the last good one
};
static_assert(sizeof(DeviceSample) == 28, "no hidden padding: the sample is hashed and stored");

/// All inputs of the simulation at one tick. Decisions that depend on the wall clock (pause, loss, which
/// thread was late) are inputs too, so that a replay repeats them.
struct RigSample {
    std::uint32_t tick = 0;
    std::uint32_t flags = 0;  ///< RigFlag mask
    DeviceSample hand[hand_count];
    /// The scope: handle in its own trocar frame, roll = light-post rotation, jaw = turn of the camera head
    /// against the shaft, positive counterclockwise as the camera looks.
    DeviceSample camera;
};
enum RigFlag : std::uint32_t {
    rig_paused = 1,
    rig_abandon = 2,
    rig_device_lost = 4,
    rig_world_late = 8,
    rig_end_confirmed = 16
};

/// The raw reading of a device before quantisation, SI units, trocar frame.
struct DeviceReading {
    Vector3 handle = Vector3::Zero();
    double roll = 0, jaw = 0, grip = 0;
    std::uint16_t buttons = 0;
    bool present = true;
};

/// Quantises a reading; a reading with NaN, infinity, or a handle more than 0.2 m from the previous sample
/// keeps the previous pose and is marked faulty. Never throws; any thread.
DeviceSample quantise(const DeviceReading& reading, const DeviceSample& previous);

/// What a hand's device can render, and how much of the model's force the person wants. The values are stored
/// with the attempt: with them a replay sends the same forces.
struct ForceOutput {
    double damping = 0;      ///< N s/m, b of the device, for Eq. 8; >= 0
    double peak = 10;        ///< N, largest force
    double continuous = 10;  ///< N, force that the motors hold for any time, <= peak
    double stiffness = 1e9;  ///< N/m, largest that the maker states; 1e9: none stated
    double torque = 0;       ///< N m, largest about the shaft; 0: no motor there
    double scale = 1;        ///< force sent over force of the model at the hand, > 0
    /// N/s, as slew_limit of the scene; the smaller of both holds. Infinity: that of the scene.
    double slew = std::numeric_limits<double>::infinity();
};

/// Every value in its range, and finite but for the slew.
bool is_usable(const ForceOutput& output);

/// Of both hands; none where a device renders no force.
using ForceDevices = std::array<std::optional<ForceOutput>, hand_count>;

/// A rig of two hands and a camera. Called only by the haptic thread, once per tick; must not block, allocate
/// or throw.
class Rig {
  public:
    virtual ~Rig() = default;
    /// Sets hands, camera and the flags that this rig is responsible for. `tick` is the haptic tick that
    /// starts.
    virtual void read(std::uint32_t tick, RigSample& sample) = 0;
    /// The force to render on a hand's device (N on the hand at the handle, patient frame), after safety.
    /// Devices without force ignore it.
    virtual void write_force(Hand hand, const Vector3& force) = 0;
    /// The torque to render about the shaft (N m on the hand, positive about the direction trocar to tip),
    /// after safety. Devices without a motor there ignore it.
    virtual void write_torque(Hand /*hand*/, double /*torque*/) {}
    /// True if the hand can feel force.
    virtual bool has_force(Hand hand) const = 0;
    /// Device damping b in N s/m for Eq. 8; negative if unknown or not applicable.
    virtual double damping(Hand hand) const = 0;
    /// What the hand's device can render; none: it renders no force, and 0 is sent. Constant during an
    /// attempt.
    virtual std::optional<ForceOutput> force_output(Hand hand) const;
    /// How it is set up and how often it was read so far; none: nobody's hands move it. Not while read()
    /// runs.
    virtual std::optional<RigUse> use() const { return std::nullopt; }
};

}  // namespace fulcrum
