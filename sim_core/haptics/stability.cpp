// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/stability.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {
constexpr double distance_from_bound = 0.999;
}

double passive_stiffness(double damping, double device_damping, double period) {
    return std::max(0.0, 2.0 * (device_damping - std::abs(damping)) / period);
}

double stable_stiffness(double damping, double device_damping, double period, double delay) {
    return std::max(0.0, (device_damping + damping) / (0.5 * period + delay));
}

Vector3 PassivityController::step(const Vector3& force, const Vector3& hand_velocity, double period,
                                  bool* acted) {
    if (acted != nullptr) *acted = false;
    if (!force.allFinite() || !hand_velocity.allFinite()) return Vector3::Zero();
    const double returned = force.dot(hand_velocity) * period;
    if (!std::isfinite(returned)) return Vector3::Zero();
    if (returned <= std::max(0.0, stored)) {
        stored -= returned;
        return force;
    }
    // The hand moves and the force pushes it along: reduce the part along the motion.
    const double keep = std::max(0.0, stored) / returned;
    const Vector3 direction = hand_velocity.normalized();
    Vector3 cut = force - (1.0 - keep) * force.dot(direction) * direction;
    stored = std::min(0.0, stored);
    if (acted != nullptr) *acted = true;
    return cut;
}

PassivityCheck check_passivity(double stiffness, double damping, double device_damping, double period) {
    PassivityCheck check;
    const bool finite = std::isfinite(stiffness) && std::isfinite(damping) && std::isfinite(device_damping);
    check.stiffness = std::isfinite(stiffness) ? std::max(0.0, stiffness) : 0.0;
    check.damping = std::isfinite(damping) ? std::max(0.0, damping) : 0.0;
    if (device_damping < 0) {
        check.applicable = false;
        check.limited = !finite;
        check.passive = finite;
        return check;
    }
    if (!finite) {
        check.stiffness = check.damping = 0;
        check.passive = false;
        check.limited = true;
        return check;
    }
    check.passive = check.stiffness < passive_stiffness(check.damping, device_damping, period);
    if (check.passive || check.stiffness <= 0) {
        check.limited = !check.passive && check.damping > device_damping;
        if (check.limited) check.damping = distance_from_bound * device_damping;
        return check;
    }
    check.limited = true;
    // Damping required for this stiffness; if even zero damping is too much, the stiffness is reduced.
    const double allowed = distance_from_bound * (device_damping - 0.5 * check.stiffness * period);
    if (allowed >= 0) {
        check.damping = std::min(check.damping, allowed);
    } else {
        check.damping = 0;
        check.stiffness = distance_from_bound * passive_stiffness(0, device_damping, period);
    }
    return check;
}

}  // namespace fulcrum
