// SPDX-License-Identifier: Apache-2.0
// Haptic stability (docs/THEORY.md 6; Eq. 8 with Colgate's |B|).
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// A local model's stiffness and damping after Eq. 8.
struct PassivityCheck {
    double stiffness = 0;    ///< N/m, K to render, >= 0
    double damping = 0;      ///< N s/m, B to render, >= 0
    bool applicable = true;  ///< false: the device has no b (it renders no force), nothing was checked
    bool passive = true;     ///< K < 2 (b - |B|) / T held for what was asked
    bool limited = false;    ///< B or K was reduced: raise the event stability_limited
};

/// Eq. 8: K < 2 (b - |B|) / T, sufficient for passivity with any passive hand. K >= 0 N/m, B N s/m, b N s/m
/// the device's damping (negative: not applicable), T > 0 s. Where it fails, B is reduced first, then K,
/// never below 0; the result keeps a thousandth of distance from the bound. Values that are not finite count
/// as failing and become 0.
PassivityCheck check_passivity(double stiffness, double damping, double device_damping, double period);

/// Largest K that Eq. 8 allows, N/m, >= 0.
double passive_stiffness(double damping, double device_damping, double period);

/// The wider bound of a device without a hand: K (T/2 + t_d) < b + B; largest stable K, N/m. delay t_d in s.
double stable_stiffness(double damping, double device_damping, double period, double delay);

/// Energy that left the device into the hand, J: sum of f . v T. Passive while the hand has got back at most
/// what it put in (passivity observer, Hannaford and Ryu 2002).
struct PassivityObserver {
    double given = 0;    ///< J, net energy to the hand, may be negative
    double highest = 0;  ///< J, largest so far
    void step(const Vector3& force_on_hand, const Vector3& hand_velocity, double period) {
        given += force_on_hand.dot(hand_velocity) * period;
        if (given > highest) highest = given;
    }
};

/// Passivity controller: lets the hand take back no more than it has put in (Hannaford and Ryu 2002, with the
/// dissipation taken off the returned power itself, so that no force ever grows by it). One hand; copyable.
struct PassivityController {
    double stored = 0;  ///< J that the hand has put in and not taken back; never below 0

    /// The force (N) on the hand at this tick, moving at `hand_velocity` (m/s): the part along the motion is
    /// cut so that its power over the period takes no more than what is stored. `acted`: it was cut. Values
    /// that are not finite give zero.
    Vector3 step(const Vector3& force, const Vector3& hand_velocity, double period, bool* acted = nullptr);
};

}  // namespace fulcrum
