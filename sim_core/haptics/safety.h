// SPDX-License-Identifier: Apache-2.0
// Safety layer between the model's force and a hand (docs/THEORY.md, section 4, Safety).
//
//  * Size: clamped to the limit, direction kept.
//  * Slew (0.3 N/ms): acts on changes of the model, on loss and on resume. After such a change the sent
//    force continues from its last value and the difference decays at the slew rate; the force from a moving
//    hand is not slowed.
//  * Jumps: a force that changes by more than the hand's own motion can explain (another facet, another shaft
//    or the other side of one) counts as a change of model: the unexplained part decays like the difference
//    of a swap. The change due to the hand's motion counts against the slew first, so that both together stay
//    within it.
//  * Start ramp: after a start or resume the force rises from 0 over ramp_ticks.
//  * Watchdog: a model older than age_limit ticks, an absent device, a pause or a non-finite force reduces
//    the force to 0 at the slew rate.
// Logged and scored force is the model's, before this layer. Haptic thread: no allocation, lock or exception;
// the result is finite and within the limit for every input.
#pragma once

#include <cstdint>
#include <limits>

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct SafetyLimits {
    double force = 10.0;           ///< N
    double slew = 300.0;           ///< N/s
    double tick_period = 1e-3;     ///< s
    std::uint32_t age_limit = 40;  ///< ticks; 0: no limit (a model without a world)
    std::uint32_t ramp_ticks = 300;
};

/// One hand, one tick.
struct SafetyInput {
    Vector3 force = Vector3::Zero();  ///< N, force on the hand that the model in use gives at this pose
    Vector3 old_force =
        Vector3::Zero();          ///< N, force of the previous model at this pose; read if model_changed
    bool model_changed = false;   ///< the force comes from a different model than at the previous tick
    std::uint32_t model_age = 0;  ///< ticks since the pose of the model
    bool connected = true;        ///< the device answers and the attempt is not paused
    /// N, largest change of the force that the hands' motion since the last tick can cause; infinity:
    /// unknown.
    double explained = std::numeric_limits<double>::infinity();
};

enum SafetyFlag : std::uint16_t {
    safety_clamped = 1,      ///< the size limit acted
    safety_slewed = 2,       ///< a difference is decaying
    safety_ramping = 4,      ///< the start ramp is below 1
    safety_stale = 8,        ///< the model is older than the limit
    safety_not_finite = 16,  ///< the model's force was not finite
};

struct SafetyOutput {
    Vector3 force = Vector3::Zero();  ///< N, to the device
    std::uint16_t flags = 0;          ///< SafetyFlag mask
};

/// State of one hand; copyable.
struct SafetyState {
    Vector3 sent = Vector3::Zero();        ///< N, last force sent
    Vector3 difference = Vector3::Zero();  ///< N, decaying
    Vector3 target = Vector3::Zero();      ///< N, force of the model at the last tick
    std::uint32_t ramp = 0;                ///< ticks since the start or resume
    bool live = false;                     ///< the last tick rendered the model
};

SafetyOutput step_safety(const SafetyLimits& limits, const SafetyInput& input, SafetyState& state);

/// Shortens a force to the limit, keeping its direction; a non-finite force becomes zero.
Vector3 clamp_force(const Vector3& force, double limit, bool* clamped = nullptr);

}  // namespace fulcrum
