// SPDX-License-Identifier: Apache-2.0
// A vessel as a tube with an opening at its end: bleeding rate, haemostasis, blood loss. Pure functions of
// model and state; no allocation, no exception, always finite.
//
// Flow by Hagen and Poiseuille through the tube that feeds the opening, Q = pi r^4 p / (8 mu L), with r the
// radius of the opening: for an area share a of the lumen, r^4 = (a r0^2)^2. Radius, length and pressure are
// given by the scene; viscosity of whole blood 3.5 mPa s.
#pragma once

namespace fulcrum {

struct VesselModel {
    double radius = 0.6e-3;       ///< r0, m
    double feeding_length = 0.3;  ///< L, m
    double pressure = 12.4e3;     ///< p, Pa: mean arterial, 93 mmHg
    double viscosity = 3.5e-3;    ///< mu, Pa s
    double clotting_time =
        600;  ///< s, time in which an opening closes to 1/e of its area by itself; provisional
};

struct BleedState {
    double opening = 0;  ///< area share that was torn or cut open, 0 .. 1
    double sealed = 0;   ///< fraction of the opening sealed by heat, 0 .. 1
    double clotted = 0;  ///< fraction of the opening that has clotted, 0 .. 1
    bool clipped = false;
    double lost = 0;  ///< blood loss since the start, m3
};

/// Flow in m3/s through an area share 0 .. 1 of the lumen.
double vessel_flow(const VesselModel& model, double area_share) noexcept;
/// Area share that is still open; 0 under a clip.
double open_share(const BleedState& state) noexcept;
/// Current flow, m3/s.
double bleed_flow(const VesselModel& model, const BleedState& state) noexcept;
/// Opens the vessel by an area share (added to the present opening; a new tear has no seal and no clot).
void open_vessel(double area_share, BleedState& state) noexcept;
/// One step: blood lost (m3), exact for an opening that clots at its rate during the step.
double step_bleed(const VesselModel& model, double dt, BleedState& state) noexcept;

}  // namespace fulcrum
