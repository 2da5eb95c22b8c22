// SPDX-License-Identifier: Apache-2.0
// The haptic rows of `fulcrum lab stability` (docs/THEORY.md 6): a simulated device at the product's own
// contact.
//
// Device: x'' = (f - b x') / m between two ticks, solved exactly; position in encoder steps; force held over
// a period, made from the position `delay_ticks` before. The force is step_tool_contact's at a patch of a
// bowel, pressed in by a constant load; stiffness and damping of the tissue are those of the cell, at the
// filter grade of the map. 1-DoF along the surface's normal.
#pragma once

#include <vector>

#include "sim_core/contact/force_filter.h"
#include "sim_core/lab/stability.h"

namespace fulcrum::lab {

struct SimulatedDevice {
    double mass = 0.1;           ///< kg
    double damping = 0.5;        ///< b, N s/m
    double encoder_step = 1e-7;  ///< m, at the tip; the device sample's own resolution is the finest
    int delay_ticks = 0;         ///< t_d over T
    double period = 1e-3;        ///< T, s
};

/// What one cell of the map shows.
struct DeviceRun {
    bool stable = false;   ///< a disturbance dies out
    bool passive = false;  ///< no imposed motion and no passive hand got back more than it had put in
    bool finite = true;    ///< everything that came out
    double returned = 0;   ///< J, most that a hand got back over whole swings; <= 0: passive
    double stiffness = 0;  ///< N/m, K of the local model as the tick reported it
};

/// A device at a contact of stiffness N/m and damping N s/m. With a worst hand a lossless spring between the
/// hand and the device tunes the loop to any frequency up to half the sampling rate; the run is stable when
/// it is for all of them.
class DeviceAtContact {
  public:
    explicit DeviceAtContact(FilterMode grade, const SimulatedDevice& device = {});
    ~DeviceAtContact();
    DeviceAtContact(const DeviceAtContact&) = delete;
    DeviceAtContact& operator=(const DeviceAtContact&) = delete;

    DeviceRun run(double stiffness, double damping, bool worst_hand);
    /// Passivity observer over imposed motions alone: most energy (J) that came back over whole
    /// swings beyond what had gone in; below 0: none did.
    double returned_energy(double stiffness, double damping);
    /// Largest stable K by bisection, N/m, within `relative` of it; the device alone.
    double boundary(double damping, double relative = 0.002);

  private:
    struct Parts;
    Parts* parts_;
};

/// Six maps: grades 0, 1, 2, each alone and with the worst passive hand. Axes: stiffness_n_m, damping_n_s_m.
/// theory: the stability boundary K (T/2 + t_d) = b + B and the passivity bound K = 2 (b - |B|) / T.
std::vector<StabilityMap> haptic_stability_maps();

}  // namespace fulcrum::lab
