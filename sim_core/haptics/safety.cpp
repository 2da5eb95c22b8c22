// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/safety.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double largest_sensible = 1e12;  // N: larger forces are scaled down before squares overflow
constexpr double least_share = 0.1;  // of the slew by which a difference decays, however fast the hand moves

bool usable(const Vector3& force) {
    return force.allFinite() && force.cwiseAbs().maxCoeff() < largest_sensible;
}

// Shortens a vector by a length without changing its direction; true while something remains.
bool shrink(Vector3& vector, double length) {
    const double norm = vector.norm();
    if (!(norm > length * (1 + 1e-9))) {
        vector.setZero();
        return false;
    }
    vector *= (norm - length) / norm;
    return true;
}

}  // namespace

Vector3 clamp_force(const Vector3& force, double limit, bool* clamped) {
    bool acted = false;
    Vector3 result = force;
    if (!force.allFinite()) {
        result.setZero();
        acted = true;
    } else {
        const double largest = force.cwiseAbs().maxCoeff();
        if (largest > largest_sensible) {  // scaled first, so that the norm does not overflow
            result = force / largest;
            result *= limit / result.norm();
            acted = true;
        } else if (const double norm = force.norm(); norm > limit) {
            result = force * (limit / norm);
            acted = true;
        }
    }
    if (clamped != nullptr) *clamped = acted;
    return result;
}

SafetyOutput step_safety(const SafetyLimits& limits, const SafetyInput& input, SafetyState& state) {
    SafetyOutput output;
    const bool finite = usable(input.force);
    const bool stale = limits.age_limit > 0 && input.model_age > limits.age_limit;
    const bool live = finite && !stale && input.connected;
    if (!finite) output.flags |= safety_not_finite;
    if (stale) output.flags |= safety_stale;

    double gain = 0;
    if (live) {
        if (!state.live) state.ramp = 0;
        if (state.ramp < limits.ramp_ticks) {
            ++state.ramp;
            output.flags |= safety_ramping;
        }
        gain = limits.ramp_ticks == 0 ? 1.0 : static_cast<double>(state.ramp) / limits.ramp_ticks;
    }
    const Vector3 target = live ? clamp_force(gain * input.force, limits.force) : Vector3(Vector3::Zero());
    // A change of the force's source keeps the sent force and lets the difference decay.
    const double most = limits.slew * limits.tick_period;
    double own = 0;  // N, part of this tick's change caused by the hand
    if (live != state.live) {
        state.difference = state.sent - target;
    } else if (live) {
        Vector3 same = target;  // by the model of the last tick
        if (input.model_changed && usable(input.old_force)) {
            same = clamp_force(gain * input.old_force, limits.force);
            state.difference += same - target;
        }
        if (input.explained < limits.force) {
            Vector3 jump = same - state.target;
            own = std::min(jump.norm(), std::max(0.0, input.explained));
            if (shrink(jump, own)) state.difference -= jump;
        }
    }
    state.target = target;
    state.live = live;
    if (shrink(state.difference, std::max(least_share * most, most - own))) output.flags |= safety_slewed;

    bool clamped = live && clamp_force(gain * input.force, limits.force) != gain * input.force;
    bool total_clamped = false;
    output.force = clamp_force(target + state.difference, limits.force, &total_clamped);
    if (clamped || total_clamped) output.flags |= safety_clamped;
    state.sent = output.force;
    return output;
}

}  // namespace fulcrum
