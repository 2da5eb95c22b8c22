// SPDX-License-Identifier: Apache-2.0
// What an energy instrument does: where its power goes, how hot its blade is, how fast what lies between its
// jaws parts. Pure functions and small state; no allocation, no exception, always finite.
//
// The figures are ours and provisional (chosen so that a 6 mm band parts in 2 to 5 s and that the blade is
// near 200 degrees C after some seconds, as published tests of ultrasonic shears report), except where a
// source is named.
#pragma once

namespace fulcrum {

/// Ultrasonic shears ("harmonic") or a monopolar hook.
struct EnergyToolModel {
    double tissue_power = 24;      ///< W, into what is held or touched
    double blade_power = 6;        ///< W, into the blade itself
    double blade_capacity = 0.12;  ///< J/K
    double blade_cooling = 0.03;   ///< W/K, to the gas around it
    double blade_contact = 0.015;  ///< W/K, to a patch that it touches
    double division_rate = 0.22;   ///< 1/s, of what is held at the boiling point without tension
    double tension_gain = 1.2;     ///< 1/N: how much faster it parts under tension
    double division_start = 55,
           division_full = 100;  ///< degrees C, where parting begins and where it is fully fast
    bool needs_jaws = true;      ///< parts only what its jaws hold; otherwise what its tip touches
};
EnergyToolModel harmonic_shears();
EnergyToolModel monopolar_hook();

/// A blade, K above the body's temperature.
struct BladeState {
    double rise = 0;
};
/// One step: heated while active, cooled by the gas and by `given` J that the tissue took. Implicit in the
/// cooling.
void step_blade(const EnergyToolModel& model, bool active, double given, double dt,
                BladeState& blade) noexcept;

/// 1/s: progress (0 whole, 1 parted) of a patch at `temperature` (degrees C) under `tension` (N); 0 below
/// division_start. A patch that is pulled hard parts before it has coagulated: then its vessel bleeds.
double division_rate(const EnergyToolModel& model, double temperature, double tension) noexcept;

/// Share of the tissue power that reaches a patch under blood `depth` m deep: the rest heats the blood.
double share_under_blood(double depth) noexcept;

}  // namespace fulcrum
