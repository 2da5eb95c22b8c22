// SPDX-License-Identifier: Apache-2.0
// An instrument as solids: the shaft is a capsule, each jaw a box. Used for tools against bowel and tool
// against tool. Any thread; no allocation, no exception.
#pragma once

#include "sim_core/geometry/oriented_box.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// Shaft from the trocar to the tip; jaws from the hinge (jaw_length before the tip), opened by jaw_angle,
/// half of it to either side along tool y. The two closed jaws are the tip box of Eq. 4, as long as the jaws.
/// A probe has no jaws.
struct ToolShape {
    Vector3 trocar = Vector3::Zero(), tip = Vector3::Zero();  ///< m
    double radius = 0;                                        ///< m, of the shaft
    OrientedBox jaw[2];
    int jaws = 0;  ///< 0 or 2
};
ToolShape tool_shape(const InstrumentModel& instrument, const ToolKinematics& tool);

/// Deepest overlap of two shapes.
struct SolidContact {
    double depth = 0;                   ///< m; <= 0 if separated, whatever its size
    Vector3 normal = Vector3::UnitZ();  ///< unit, from the second into the first
    Vector3 point = Vector3::Zero();    ///< m, contact point
    bool by_jaw = false;                ///< a jaw is one of the two shapes
};

/// Two instruments: shafts, jaws against shafts, jaws against jaws; exact where they overlap. How far apart
/// jaws are is not computed where they cannot touch.
SolidContact collide_shapes(const ToolShape& first, const ToolShape& second);

/// An instrument against a sphere (of the bowel's chain); exact.
SolidContact collide_sphere(const ToolShape& tool, const Vector3& centre, double radius);

/// The jaws against a triangle (of the bowel's surface), exact; depth <= 0: separated. Shaft contact is the
/// dynamic point's task.
SolidContact collide_triangle(const ToolShape& tool, const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace fulcrum
