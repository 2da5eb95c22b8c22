// SPDX-License-Identifier: Apache-2.0
// Heat in a small graph of tissue patches: conduction between them, perfusion, vaporisation of water, and the
// thermal dose and damage. Model (const) / state / scratch; no allocation in a step, no exception, always
// finite.
//
// Pennes' bioheat equation, lumped: C dT/dt = sum_j G_ij (T_j - T_i) - P (T - T_body) + q + h (T_c - T), by
// implicit Euler, which is stable for every time step. A patch at the boiling point stays there while it has
// water: the excess heat vaporises water.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum {

/// A patch of tissue. All finite, capacity > 0, the others >= 0.
struct HeatPatch {
    double capacity = 0.1;  ///< C, J/K
    double perfusion = 0;   ///< P, W/K: blood flow through the patch times its heat capacity
    double water = 0;       ///< kg that can boil off
};
struct HeatLink {
    std::int32_t a = 0, b = 0;  ///< patches, different
    double conductance = 0;     ///< G, W/K, >= 0
};

struct HeatModel {
    std::vector<HeatPatch> patches;
    std::vector<HeatLink> links;
    double body_temperature = 37;  ///< degrees C, at the start and of the blood
    double boiling_point = 100;    ///< degrees C
    double latent_heat = 2.257e6;  ///< J/kg, of water at 100 degrees C
};

struct HeatState {
    std::vector<double> rise;          ///< K above body temperature
    std::vector<double> water;         ///< kg remaining
    std::vector<double> dose;          ///< CEM43, min
    std::vector<double> damage;        ///< Arrhenius integral, see damage_rate()
    std::vector<std::uint8_t> parted;  ///< 1: this link no longer conducts
    double given = 0, perfused = 0,
           boiled = 0;  ///< J since the start: into the patches, removed by blood, removed by steam
};

/// Heat sources during a step; one entry per patch.
struct HeatInputs {
    std::vector<double> power;         ///< q, W; non-finite or negative values count as 0
    std::vector<double> contact;       ///< h, W/K, conductance to a hot object in contact
    std::vector<double> contact_rise;  ///< K above body temperature, of that object
};

struct HeatScratch {
    std::vector<double> diagonal, right, residual, direction, product, next;
};

struct HeatReport {
    int iterations = 0;
    double residual = 0;      ///< relative
    double steam = 0;         ///< kg boiled off in this step
    double from_contact = 0;  ///< J received from objects in contact in this step
};

HeatState make_heat_state(const HeatModel& model);
HeatInputs make_heat_inputs(const HeatModel& model);
HeatScratch make_heat_scratch(const HeatModel& model);

/// One step of dt seconds; no effect unless dt > 0.
HeatReport step_heat(const HeatModel& model, const HeatInputs& inputs, double dt, HeatState& state,
                     HeatScratch& scratch) noexcept;

/// Heat stored in the patches above body temperature, J.
double stored_heat(const HeatModel& model, const HeatState& state);

/// Cumulative equivalent minutes at 43 degrees C per minute at `temperature`: R^(43 - T), R = 0.5 from 43,
/// 0.25 from 39 to 43, zero below 39 (Sapareto and Dewey 1984).
double dose_rate(double temperature);
/// min: the dose of a patch stays there. Forty times what kills tissue says no more than twenty times.
inline constexpr double dose_limit = 1e4;
/// min, CEM43 from which soft tissue is taken as dead: the usual bound of thermal ablation.
inline constexpr double lethal_dose = 240;

/// 1/s, A exp(-Ea / (R T)) with A 3.1e98 1/s and Ea 6.28e5 J/mol (Henriques and Moritz 1947). 1 -
/// exp(-integral) is the coagulated fraction of protein. Saturates at 1e6.
double damage_rate(double temperature);
/// 1 - exp(-damage), 0 .. 1.
double coagulated_share(double damage);

}  // namespace fulcrum
