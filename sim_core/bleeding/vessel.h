// SPDX-License-Identifier: Apache-2.0
// A vessel as a tube that ends in an opening: how fast it bleeds, what stops it, how much was lost. Pure
// functions of model and state; no allocation, no exception, always finite.
//
// Flow by Hagen and Poiseuille through the tube that feeds the opening, Q = pi r^4 p / (8 mu L), r the radius
// of what is open: with an area share a of the lumen, r^4 = (a r0^2)^2. Radius, length and pressure are given
// by the scene; viscosity of whole blood 3.5 mPa s.
#pragma once

namespace fulcrum {

struct VesselModel {
    double radius = 0.6e-3;       ///< r0, m
    double feeding_length = 0.3;  ///< L, m
    double pressure = 12.4e3;     ///< p, Pa: mean arterial, 93 mmHg
    double viscosity = 3.5e-3;    ///< mu, Pa s
    double clotting_time = 600;   ///< s, in which an opening closes to 1/e of its area by itself; provisional
};

struct BleedState {
    double opening = 0;  ///< area share that was torn or cut open, 0 .. 1
    double sealed = 0;   ///< share of that which heat has closed, 0 .. 1
    double clotted = 0;  ///< share of that which has clotted, 0 .. 1
    bool clipped = false;
    double lost = 0;  ///< m3 since the start
};

/// m3/s through an area share 0 .. 1 of the lumen.
double vessel_flow(const VesselModel& model, double area_share) noexcept;
/// Area share that is still open; 0 under a clip.
double open_share(const BleedState& state) noexcept;
/// m3/s now.
double bleed_flow(const VesselModel& model, const BleedState& state) noexcept;
/// Opens by an area share (what is open already counts; a fresh tear has no seal and no clot).
void open_vessel(double area_share, BleedState& state) noexcept;
/// One step: what is lost (m3), exact for an opening that clots at its rate during the step.
double step_bleed(const VesselModel& model, double dt, BleedState& state) noexcept;

}  // namespace fulcrum
