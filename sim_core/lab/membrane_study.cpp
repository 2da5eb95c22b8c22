// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/membrane_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_core/lab/study_input.h"
#include "sim_core/membrane/membrane.h"

namespace fulcrum::lab {
namespace {

MembraneIntegrator integrator_of(const JsonDocument& study) {
    const std::string name = text_of(study, "integrator");
    if (name == "symplectic") return MembraneIntegrator::symplectic;
    if (name == "global_local") return MembraneIntegrator::global_local;
    if (name == "implicit") return MembraneIntegrator::implicit;
    study.fail("/integrator", "unknown integrator", "give \"symplectic\", \"global_local\" or \"implicit\"");
}

nlohmann::json finite_or_null(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

MembraneMaterial material_of(const JsonDocument& study) {
    MembraneMaterial material;
    material.structural_stiffness = number_of(study, "stiffness_n_m", 0, 1e12);
    material.shear_stiffness =
        number_of(study, "shear_stiffness_n_m", 0.5 * material.structural_stiffness, 0, 1e12);
    material.bend_stiffness =
        number_of(study, "bend_stiffness_n_m", 0.05 * material.structural_stiffness, 0, 1e12);
    material.mass = number_of(study, "mass_kg", 1e-12, 1e6);
    material.pre_strain = number_of(study, "pre_strain", 0, -0.5, 1);
    return material;
}

// rad/s, of the membrane at rest.
double highest_frequency(const TriangleMesh& mesh, const MembraneMaterial& material,
                         const std::vector<std::int32_t>& fixed, double dt) {
    const Membrane bare(mesh, material, fixed);
    MembraneScratch scratch = bare.make_scratch(dt);
    return bare.limit(bare.make_state(), scratch).frequency;
}

}  // namespace

nlohmann::json run_membrane_study(const JsonDocument& study) {
    const TriangleMesh mesh = mesh_of(study, "mesh");
    MembraneMaterial material = material_of(study);
    const double ratio = number_of(study, "damping", 0, 0, 1e3);
    const double dt = number_of(study, "dt_s", 1e-9, 1);
    const double steps_given = number_of(study, "steps", 0, 1e7);
    const auto steps = static_cast<int>(steps_given);
    if (steps != steps_given)
        study.fail("/steps", "the number of steps is not a whole number", "give a whole number of steps");
    const auto pull = numbers_of(study, "gravity", 3, {0, 0, -9.81}, 1e6);
    const std::vector<std::int32_t> fixed = vertex_list_of(study, "fixed", mesh.vertices.size());
    MembraneSolve solve;
    solve.integrator = integrator_of(study);
    const int usual = solve.integrator == MembraneIntegrator::global_local ? (steps > 0 ? 10 : 500) : 0;
    solve.iterations = static_cast<int>(number_of(study, "iterations", usual, 0, 1e6));
    if (steps == 0 && (fixed.empty() || solve.integrator == MembraneIntegrator::symplectic))
        study.fail("/steps", "a static solve needs a fixed vertex and a solver",
                   "fix a vertex and use \"implicit\" or \"global_local\", or give steps");

    // The damping ratio refers to the stiffest mode, which is known once the membrane is built.
    const double frequency = highest_frequency(mesh, material, fixed, dt);
    material.stiffness_damping = frequency > 0 ? 2 * ratio / frequency : 0;
    const Membrane membrane(mesh, material, fixed);
    MembraneScratch scratch = membrane.make_scratch(steps > 0 ? dt : 0.0);
    const MembraneState start = membrane.make_state();
    const MembraneLimit limit = membrane.limit(start, scratch);
    MembraneState state = start;
    MembraneInputs inputs;
    inputs.gravity = Vector3(pull[0], pull[1], pull[2]);

    MembraneReport report;
    nlohmann::json faults = nlohmann::json::object();
    MembraneFault worst = MembraneFault::none;
    bool finite = true;
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < std::max(1, steps); ++i) {
        report = steps > 0 ? membrane.step(state, inputs, dt, scratch, solve)
                           : membrane.solve(state, inputs, scratch, solve);
        finite = finite && report.finite;
        worst = std::max(worst, report.fault);
        if (report.fault != MembraneFault::none) {
            auto& count = faults[name_of(report.fault)];
            count = count.is_null() ? 1 : count.get<int>() + 1;
        }
    }
    const double time =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();

    const MembraneEnergy energy = membrane.energy(state);
    double height = 0;
    for (std::size_t v = 0; v < state.positions.size(); ++v)
        height -= membrane.masses()[v] * inputs.gravity.dot(state.positions[v] - start.positions[v]);
    int springs[3] = {0, 0, 0};
    for (const MembraneSpring& spring : membrane.springs()) ++springs[static_cast<int>(spring.kind)];
    nlohmann::json result;
    result["vertices"] = nlohmann::json::array();
    for (const Vector3& p : state.positions) result["vertices"].push_back({p.x(), p.y(), p.z()});
    result["energy_j"] = energy.elastic() + energy.kinetic + height;
    result["energy_parts_j"] = {{"structural", energy.structural},
                                {"shear", energy.shear},
                                {"bend", energy.bend},
                                {"kinetic", energy.kinetic},
                                {"gravity", height}};
    result["finite"] = finite && Membrane::finite(state);
    result["dt_limit_s"] = finite_or_null(limit.time_step);
    result["dt_safe_s"] = finite_or_null(limit.safe_time_step);
    result["highest_frequency_rad_s"] = limit.frequency;
    result["damping_ratio"] = limit.damping_ratio;
    result["substeps"] = report.substeps;
    result["residual"] = report.residual;
    result["fault"] = name_of(worst);
    result["faults"] = faults;
    result["springs"] = {{"structural", springs[0]}, {"shear", springs[1]}, {"bend", springs[2]}};
    result["time_us_per_step"] = time / std::max(1, steps);
    return result;
}

}  // namespace fulcrum::lab
