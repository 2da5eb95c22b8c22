// SPDX-License-Identifier: Apache-2.0
// Rods as studies, cases and tests ask for them.
#pragma once

#include "sim_core/rod/rod.h"

namespace fulcrum::lab {

/// Solid rod along +x, clamped at the origin, free at the far end; bowel's modulus.
RodSpec cantilever_spec(int segments, double length = 0.4, double radius = 0.015);

struct SolvedRod {
    RodReport report;
    RodState state;
};
/// Static solution from that state, ends held where they are.
SolvedRod solve_rod(const Rod& rod, RodInputs inputs, RodState state, const RodSolve& options = {});
/// Static solution from rest under a dead load of qL^3/EI = load towards -z.
SolvedRod distributed_load(const Rod& rod, double load, const RodSolve& options = {});

}  // namespace fulcrum::lab
