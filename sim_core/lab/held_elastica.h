// SPDX-License-Identifier: Apache-2.0
// Reference for a rod held at several points: the plane, extensible elastica between clamps as a
// boundary-value problem, by multiple shooting (Runge-Kutta between holders, Newton on the unknown support
// forces). Shares no code with the rod.
#pragma once

#include <array>
#include <vector>

namespace fulcrum::lab {

/// A straight rod along +x, clamped at both ends, two of its points moved in the plane and free to turn.
struct HeldElastica {
    double length = 0.9;                                ///< m
    double bending_stiffness = 0, axial_stiffness = 0;  ///< N m2, N
    std::array<double, 2> held_at = {0.3, 0.6};         ///< m, arc lengths at rest, ascending
    std::array<std::array<double, 2>, 2> moved = {};    ///< m, (x, z) of each
};

struct HeldElasticaSolution {
    std::array<std::array<double, 2>, 2> reaction = {};  ///< N, (x, z) of each holder on the rod
    double middle_x = 0, middle_z = 0;                   ///< m, the rod's middle
    double residual =
        0;  ///< m or rad, largest residual of the conditions, moments converted to turns of the whole length
};

/// Loaded in increments, so that Newton follows the branch that grows from the straight rod.
HeldElasticaSolution solve_held_elastica(const HeldElastica& problem, int steps_a_span = 400);

}  // namespace fulcrum::lab
