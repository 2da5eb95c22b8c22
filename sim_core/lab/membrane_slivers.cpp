// SPDX-License-Identifier: Apache-2.0
// Stability range of symplectic Euler for meshes with slivers, and the theoretical limit.
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/lab/membrane_reference.h"
#include "sim_core/lab/membrane_tradeoff.h"

namespace fulcrum::lab {
namespace {

constexpr int side = 9, steps = 40;
constexpr double stiffness = 10;  // N/m
constexpr double damping = 1e-5;  // s

/// A sheet held at two corners, rows compressed to slivers of the given aspect, displaced and released.
struct Case {
    Membrane membrane;
    explicit Case(double aspect) : membrane(mesh(aspect), material(), {0, side - 1}) {}
    static TriangleMesh mesh(double aspect) {
        TriangleMesh sheet = make_sheet(side, side, 0.1, 0.1);
        const double edge = 0.1 / (side - 1);
        for (int r = 1; r < side; r += 2) {
            for (int c = 0; c < side; ++c)
                sheet.vertices[static_cast<std::size_t>(r * side + c)].y() = edge * (r - 1) + edge / aspect;
        }
        return sheet;
    }
    static MembraneMaterial material() {
        MembraneMaterial m;
        m.structural_stiffness = stiffness;
        m.shear_stiffness = 0.5 * stiffness;
        m.bend_stiffness = 0.05 * stiffness;
        m.mass = 0.01;
        m.stiffness_damping = damping;
        return m;
    }
    StabilityCell run(double dt) const {
        StabilityCell cell;
        MembraneSolve solve;
        solve.integrator = MembraneIntegrator::symplectic;
        solve.most_substeps = 64;
        MembraneScratch scratch = membrane.make_scratch(dt);
        MembraneState state = membrane.make_state();
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            if (v != 0 && v != side - 1) state.positions[v] *= 1.05;
        }
        const double start = membrane.energy(state).elastic();
        MembraneInputs inputs;
        MembraneFault worst = MembraneFault::none;
        for (int i = 0; i < steps; ++i) {
            const MembraneReport report = membrane.step(state, inputs, dt, scratch, solve);
            worst = std::max(worst, report.fault);
            cell.finite = cell.finite && report.finite && Membrane::finite(state);
        }
        const MembraneEnergy energy = membrane.energy(state);
        cell.measure = (energy.elastic() + energy.kinetic) / start;
        const bool bounded = cell.measure <= 1 / (1 - 0.98 * 0.98);
        if (!cell.finite || !bounded || worst >= MembraneFault::refused)
            cell.outcome = StabilityOutcome::fault;
        else if (worst != MembraneFault::none)
            cell.outcome = StabilityOutcome::degraded;
        return cell;
    }
    double limit() const {
        MembraneScratch scratch = membrane.make_scratch();
        return membrane.limit(membrane.make_state(), scratch).time_step;
    }
};

const std::vector<double>& time_steps() {
    static const std::vector<double> values = {5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2};
    return values;
}

}  // namespace

StabilityMap membrane_sliver_map() {
    StabilityMap map;
    map.model = "membrane";
    map.title = "Membrane, symplectic: time step against slivers";
    map.axes = {{"time_step_s", "s", time_steps(), true},
                {"triangle_aspect", "", {1, 10, 100, 1e3, 1e4, 1e5, 1e6}, true}};
    map.measure = "energy after 40 steps over the start's";
    StabilityCurve curve;
    curve.name = "limit of an undivided step";
    curve.formula = "dt = (2/w)(sqrt(1 + z^2) - z), w the highest frequency, z its damping ratio";
    for (const double aspect : map.axes[1].values) {
        const Case sheet(aspect);
        for (const double dt : map.axes[0].values) {
            StabilityCell cell = sheet.run(dt);
            cell.at = {dt, aspect};
            map.cells.push_back(cell);
        }
        curve.x.push_back(sheet.limit());
        curve.y.push_back(aspect);
    }
    map.theory = {curve};
    return map;
}

}  // namespace fulcrum::lab
