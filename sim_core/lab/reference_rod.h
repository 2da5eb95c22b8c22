// SPDX-License-Identifier: Apache-2.0
// Rods for studies, validation cases and tests.
#pragma once

#include "sim_core/lab/held_elastica.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {

/// Solid rod along +x, clamped at the origin, free at the far end; modulus of the bowel.
RodSpec cantilever_spec(int segments, double length = 0.4, double radius = 0.015);

/// A rod at rest with everything a solve needs; its ends are held in place.
struct RestingRod {
    Rod rod;
    RodState state;
    RodScratch scratch;
    RodInputs inputs;
    explicit RestingRod(const RodSpec& spec);
    /// Holds the given wall point at its present position. The reference is valid until the next grasp.
    RodGrasp& grasp(double s, const Vector3& offset = Vector3::Zero());
    /// A floor (normal +z) under that many spheres of 15 mm.
    void add_floor(double height, int spheres);
};

/// Grasps the problem's two points and moves them to their targets in twenty increments; report of the last
/// solve.
RodReport hold_as(const HeldElastica& problem, RestingRod& resting);

struct SolvedRod {
    RodReport report;
    RodState state;
};
/// Static solution from the given state, ends held in place.
SolvedRod solve_rod(const Rod& rod, RodInputs inputs, RodState state, const RodSolve& options = {});
/// Static solution from rest under a dead load of qL^3/EI = load towards -z.
SolvedRod distributed_load(const Rod& rod, double load, const RodSolve& options = {});

}  // namespace fulcrum::lab
