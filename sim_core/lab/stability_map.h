// SPDX-License-Identifier: Apache-2.0
// The haptic rows of `fulcrum lab stability` (docs/THEORY.md, section 6): a simulated device at the product's
// own contact.
//
// Device: x'' = (f - b x') / m between two ticks, solved exactly; position in encoder steps; force held over
// a period, computed from the position `delay_ticks` before. The force is that of step_tool_contact at a
// patch of a bowel, loaded by a constant force; stiffness and damping of the tissue are those of the cell, at
// the filter grade of the map. 1-DoF along the surface's normal.
#pragma once

#include <vector>

#include "sim_core/bowel/force_filter.h"
#include "sim_core/lab/stability.h"

namespace fulcrum::lab {

struct SimulatedDevice {
    double mass = 0.1;           ///< kg
    double damping = 0.5;        ///< b, N s/m
    double encoder_step = 1e-7;  ///< m, at the tip; not finer than the resolution of a device sample
    int delay_ticks = 0;         ///< t_d over T
    double period = 1e-3;        ///< T, s
};

/// Result of one cell of the map.
struct DeviceRun {
    bool stable = false;   ///< a disturbance dies out
    bool passive = false;  ///< no imposed motion and no passive hand received more energy than it put in
    bool finite = true;    ///< all outputs were finite
    double returned = 0;   ///< J, largest energy returned to a hand over whole periods; <= 0: passive
    double stiffness = 0;  ///< N/m, K of the local model as reported by the tick
};

/// A device at a contact of stiffness N/m and damping N s/m. With the worst hand, a lossless spring between
/// hand and device tunes the loop to any frequency up to half the sampling rate; the run is stable if it is
/// stable for all.
class DeviceAtContact {
  public:
    explicit DeviceAtContact(FilterMode grade, const SimulatedDevice& device = {});
    ~DeviceAtContact();
    DeviceAtContact(const DeviceAtContact&) = delete;
    DeviceAtContact& operator=(const DeviceAtContact&) = delete;

    DeviceRun run(double stiffness, double damping, bool worst_hand);
    /// Passivity observer over imposed motions only: largest energy (J) returned over whole periods beyond
    /// what was put in; below 0: none.
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
