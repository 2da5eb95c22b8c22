// SPDX-License-Identifier: Apache-2.0
// The haptic force filter: sum, power down to the rod, continuity (Eqs. 1-4).
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "sim_core/bowel/force_filter.h"
#include "sim_core/lab/reference_skin.h"
#include "sim_core/lab/validation_rooms.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {
namespace {

using Weights = std::map<std::int32_t, double>;

Weights weights_of(const FilteredForce& force) {
    Weights weights;
    for (int i = 0; i < force.count; ++i)
        weights[force.vertex[static_cast<std::size_t>(i)]] = force.weight[static_cast<std::size_t>(i)];
    return weights;
}

void sum_and_continuity(std::vector<ValidationCase>& cases) {
    const TriangleMesh mesh = make_tube(0.3, 120, 48, haustral_radius(0.016));
    const MeshAdjacency adjacency = build_adjacency(mesh);
    const SurfaceView view = view_of(mesh, adjacency);
    constexpr std::int32_t vertex = 48 * 60 + 11;
    const double area = mean_triangle_area(view, vertex), step = 1e-3 * area;
    double off = 0, rise = 0;
    Weights before;
    FilteredForce force;
    for (int i = 0; i <= 8000; ++i) {
        filter_force(view, vertex, i * step, FilterOptions{}, force);
        const Weights here = weights_of(force);
        double sum = 0;
        for (const auto& [v, weight] : here) sum += weight;
        off = std::max(off, std::fabs(sum - 1));
        if (i > 0) {
            for (const auto& [v, weight] : here)
                rise = std::max(rise, std::fabs(weight - (before.count(v) != 0 ? before.at(v) : 0)));
            for (const auto& [v, weight] : before) rise = std::max(rise, here.count(v) != 0 ? 0 : weight);
        }
        before = here;
    }
    cases.push_back(absolute_case("filter", "contact areas from 0 to 8 local triangles",
                                  "largest |sum of F_i / F0 - 1|", off, 0, "Eqs. 1 and 2: the F_i sum to F0",
                                  1e-12));
    // The quintic blend rises at most 1.875 over a band of 0.2 local areas; nothing may change faster.
    ValidationCase smooth = absolute_case(
        "filter", "the same, in steps of a thousandth of a triangle", "largest change of a weight in a step",
        rise, 1.875e-3 / 0.2, "steepest slope of the blend, 1.875 over 0.2 local areas: no jump in S", 0.01,
        1.875e-3 / 0.2, "above the steepest slope, relative");
    smooth.error = std::max(0.0, rise / smooth.reference - 1);
    smooth.passed = smooth.error <= smooth.tolerance && rise > 0;
    cases.push_back(smooth);
}

// Power of the filtered forces on the moving surface compared with that of the rod's loads on the moving rod.
void power(std::vector<ValidationCase>& cases) {
    const BowelSkin skin = make_skin(0.32, 0.016, 0.016, 160, 48, haustral_radius(0.016));
    RodSpec spec;
    spec.segments = 40;
    spec.length = 0.32;
    const Rod rod(spec);
    RodState state = rod.make_state();
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double u = static_cast<double>(i);
        state.nodes[i] += Vector3(0, 0.02 * std::sin(0.1 * u), 0.01 * std::cos(0.13 * u));
        state.velocities[i] = Vector3(0.05 * std::cos(u), 0.1 * std::sin(0.7 * u), 0.2);
    }
    for (std::size_t j = 0; j < state.directors.size(); ++j) {
        const Vector3 t = (state.nodes[j + 1] - state.nodes[j]).normalized();
        state.directors[j] = (state.directors[j] - t * t.dot(state.directors[j])).normalized();
        state.spins[j] = 3 * std::sin(0.4 * static_cast<double>(j));
    }
    const Cage& cage = skin.cage();
    std::vector<RingMotion> motions(static_cast<std::size_t>(cage.rings()));
    std::vector<RingFrame> frames(motions.size());
    for (std::size_t r = 0; r < motions.size(); ++r) {
        const RodMotion at = rod.frame_at(state, cage.arc_lengths[r]);
        motions[r].frame.position = frames[r].position = at.frame.position;
        motions[r].frame.rotation = frames[r].rotation = at.frame.rotation;
        motions[r].velocity = at.velocity;
        motions[r].angular_velocity = at.angular_velocity;
    }
    std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
    skin_all(skin, frames.data(), positions.data());
    const SurfaceView view = view_of(skin.rest(), skin.adjacency(), positions.data());
    const Vector3 applied(0.3, -1.2, 2.0);
    for (const FilterMode mode : {FilterMode::grade_0, FilterMode::grade_1, FilterMode::grade_2}) {
        FilterOptions options;
        options.mode = mode;
        FilteredForce force;
        filter_force(view, 48 * 80 + 5, 1e-5, options, force);
        std::vector<RingWrench> wrenches(motions.size());
        double surface = 0, size = 0, on_rod = 0;
        for (int i = 0; i < force.count; ++i) {
            const auto v = static_cast<std::size_t>(force.vertex[static_cast<std::size_t>(i)]);
            const Vector3 part = force.weight[static_cast<std::size_t>(i)] * applied;
            const double watts = part.dot(skin_velocity(skin.rows()[v], motions.data()));
            surface += watts;
            size += std::fabs(watts);
            add_ring_wrenches(skin.rows()[v], frames.data(), part, wrenches.data());
        }
        for (std::size_t r = 0; r < motions.size(); ++r) {
            const RodMotion at = rod.frame_at(state, cage.arc_lengths[r]);
            on_rod += wrenches[r].force.dot(at.velocity) + wrenches[r].moment.dot(at.angular_velocity);
        }
        cases.push_back(
            absolute_case("filter", "grade " + std::to_string(static_cast<int>(mode)) + " on a moving bowel",
                          "power on the rod, W", on_rod, surface, "power on the surface (virtual work)",
                          1e-12, size, "of the summed sizes"));
    }
}

}  // namespace

std::vector<ValidationCase> filter_validation() {
    std::vector<ValidationCase> cases;
    sum_and_continuity(cases);
    power(cases);
    return cases;
}

}  // namespace fulcrum::lab
