// SPDX-License-Identifier: Apache-2.0
// Prescribed ends, grasps and floor contact of the rod; buckling as zeros of the tangent's smallest
// eigenvalue.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/lab/held_elastica.h"
#include "sim_core/lab/reference_rod.h"
#include "sim_core/lab/validation_rooms.h"
#include "sim_core/rod/rod_system.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;

void held_ends(std::vector<ValidationCase>& cases) {
    RodSpec spec = cantilever_spec(50, 0.9);
    spec.inner_radius = 0.012;
    spec.ends[1] = RodEnd::clamped;
    RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    for (const double s : {0.3, 0.6}) resting.grasp(s, Vector3(0.015, 0, 0));
    double worst = 0;
    bool converged = true;
    for (int i = 0; i < 100; ++i) {
        inputs.grasps[0].target += Vector3(0, 0, 0.00025);
        inputs.grasps[1].target += Vector3(0, 0.00025, 0);
        inputs.ends[1].position += Vector3(0.0001, 0.0002, 0);
        const RodReport report = rod.solve(state, inputs, scratch);
        converged = converged && report.converged;
        worst = std::max({worst, (state.nodes.front() - inputs.ends[0].position).norm(),
                          (state.nodes.back() - inputs.ends[1].position).norm()});
        for (const RodGrasp& grasp : inputs.grasps) {
            worst = std::max(worst, (rod.wall_point(state, grasp.s, grasp.offset) - grasp.target).norm());
        }
    }
    ValidationCase held =
        absolute_case("rod", "both ends held and two grasps moved through 25 mm in 100 frames",
                      "worst distance from a target, m", worst, 0, "the targets themselves", 1e-9, 1, "m");
    held.passed = held.passed && converged;
    cases.push_back(held);
    const RodReport report = rod.solve(state, inputs, scratch);
    const Vector3 sum =
        report.end_force[0] + report.end_force[1] + inputs.grasps[0].reaction + inputs.grasps[1].reaction;
    cases.push_back(absolute_case("rod", "the same rod at rest", "sum of all supports, N", sum.norm(), 0,
                                  "balance of forces without other loads", 1e-6,
                                  inputs.grasps[0].reaction.norm(), "of a grasp's reaction"));
}

void two_grasps(std::vector<ValidationCase>& cases) {
    RodSpec spec = cantilever_spec(256, 0.9);
    spec.ends[1] = RodEnd::clamped;
    HeldElastica problem;
    problem.length = spec.length;
    problem.bending_stiffness = spec.young_modulus * pi * std::pow(spec.outer_radius, 4) / 4;
    problem.axial_stiffness = spec.young_modulus * pi * spec.outer_radius * spec.outer_radius;
    problem.moved = {{{0.005, 0.05}, {0.0, -0.03}}};
    const HeldElasticaSolution exact = solve_held_elastica(problem);
    RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    const RodReport report = hold_as(problem, resting);
    const std::string name = "two grasps on a rod between clamps, moved by 50 and 30 mm, 256 segments";
    const std::string source = "plane extensible elastica by multiple shooting, residual " +
                               std::string(exact.residual < 1e-10 ? "below 1e-10" : "too large");
    for (std::size_t h = 0; h < 2; ++h) {
        const Vector3 reaction(exact.reaction[h][0], 0, exact.reaction[h][1]);
        ValidationCase result =
            relative_case("rod", name, "reaction of grasp " + std::to_string(h + 1) + ", N",
                          inputs.grasps[h].reaction.norm(), reaction.norm(), source, 5e-3);
        result.error = (inputs.grasps[h].reaction - reaction).norm() / reaction.norm();
        result.passed = result.error <= result.tolerance && report.converged && exact.residual < 1e-10;
        cases.push_back(result);
    }
    const Vector3 middle = rod.frame_at(state, 0.5 * spec.length).frame.position;
    ValidationCase result = absolute_case("rod", name, "height of the middle, m", middle.z(), exact.middle_z,
                                          source, 1e-4, spec.length, "distance / L");
    result.error = std::hypot(middle.x() - exact.middle_x, middle.z() - exact.middle_z) / spec.length;
    result.passed = result.error <= result.tolerance;
    cases.push_back(result);
}

void floor_carries(std::vector<ValidationCase>& cases) {
    RodSpec spec;
    spec.segments = 64;
    RestingRod resting(spec);
    auto& [rod, state, scratch, inputs] = resting;
    inputs.gravity = Vector3(0, 0, -9.81);
    resting.add_floor(-0.03, 60);
    RodReport report;
    for (int i = 0; i < 3000; ++i) report = rod.step(state, inputs, 0.005, scratch);
    double sum = 0, worst = report.penetration;
    for (const RodContact& contact : inputs.contacts) {
        sum += contact.lambda;
        worst = std::max({worst, -contact.lambda, contact.lambda * std::fabs(contact.gap)});
    }
    cases.push_back(relative_case("rod", "a bowel dropped on a floor, at rest after 15 s",
                                  "sum of contact forces, N", sum, spec.linear_density * spec.length * 9.81,
                                  "its weight", 1e-6));
    cases.push_back(absolute_case("rod", "the same bowel on the floor",
                                  "worst of depth (m), pull (N), force times gap (N m)", worst, 0,
                                  "unilateral contact: g >= 0, lambda >= 0, lambda g = 0", 1e-6));
}

// Smallest eigenvalue of the tangent at a shape, free unknowns only.
double smallest_eigenvalue(const Rod& rod, const RodState& state, RodScratch& scratch,
                           const std::vector<int>& held) {
    RodScratch::Data& d = scratch.data();
    RodInputs inputs;
    shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
    for (auto* array : {&d.inertia, &d.dead, &d.predicted}) std::fill(array->begin(), array->end(), 0.0);
    d.dt = 0;
    evaluate(rod.tables(), d.shape, inputs, true, d);
    const auto size = static_cast<Eigen::Index>(d.gradient.size());
    Eigen::MatrixXd dense(size, size);
    std::vector<double> unit(d.gradient.size()), column(d.gradient.size());
    for (Eigen::Index k = 0; k < size; ++k) {
        std::fill(unit.begin(), unit.end(), 0.0);
        unit[static_cast<std::size_t>(k)] = 1;
        multiply(d.matrix, unit.data(), column.data());
        for (Eigen::Index r = 0; r < size; ++r) dense(r, k) = column[static_cast<std::size_t>(r)];
    }
    for (const int k : held) {
        dense.row(k).setZero();
        dense.col(k).setZero();
        dense(k, k) = 1e6;
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// First zero of a decreasing function between low and high; NaN if it does not change sign.
template <class Function>
double first_zero(double low, double high, Function&& lowest) {
    if (!(lowest(low) > 0) || !(lowest(high) < 0)) return std::nan("");
    for (int i = 0; i < 25; ++i) {
        const double middle = 0.5 * (low + high);
        (lowest(middle) > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

std::vector<ValidationCase> rod_constraint_validation() {
    std::vector<ValidationCase> cases;
    held_ends(cases);
    two_grasps(cases);
    floor_carries(cases);
    return cases;
}

std::vector<ValidationCase> buckling_validation() {
    std::vector<ValidationCase> cases;
    constexpr int n = 48;
    struct Row {
        RodEnd near, far;
        double k;
        bool far_slides;
        const char* name;
    };
    // The far end slides along the axis.
    for (const Row row :
         {Row{RodEnd::clamped, RodEnd::free, 2, false, "buckling, clamped and free"},
          Row{RodEnd::pinned, RodEnd::pinned, 1, true, "buckling, pinned at both ends"},
          Row{RodEnd::clamped, RodEnd::clamped, 0.5, true, "buckling, clamped at both ends"}}) {
        RodSpec spec = cantilever_spec(n, 0.5, 0.01);
        spec.ends[0] = row.near;
        spec.ends[1] = row.far;
        const Rod rod(spec);
        RodScratch scratch = rod.make_scratch();
        std::vector<int> held = {0, 1, 2, 4 * n + 3};
        if (row.near == RodEnd::pinned) held.push_back(3);  // the free spin
        if (row.far_slides) held.insert(held.end(), {4 * n + 1, 4 * n + 2});
        const double strain = first_zero(1e-6, 0.05, [&](double by) {
            RodState state = rod.make_state();
            for (Vector3& node : state.nodes) node.x() *= 1 - by;
            return smallest_eigenvalue(rod, state, scratch, held);
        });
        const double area = pi * spec.outer_radius * spec.outer_radius, ea = spec.young_modulus * area;
        const double ei = spec.young_modulus * area * spec.outer_radius * spec.outer_radius / 4,
                     p = ea * strain;
        cases.push_back(relative_case("rod", row.name, "P (1 - P/EA), N", p * (1 - p / ea),
                                      pi * pi * ei / std::pow(row.k * spec.length, 2),
                                      "Euler: pi^2 EI / (K L)^2", 0.005));
    }
    RodSpec spec = cantilever_spec(n, 0.5, 0.005);
    spec.ends[1] = RodEnd::clamped;
    const Rod rod(spec);
    RodScratch scratch = rod.make_scratch();
    const std::vector<int> held = {0, 1, 2, 4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3};
    const double angle = first_zero(1, 20, [&](double whole) {
        RodState state = rod.make_state();
        const auto turned = [&](double by) { return Vector3(0, std::cos(by), std::sin(by)); };
        double carried = 0;
        for (int i = 0; i <= n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const double part = whole * rod.torsional_stiffness() / (rod.tables().twist[at] * rod.length());
            state.joint_twist[at] = part;
            carried += part;
            if (i < n) state.directors[at] = turned(carried);
        }
        state.ends[1].rotation.col(0) = turned(whole);
        state.ends[1].rotation.col(1) = Vector3(1, 0, 0).cross(turned(whole));
        return smallest_eigenvalue(rod, state, scratch, held);
    });
    cases.push_back(relative_case(
        "rod", "twist of a straight rod clamped at both ends", "critical angle, rad", angle,
        8.9868 * (1 + spec.poisson_ratio),
        "8.9868 EI / GJ = 8.9868 (1 + nu): twice the first root of tan x = x (docs/QUALITY.md)", 0.005));
    return cases;
}

}  // namespace fulcrum::lab
