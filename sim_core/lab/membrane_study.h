// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` with "model": "membrane": a mesh of springs stepped from its rest shape
// (docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// {"model": "membrane", "mesh", "fixed", "stiffness_n_m", "damping", "mass_kg", "gravity", "integrator":
/// "symplectic| global_local|implicit", "dt_s", "steps"} and, with defaults, "shear_stiffness_n_m" (half of
/// stiffness_n_m), "bend_stiffness_n_m" (a twentieth), "pre_strain" (0), "iterations" (global_local: 10),
/// gives {"vertices", "energy_j", "energy_parts_j", "finite", "dt_limit_s", "dt_safe_s", "damping_ratio",
/// "substeps", "fault", "faults", "springs", "time_us_per_step"}. damping: ratio of the stiffest mode.
/// energy_j: springs, motion and height above the start. steps 0: static equilibrium. Throws InputError.
nlohmann::json run_membrane_study(const JsonDocument& study);

}  // namespace fulcrum::lab
