// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/reference_rod.h"

#include <utility>

namespace fulcrum::lab {

RodSpec cantilever_spec(int segments, double length, double radius) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = length;
    spec.outer_radius = radius;
    spec.inner_radius = 0;
    spec.ends[0] = RodEnd::clamped;
    return spec;
}

SolvedRod solve_rod(const Rod& rod, RodInputs inputs, RodState state, const RodSolve& options) {
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    RodScratch scratch = rod.make_scratch();
    SolvedRod solved;
    solved.report = rod.solve(state, inputs, scratch, options);
    solved.state = std::move(state);
    return solved;
}

SolvedRod distributed_load(const Rod& rod, double load, const RodSolve& options) {
    const double l = rod.length(), q = load * rod.bending_stiffness() / (l * l * l);
    RodInputs inputs;
    inputs.gravity = Vector3(0, 0, -q / rod.spec().linear_density);
    return solve_rod(rod, inputs, rod.make_state(), options);
}

}  // namespace fulcrum::lab
