// SPDX-License-Identifier: Apache-2.0
// Stability range of the rod: implicit Euler steps of a bowel that is pulled, loaded, or slender.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim_core/lab/reference_rod.h"
#include "sim_core/lab/stability_rooms.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<double> decades(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(from * std::pow(to / from, static_cast<double>(i) / (count - 1)));
    return values;
}

/// Runs steps and classifies them: from the reports, and whether the rod stayed within its reach.
struct Judge {
    StabilityCell cell;
    double reach = 0;  // m, largest allowed distance of a node from the origin
    void see(const Rod& rod, const RodState& state, const RodReport& report) {
        if (!Rod::finite(state)) {
            cell.finite = false;
            cell.outcome = StabilityOutcome::fault;
            return;
        }
        double farthest = 0;
        for (const Vector3& node : state.nodes) farthest = std::max(farthest, node.norm());
        if (report.fault == RodFault::frozen || !report.finite || farthest > reach)
            cell.outcome = StabilityOutcome::fault;
        if (report.fault != RodFault::none || !report.converged)
            cell.outcome = std::max(cell.outcome, StabilityOutcome::degraded);
        cell.measure = std::max(cell.measure, report.residual);
        (void)rod;
    }
};

// A bowel held at both ends over a floor, grasped in the middle and moved 60 mm sideways and up at 0.5 m/s,
// then released.
StabilityCell pulled(double dt, double young) {
    Judge judge;
    judge.cell.at = {dt, young};
    judge.reach = 3;
    RodSpec spec;
    spec.segments = 48;
    spec.young_modulus = young;
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    inputs.gravity = Vector3(0, 0, -9.81);
    for (int i = 0; i < 45; ++i) {
        RodContact contact;
        contact.s = spec.length * (i + 0.5) / 45;
        contact.point = Vector3(0, 0, -0.03);
        contact.radius = 0.015;
        contact.friction = 0.3;
        inputs.contacts.push_back(contact);
    }
    RodGrasp grasp;
    grasp.s = 0.45;
    grasp.offset = Vector3(0.015, 0, 0);
    grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
    inputs.grasps.push_back(grasp);
    const int steps = static_cast<int>(std::clamp(0.24 / dt, 12.0, 60.0));
    for (int i = 0; i < steps && judge.cell.outcome != StabilityOutcome::fault; ++i) {
        if (i == steps / 2) inputs.grasps.clear();
        const double travel = std::min(0.5 * dt, 0.06 * 2 / steps);
        if (!inputs.grasps.empty()) inputs.grasps[0].target += travel * Vector3(0, 0.6, 0.8);
        judge.see(rod, state, rod.step(state, inputs, dt, scratch));
    }
    return judge.cell;
}

// A clamped cantilever that falls under its weight.
StabilityCell slender(double slenderness, int segments) {
    Judge judge;
    judge.cell.at = {slenderness, static_cast<double>(segments)};
    judge.reach = 3;
    RodSpec spec;
    spec.segments = segments;
    spec.length = 0.9;
    spec.outer_radius = 2 * spec.length / slenderness;  // r_g of a solid section is half its radius
    spec.inner_radius = 0;
    spec.linear_density = 0.25;
    spec.ends[0] = RodEnd::clamped;
    // Stiff enough to deflect by a tenth of its length.
    spec.young_modulus = 10 * spec.linear_density * 9.81 * std::pow(spec.length, 3) /
                         (8 * pi / 4 * std::pow(spec.outer_radius, 4));
    RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    inputs.gravity = Vector3(0, 0, -9.81);
    for (int i = 0; i < 12 && judge.cell.outcome != StabilityOutcome::fault; ++i)
        judge.see(rod, state, rod.step(state, inputs, 0.005, scratch));
    return judge.cell;
}

// A force across the tip of a clamped bowel, applied suddenly.
StabilityCell loaded(double dt, double force) {
    Judge judge;
    judge.cell.at = {dt, force};
    RodSpec spec;
    spec.segments = 48;
    spec.ends[0] = RodEnd::clamped;
    const Rod rod(spec);
    // For any force: no farther than the static stretch allows, times two for the oscillation.
    judge.reach = 2 * spec.length * (1 + force / rod.axial_stiffness());
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    inputs.nodal_forces.assign(49, Vector3::Zero());
    inputs.nodal_forces.back() = Vector3(0, 0.6 * force, -0.8 * force);
    for (int i = 0; i < 24 && judge.cell.outcome != StabilityOutcome::fault; ++i)
        judge.see(rod, state, rod.step(state, inputs, dt, scratch));
    return judge.cell;
}

/// One run for every pair of values.
template <typename Run>
StabilityMap mapped(const char* title, StabilityAxis first, StabilityAxis second, Run&& run) {
    StabilityMap map;
    map.model = "rod";
    map.title = std::string("Rod: ") + title;
    for (const double y : second.values) {
        for (const double x : first.values) map.cells.push_back(run(x, y));
    }
    map.axes = {std::move(first), std::move(second)};
    map.measure = "largest relative residual";
    return map;
}

}  // namespace

std::vector<StabilityMap> rod_stability() {
    std::vector<StabilityMap> maps;
    const std::vector<double> time_steps = decades(5e-5, 0.05, 10);
    {
        StabilityMap map = mapped("a bowel grasped, pulled and released, time step against stiffness",
                                  {"time_step_s", "s", time_steps, true},
                                  {"young_pa", "Pa", decades(1, 1e9, 10), true}, pulled);
        StabilityCurve curve;
        curve.name = "explicit limit";
        curve.formula =
            "2 / omega_max of the stretching modes, dt = h sqrt(mu / EA), h the segment's length and mu the "
            "mass per length: an explicit step diverges to the right of it. Implicit Euler is "
            "unconditionally stable and has no such bound";
        const double area = pi * (0.015 * 0.015 - 0.012 * 0.012), h = 0.9 / 48;
        for (const double young : decades(1, 1e9, 40)) {
            curve.x.push_back(h * std::sqrt(0.25 / (young * area)));
            curve.y.push_back(young);
        }
        map.theory.push_back(curve);
        maps.push_back(map);
    }
    {
        StabilityMap map = mapped("a cantilever that falls, slenderness against segments",
                                  {"slenderness", "", {5, 10, 20, 50, 100, 200, 500, 1000}, true},
                                  {"segments", "", {2, 4, 8, 16, 32, 64, 128, 256, 512, 1000, 2000}, true},
                                  [](double slenderness, double segments) {
                                      return slender(slenderness, static_cast<int>(segments));
                                  });
        StabilityCurve curve;
        curve.name = "rounding = tolerance";
        curve.formula =
            "n^2 (L/r_g)^2 2^-52 = 1e-6: condition number of the static tangent (stretching of one segment "
            "against bending of the whole) times rounding reaches the tolerance of the residual; above it "
            "results are finite but accuracy is not guaranteed";
        for (const double slenderness : decades(5, 1000, 30)) {
            curve.x.push_back(slenderness);
            curve.y.push_back(std::sqrt(1e-6 * 4503599627370496.0) / slenderness);
        }
        map.theory.push_back(curve);
        maps.push_back(map);
    }
    {
        StabilityMap map = mapped("a sudden force across the tip, time step against force",
                                  {"time_step_s", "s", time_steps, true},
                                  {"force_n", "N", decades(1e-6, 1e3, 10), true}, loaded);
        StabilityCurve curve;
        curve.name = "one segment per step";
        curve.formula =
            "F dt^2 / m = h: the force moves the end node by a whole segment within one step; an indication "
            "of where a Newton solve has to search, not a stability bound";
        const double h = 0.9 / 48;
        for (const double dt : decades(5e-5, 0.05, 30)) {
            curve.x.push_back(dt);
            curve.y.push_back(h * 0.25 * h * 0.5 / (dt * dt));
        }
        map.theory.push_back(curve);
        maps.push_back(map);
    }
    return maps;
}

}  // namespace fulcrum::lab
