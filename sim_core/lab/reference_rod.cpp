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

RestingRod::RestingRod(const RodSpec& spec)
    : rod(spec), state(rod.make_state()), scratch(rod.make_scratch(1, 1, 1, 1)) {
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
}

RodGrasp& RestingRod::grasp(double s, const Vector3& offset) {
    RodGrasp held;
    held.s = s;
    held.offset = offset;
    held.target = rod.wall_point(state, s, offset);
    inputs.grasps.push_back(held);
    return inputs.grasps.back();
}

void RestingRod::add_floor(double height, int spheres) {
    for (int i = 0; i < spheres; ++i) {
        RodContact contact;
        contact.s = rod.length() * (i + 0.5) / spheres;
        contact.point = Vector3(0, 0, height);
        contact.radius = 0.015;
        inputs.contacts.push_back(contact);
    }
}

RodReport hold_as(const HeldElastica& problem, RestingRod& resting) {
    for (const double s : problem.held_at) resting.grasp(s);
    RodReport report;
    constexpr int parts = 20;
    for (int part = 0; part < parts; ++part) {
        for (std::size_t h = 0; h < 2; ++h) {
            const Vector3 displacement(problem.moved[h][0], 0, problem.moved[h][1]);
            resting.inputs.grasps[resting.inputs.grasps.size() - 2 + h].target += displacement / parts;
        }
        report = resting.rod.solve(resting.state, resting.inputs, resting.scratch);
    }
    return report;
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
