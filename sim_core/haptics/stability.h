// SPDX-License-Identifier: Apache-2.0
// Haptic stability (docs/THEORY.md, section 6; Eq. 8 with Colgate's |B|).
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Stiffness and damping of a local model after applying Eq. 8.
struct PassivityCheck {
    double stiffness = 0;    ///< N/m, K to render, >= 0
    double damping = 0;      ///< N s/m, B to render, >= 0
    bool applicable = true;  ///< false: the device has no b (it renders no force), nothing was checked
    bool passive = true;     ///< K < 2 (b - |B|) / T held for the requested values
    bool limited = false;    ///< B or K was reduced: raise the event stability_limited
};

/// Eq. 8: K < 2 (b - |B|) / T, sufficient for passivity with any passive hand. K >= 0 N/m, B N s/m, b N s/m
/// the device's damping (negative: not applicable), T > 0 s. If it fails, B is reduced first, then K, never
/// below 0; the result keeps a margin of 0.1 % from the bound. Non-finite values count as failing and become
/// 0.
PassivityCheck check_passivity(double stiffness, double damping, double device_damping, double period);

/// Largest K that Eq. 8 allows, N/m, >= 0.
double passive_stiffness(double damping, double device_damping, double period);

/// The wider bound of a device without a hand: K (T/2 + t_d) < b + B; largest stable K, N/m. delay: t_d, s.
double stable_stiffness(double damping, double device_damping, double period, double delay);

/// Energy that flowed from the device into the hand, J: sum of f . v T. Passive while the hand has received
/// at most what it put in (passivity observer, Hannaford and Ryu 2002).
struct PassivityObserver {
    double given = 0;    ///< J, net energy to the hand, may be negative
    double highest = 0;  ///< J, largest so far
    void step(const Vector3& force_on_hand, const Vector3& hand_velocity, double period) {
        given += force_on_hand.dot(hand_velocity) * period;
        if (given > highest) highest = given;
    }
};

/// Passivity controller: returns to the hand no more energy than the hand has put in (Hannaford and Ryu 2002,
/// with the dissipation taken from the returned power itself, so that it never increases a force). One per
/// hand; copyable.
struct PassivityController {
    double stored = 0;  ///< J put in by the hand and not yet returned; below 0 only by correct()

    /// Force (N) on the hand at this tick, with the hand moving at `hand_velocity` (m/s): the part along the
    /// motion is reduced so that its power over the period returns no more than the stored energy. `acted`:
    /// it was reduced. Non-finite values give zero.
    Vector3 step(const Vector3& force, const Vector3& hand_velocity, double period, bool* acted = nullptr);
    /// What step() foresaw (J to the hand) against what the held force gave in the motion that was made
    /// since.
    void correct(double foreseen, double given) {
        if (const double after = stored + foreseen - given; after - after == 0) stored = after;
    }
};

}  // namespace fulcrum
