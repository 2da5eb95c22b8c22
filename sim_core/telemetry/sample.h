// SPDX-License-Identifier: Apache-2.0
// One tick of an attempt as it is recorded. Integers only, so that the record and the live run are the same
// numbers.
#pragma once

#include <cstdint>

#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr double sample_length_unit = 1e-7;  ///< m per count (0.1 um)
inline constexpr double sample_axis_unit = 1e-8;    ///< per count of a unit vector or quaternion component
inline constexpr double sample_angle_unit = 1e-6;   ///< rad per count
inline constexpr double sample_force_unit = 1e-3;   ///< N per count
inline constexpr double sample_area_unit = 1e-9;    ///< m2 per count (1e-3 mm2)
inline constexpr double sample_torque_unit = 1e-5;  ///< N m per count

enum HandFlag : std::uint16_t {
    hand_inside = 1,     ///< the tip is inside the body (insertion > 0)
    hand_in_view = 2,    ///< the tip is in the camera image and not hidden by the image's border
    hand_energy = 4,     ///< energy is on
    hand_grasping = 8,   ///< the jaws hold tissue or an object
    hand_warned = 16,    ///< the trainee was being warned at this tick
    hand_clamped = 32,   ///< the device force was limited at this tick
    hand_faulty = 64,    ///< the device answered with NaN, infinity or a jump at this tick
    hand_cutting = 128,  ///< the instrument's blade was in the tissue at this tick
};

/// One instrument at one tick; patient frame.
struct HandSample {
    std::int32_t tip[3] = {0, 0, 0};   ///< 0.1 um
    std::int32_t axis[3] = {0, 0, 0};  ///< 1e-8, unit vector trocar to tip
    std::int32_t roll = 0;             ///< 1e-6 rad
    std::int32_t jaw_angle = 0;        ///< 1e-6 rad, actual opening
    std::int32_t force[3] = {
        0, 0, 0};  ///< mN, instrument on tissue (not on the other instrument), the model's, before any clamp
    std::int32_t device_force[3] = {0, 0, 0};  ///< mN, sent to the hand, after safety
    std::int32_t torque[3] = {
        0, 0, 0};                ///< 1e-5 N m, of `force` about the trocar: with it the wrench on the tissue
    std::int32_t jaw_force = 0;  ///< mN
    std::int32_t jaw_area = 0;   ///< 1e-9 m2
    std::int16_t tissue = -1;    ///< index into the scene's tissue table, -1 none
    std::int16_t patch = -1;     ///< tissue patch under the jaws or the contact, -1 none
    std::uint16_t flags = 0;     ///< HandFlag mask
    std::uint16_t filter_grade = 0;  ///< Eq. 3 at the contact; 0 without contact
};

struct CameraSample {
    std::int32_t tip[3] = {0, 0, 0};  ///< 0.1 um
    std::int32_t orientation[4] = {100000000, 0, 0,
                                   0};  ///< 1e-8, quaternion w x y z, camera (-z forward, +y up) to patient
};

/// Everything that left the loop at one tick.
struct TickSample {
    std::uint32_t tick = 0;
    std::uint32_t rig_flags = 0;   ///< RigFlag mask of the input
    std::uint32_t model_step = 0;  ///< world step whose local model made this tick's force
    std::uint32_t missed = 0;      ///< ticks missed so far, all causes
    HandSample hand[hand_count];
    CameraSample camera;
};

/// One world step: which input ticks it consumed, and the hash of the state it left (0 unless a hash tick
/// fell in it).
struct StepRecord {
    std::uint32_t step = 0;
    std::uint32_t first_tick = 0;
    std::uint32_t last_tick = 0;
    std::uint32_t outcome = 0;  ///< 0 ok, 1 substepped, 2 part frozen, 3 restored, 4 simulator fault
    std::uint64_t state_hash = 0;
};

}  // namespace fulcrum
