// SPDX-License-Identifier: Apache-2.0
// Rods as studies, cases and tests ask for them.
#pragma once

#include "sim_core/lab/held_elastica.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {

/// Solid rod along +x, clamped at the origin, free at the far end; bowel's modulus.
RodSpec cantilever_spec(int segments, double length = 0.4, double radius = 0.015);

/// A rod at rest with all that a solve needs, its ends held where they are.
struct RestingRod {
    Rod rod;
    RodState state;
    RodScratch scratch;
    RodInputs inputs;
    explicit RestingRod(const RodSpec& spec);
    /// Holds that wall point where it is now. The reference lasts until the next grasp.
    RodGrasp& grasp(double s, const Vector3& offset = Vector3::Zero());
    /// A floor (normal +z) under that many spheres of 15 mm.
    void add_floor(double height, int spheres);
};

/// Takes the problem's two points and leads them there in twenty parts; the last solve's report.
RodReport hold_as(const HeldElastica& problem, RestingRod& resting);

struct SolvedRod {
    RodReport report;
    RodState state;
};
/// Static solution from that state, ends held where they are.
SolvedRod solve_rod(const Rod& rod, RodInputs inputs, RodState state, const RodSolve& options = {});
/// Static solution from rest under a dead load of qL^3/EI = load towards -z.
SolvedRod distributed_load(const Rod& rod, double load, const RodSolve& options = {});

}  // namespace fulcrum::lab
