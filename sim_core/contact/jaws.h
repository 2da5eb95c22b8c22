// SPDX-License-Identifier: Apache-2.0
// Jaws on tissue: the tissue between them, contact area, pressure, and slip.
#pragma once

#include "sim_core/contact/local_model.h"
#include "sim_core/contact/tool_contact.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// Tissue inside the jaw box: length jaw_length back from the tip, width c of the tip box, height the
/// opening.
struct JawContact {
    double area = 0;  ///< m2, of the surface inside the box, at most both jaw faces
    std::int32_t vertex =
        -1;  ///< surface number, nearest to the middle of the jaws; -1: no tissue between them
    Vector3 point = Vector3::Zero();   ///< m, area-weighted centre of the tissue inside
    Vector3 normal = Vector3::Zero();  ///< unit, outward, mean
    std::int16_t tissue_patch = -1;
};

/// Tissue between jaws opened by `opening` rad (the jaws turn about an axis along tool x, so they open along
/// tool y). Uses the patch at the model's pose, extrapolated to `tick`. No allocation.
JawContact find_jaw_contact(const InstrumentModel& instrument, const ToolKinematics& tool, double opening,
                            const LocalModel& local, std::uint32_t tick, ToolContactScratch& scratch);

/// Jaw force over contact area, Pa; areas below 1 mm2 count as 1 mm2, so that an edge bite stays finite.
double jaw_pressure(double jaw_force, double area);

/// Tangential force over capacity: both faces together hold 2 mu N. Above 1 the tissue slips. `normal` is the
/// closing direction of the jaws, unit. With load but no jaw force: a large finite number.
double slip_ratio(const Vector3& force, const Vector3& normal, double jaw_force, double friction);

/// Smallest opening (rad) of jaws that hold tissue of the given thickness (m) at their middle.
double held_opening(const InstrumentModel& instrument, double thickness);

/// Accumulated load of a tissue patch.
struct PatchDamage {
    double impulse = 0;  ///< N s above the threshold
    double peak = 0;     ///< N or Pa, depending on the caller
};
/// Adds one period of a load; only the part above the threshold counts. Non-finite loads are ignored.
void add_damage(PatchDamage& damage, double load, double threshold, double period);

}  // namespace fulcrum
