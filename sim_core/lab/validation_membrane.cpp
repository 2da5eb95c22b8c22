// SPDX-License-Identifier: Apache-2.0
// Membrane: the global-local solve compared with implicit Euler by Newton to 1e-10, both on the same springs;
// support forces compared with the weight.
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/lab/membrane_reference.h"
#include "sim_core/lab/validation_rooms.h"

namespace fulcrum::lab {
namespace {

// A node between two springs in a line and a third below, loaded downward.
ValidationCase loaded_string() {
    TriangleMesh mesh;
    mesh.vertices = {Vector3(0, 0, 0), Vector3(0.05, 0, 0), Vector3(0.1, 0, 0), Vector3(0.05, 0, -0.05)};
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
    MembraneMaterial material;
    material.structural_stiffness = 50;
    material.shear_stiffness = material.bend_stiffness = 0;
    const Membrane membrane(mesh, material, {0, 2, 3});
    MembraneScratch scratch = membrane.make_scratch(0.0);
    MembraneState state = membrane.make_state();
    MembraneInputs inputs;
    inputs.forces.assign(4, Vector3::Zero());
    // Vertex 3 is held straight below: its spring acts along the line of the load and is part of the balance.
    inputs.forces[1] = Vector3(0, 0, -0.5);
    MembraneSolve solve;
    solve.integrator = MembraneIntegrator::implicit;
    membrane.solve(state, inputs, scratch, solve);
    // The two in a line, and the one below shortened by the displacement z: 2 k (l - l0) z / l + k z = F.
    double low = 0, high = 0.05;
    for (int i = 0; i < 200; ++i) {
        const double z = 0.5 * (low + high), l = std::sqrt(0.05 * 0.05 + z * z);
        const double pull = 2 * 50 * (l - 0.05) * z / l + 50 * z;
        (pull < 0.5 ? low : high) = z;
    }
    return relative_case("membrane", "node between three springs under 0.5 N", "displacement, m",
                         -state.positions[1].z(), 0.5 * (low + high), "balance of forces by bisection", 1e-9);
}

ValidationCase triangle_limit() {
    TriangleMesh mesh;
    mesh.vertices = {Vector3(0, 0, 0), Vector3(0.01, 0, 0), Vector3(0.005, 0.01 * std::sqrt(0.75), 0)};
    mesh.triangles = {{0, 1, 2}};
    MembraneMaterial material;
    material.structural_stiffness = 40;
    material.mass = 0.003;
    const Membrane membrane(mesh, material, {});
    MembraneScratch scratch = membrane.make_scratch();
    const MembraneLimit limit = membrane.limit(membrane.make_state(), scratch);
    return relative_case("membrane", "free equilateral triangle of springs", "highest frequency, rad/s",
                         limit.frequency, std::sqrt(3.0 * 40 / 0.001),
                         "breathing mode of three equal masses and springs, w^2 = 3 k / m", 1e-6);
}

}  // namespace

std::vector<ValidationCase> membrane_validation() {
    std::vector<ValidationCase> cases;
    constexpr int side = 32;
    constexpr double dt = 0.005;
    HeldSheet sheet(side);
    const Membrane& membrane = sheet.membrane;
    MembraneSolve quick, exact;
    exact.integrator = MembraneIntegrator::implicit;
    MembraneScratch scratch = membrane.make_scratch(0);
    const MembraneState flat = membrane.make_state();
    MembraneState state = flat, reference = flat;
    quick.iterations = 14;
    membrane.solve(state, sheet.inputs, scratch, quick);
    const bool solved = membrane.solve(reference, sheet.inputs, scratch, exact).converged;
    ValidationCase statics =
        absolute_case("membrane", "held sheet of 1,024 nodes under its weight, global-local, 14 iterations",
                      "energy gap", energy_gap(membrane, flat, state, reference, sheet.inputs, 0, scratch), 0,
                      "Newton on the same energy to 1e-10", 0.01, 1, "of E_start - E_reference");
    statics.passed = statics.passed && solved;
    cases.push_back(statics);
    Vector3 sum = Vector3::Zero();
    membrane.solve(reference, sheet.inputs, scratch, exact);
    for (const Vector3& reaction : sheet.inputs.reactions) sum += reaction;
    cases.push_back(relative_case("membrane", "the same sheet at rest", "vertical sum of its supports, N",
                                  sum.z(), 0.04 * 9.81, "its weight", 1e-6));
    MembraneScratch frames = membrane.make_scratch(dt);
    quick.iterations = 8;
    double first = 0, worst = 0;
    bool converged = true;
    state = reference;
    for (int frame = 1; frame <= 20; ++frame) {
        sheet.move_edge(frame);
        const MembraneState start = state;
        MembraneState ideal = start;
        converged = membrane.step(ideal, sheet.inputs, dt, frames, exact).converged && converged;
        // The edge starts at full speed in the first frame, without curvature information from a previous
        // frame.
        quick.iterations = frame == 1 ? 12 : 8;
        membrane.step(state, sheet.inputs, dt, frames, quick);
        const double gap = energy_gap(membrane, start, state, ideal, sheet.inputs, dt, frames);
        (frame == 1 ? first : worst) = std::max(frame == 1 ? first : worst, gap);
    }
    for (const bool starting : {true, false}) {
        ValidationCase moving = absolute_case(
            "membrane",
            starting
                ? "a frame of 5 ms in which a resting edge starts at 50 mm/s, global-local, 12 iterations"
                : "the 19 frames after it, global-local, 8 iterations",
            "worst energy gap of a frame", starting ? first : worst, 0, "implicit Euler by Newton to 1e-10",
            0.01, 1, "of E_start - E_reference");
        moving.passed = moving.passed && converged;
        cases.push_back(moving);
    }
    cases.push_back(loaded_string());
    cases.push_back(triangle_limit());
    return cases;
}

}  // namespace fulcrum::lab
