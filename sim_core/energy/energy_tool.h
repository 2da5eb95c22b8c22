// SPDX-License-Identifier: Apache-2.0
// Model of an energy instrument: distribution of its power, blade temperature, and the rate at which it
// divides the tissue between its jaws. Pure functions and small state; no allocation, no exception, always
// finite.
//
// The values are provisional (chosen so that a 6 mm band is divided in 2 to 5 s and that the blade is near
// 200 degrees C after some seconds, as published tests of ultrasonic shears report), except where a source is
// given.
#pragma once

namespace fulcrum {

/// Ultrasonic shears ("harmonic") or a monopolar hook.
struct EnergyToolModel {
    double tissue_power = 24;      ///< W, into the tissue that is held or touched
    double blade_power = 6;        ///< W, into the blade itself
    double blade_capacity = 0.12;  ///< J/K
    double blade_cooling = 0.03;   ///< W/K, to the surrounding gas
    double blade_contact = 0.015;  ///< W/K, to a touched patch
    double division_rate = 0.22;   ///< 1/s, of held tissue at the boiling point without tension
    double tension_gain = 1.2;     ///< 1/N: increase of the division rate with tension
    double division_start = 55,
           division_full = 100;  ///< degrees C, where division begins and where it reaches its full rate
    bool needs_jaws = true;      ///< divides only what its jaws hold; otherwise what its tip touches
};
EnergyToolModel harmonic_shears();
EnergyToolModel monopolar_hook();

/// Temperature of a blade, K above body temperature.
struct BladeState {
    double rise = 0;
};
/// One step: heated while active, cooled by the gas and by `given` J that the tissue took. Implicit in the
/// cooling.
void step_blade(const EnergyToolModel& model, bool active, double given, double dt,
                BladeState& blade) noexcept;

/// 1/s: rate of division progress (0 intact, 1 divided) of a patch at `temperature` (degrees C) under
/// `tension` (N); 0 below division_start. Under strong traction a patch is divided before it has coagulated:
/// then its vessel bleeds.
double division_rate(const EnergyToolModel& model, double temperature, double tension) noexcept;

/// Fraction of the tissue power that reaches a patch under blood of `depth` m: the rest heats the blood.
double share_under_blood(double depth) noexcept;

}  // namespace fulcrum
