// SPDX-License-Identifier: Apache-2.0
// Reference for the rod: the extensible elastica of a cantilever under dead loads in its plane, solved as a
// boundary-value problem by shooting from the tip. Shares no code with the rod.
#pragma once

namespace fulcrum::lab {

struct Cantilever {
    double length = 0.4;           ///< m
    double bending_stiffness = 0;  ///< N m2, EI
    double axial_stiffness = 0;    ///< N, EA; 0: inextensible
    double distributed = 0;        ///< N/m of rest length, towards -z
    double tip_force = 0;          ///< N, towards -z
};

struct CantileverTip {
    double x = 0, z = 0;  ///< m, clamp at the origin, rest along +x
    double angle = 0;     ///< rad, of the tangent above the x axis
};

/// Fourth-order Runge-Kutta with the given number of steps; the tip angle is found by bisection and continued
/// in load, which follows the branch that grows from the straight rod. Takes up to a second for heavy loads.
CantileverTip solve_cantilever(const Cantilever& cantilever, int steps = 4000);

}  // namespace fulcrum::lab
