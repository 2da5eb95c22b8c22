// SPDX-License-Identifier: Apache-2.0
// The mesentery as springs: its values in a scene. SI units.
#pragma once

namespace fulcrum {

/// The mesentery of B1: tension-only springs from the rod to a line on the wall, through the rod's attachment
/// interface.
struct TetherSpec {
    int count = 24;
    double first = 0.10, last = 0.90;  ///< fractions of the bowel's length that carry it
    double stiffness = 15;             ///< N/m each
    double damping = 0.2;              ///< N s/m each
    double slack = 1.15;               ///< rest length over the distance at rest
};

}  // namespace fulcrum
