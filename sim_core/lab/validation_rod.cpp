// SPDX-License-Identifier: Apache-2.0
// The rod without constraints, compared with closed forms and with the elastica by shooting.
#include <cmath>
#include <string>

#include "sim_core/lab/catenary.h"
#include "sim_core/lab/elastica.h"
#include "sim_core/lab/reference_rod.h"
#include "sim_core/lab/validation_rooms.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr const char* shooting =
    "extensible elastica as a boundary-value problem, shooting with Runge-Kutta, continued in load";

CantileverTip elastica_tip(const Rod& rod, double load) {
    const double l = rod.length();
    Cantilever c;
    c.length = l;
    c.bending_stiffness = rod.bending_stiffness();
    c.axial_stiffness = rod.axial_stiffness();
    c.distributed = load * rod.bending_stiffness() / (l * l * l);
    return solve_cantilever(c, 2000);
}

double distance_from(const RodState& state, const CantileverTip& tip) {
    return std::hypot(state.nodes.back().x() - tip.x, state.nodes.back().z() - tip.z);
}

// value and reference are the deflection of the tip; the error is the distance of the two tips over the
// length.
ValidationCase tip_case(const std::string& name, const SolvedRod& solved, double length, double x, double z,
                        const std::string& source, double tolerance) {
    const Vector3& last = solved.state.nodes.back();
    ValidationCase result = absolute_case("rod", name, "drop of the tip, m", -last.z(), -z, source, tolerance,
                                          length, "distance of the tips / L");
    result.error = std::hypot(last.x() - x, last.z() - z) / length;
    result.passed = result.error <= tolerance && solved.report.converged && solved.report.positive_definite;
    return result;
}

void dead_loads(std::vector<ValidationCase>& cases) {
    struct Load {
        double load, tolerance;
        int segments;
    };
    for (const Load row : {Load{1, 1e-3, 64}, Load{1, 2e-5, 96}, Load{10, 2e-5, 96}, Load{50, 1e-4, 96},
                           Load{346, 1e-3, 96}}) {
        const Rod rod(cantilever_spec(row.segments));
        const SolvedRod solved = distributed_load(rod, row.load);
        const CantileverTip tip = elastica_tip(rod, row.load);
        cases.push_back(
            tip_case("cantilever, dead load qL^3/EI = " + std::to_string(static_cast<int>(row.load)) + ", " +
                         std::to_string(row.segments) + " segments, from straight, default settings",
                     solved, rod.length(), tip.x, tip.z, shooting, row.tolerance));
    }
    // Order of convergence from 32 to 256 segments.
    double first = 0, last = 0;
    for (const int segments : {32, 256}) {
        const Rod rod(cantilever_spec(segments));
        RodSolve exact;
        exact.tolerance = 1e-9;
        (segments == 32 ? first : last) =
            distance_from(distributed_load(rod, 10, exact).state, elastica_tip(rod, 10));
    }
    cases.push_back(absolute_case("rod", "cantilever, qL^3/EI = 10, 32 against 256 segments",
                                  "order of convergence", std::log2(first / last) / 3, 2,
                                  "second order in segment length (docs/QUALITY.md)", 0.3));
}

// Inextensible cantilever with a tip force across it (Bisshopp and Drucker 1945): sqrt(P L^2 / EI) = K(k) -
// F(phi, k).
void elliptic_cantilevers(std::vector<ValidationCase>& cases) {
    const double length = 1.0, radius = 0.0019;  // L / r_g = 1053
    for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
        const double tip = degrees * pi / 180, k = std::sqrt((1 + std::sin(tip)) / 2),
                     phi = std::asin(1 / (k * std::sqrt(2.0)));
        const double root = std::comp_ellint_1(k) - std::ellint_1(k, phi);
        const double down = 1 - 2 * (std::comp_ellint_2(k) - std::ellint_2(k, phi)) / root;
        const double along = std::sqrt(2 * std::sin(tip)) / root;
        const Rod rod(cantilever_spec(64, length, radius));
        RodInputs inputs;
        inputs.nodal_forces.assign(65, Vector3::Zero());
        inputs.nodal_forces.back() = Vector3(0, 0, -root * root * rod.bending_stiffness());
        cases.push_back(
            tip_case("cantilever, tip force, tip turned by " + std::to_string(static_cast<int>(degrees)) +
                         " degrees, L/r_g = 1053, 64 segments",
                     solve_rod(rod, inputs, rod.make_state()), length, along, -down,
                     "inextensible elastica by elliptic integrals (Bisshopp and Drucker 1945)", 1e-3));
    }
}

void helix(std::vector<ValidationCase>& cases) {
    RodSpec spec = cantilever_spec(128, 0.6, 0.004);
    const double curvature = 15, torsion = 12;
    spec.intrinsic_curvature[0] = curvature;
    spec.intrinsic_curvature[2] = torsion;
    const Rod rod(spec);
    // Started straight, so that the solver must find the helix.
    RodState straight = rod.make_state();
    for (std::size_t i = 0; i < straight.nodes.size(); ++i)
        straight.nodes[i] = Vector3(rod.node_arc_lengths()[i], 0, 0);
    for (Vector3& director : straight.directors) director = Vector3(0, 1, 0);
    for (double& twist : straight.joint_twist) twist = 0;
    const SolvedRod solved = solve_rod(rod, RodInputs{}, straight);
    // Exact helix: with w^2 = k^2 + t^2 the Darboux vector is k d1 + t d3, constant in space.
    const double w = std::sqrt(curvature * curvature + torsion * torsion), length = rod.length();
    const Vector3 axis = (curvature * Vector3(0, 1, 0) + torsion * Vector3(1, 0, 0)) / w, t(1, 0, 0);
    const Vector3 along = axis * axis.dot(t), across = t - along;
    const Vector3 tip = along * length + across * (std::sin(w * length) / w) +
                        axis.cross(across) * ((1 - std::cos(w * length)) / w);
    ValidationCase result = absolute_case(
        "rod", "helix from natural curvature 15 / m and twist 12 rad / m, started from straight",
        "distance of the ends, m", solved.state.nodes.back().norm(), tip.norm(), "closed form of the helix",
        1e-3, length, "distance of the tips / L");
    result.error = (solved.state.nodes.back() - tip).norm() / length;
    result.passed = result.error <= result.tolerance && solved.report.converged;
    cases.push_back(result);
}

void torque(std::vector<ValidationCase>& cases) {
    struct Row {
        double angle, pull;
        int segments, steps;
        const char* name;
    };
    for (const Row row : {Row{2, 0, 64, 10, "clamped at both ends, twisted by 2 rad"},
                          Row{20 * pi, 0.4, 16, 400, "clamped, pulled straight, ten turns on 16 segments"}}) {
        RodSpec spec = cantilever_spec(row.segments);
        spec.ends[1] = RodEnd::clamped;
        RestingRod resting(spec);
        auto& [rod, state, scratch, inputs] = resting;
        inputs.ends[1].position.x() += row.pull;
        RodReport report;
        for (int i = 1; i <= row.steps; ++i) {
            const double angle = row.angle * i / row.steps;
            inputs.ends[1].rotation.col(0) = Vector3(0, std::cos(angle), std::sin(angle));
            inputs.ends[1].rotation.col(1) = Vector3(1, 0, 0).cross(Vector3(inputs.ends[1].rotation.col(0)));
            report = rod.solve(state, inputs, scratch);
        }
        const double shear = spec.young_modulus / (2 * (1 + spec.poisson_ratio)),
                     polar = 0.5 * pi * std::pow(spec.outer_radius, 4);
        cases.push_back(relative_case("rod", row.name, "torque at the clamp, N m", report.end_moment[1].x(),
                                      shear * polar * row.angle / spec.length,
                                      "G J theta / L, G = E / (2 (1 + nu)), J = pi r^4 / 2", 1e-6));
    }
}

void rigid_rotation(std::vector<ValidationCase>& cases) {
    RodSpec spec = cantilever_spec(40);
    spec.ends[0] = RodEnd::free;
    spec.intrinsic_curvature[0] = 3;
    spec.intrinsic_curvature[2] = 5;
    const Rod rod(spec);
    RodState state = rod.make_state();
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double u = 0.1 * static_cast<double>(i);
        state.nodes[i] += Vector3(0.004 * std::sin(2 * u), 0.01 * std::cos(u), 0.01 * std::sin(3 * u));
    }
    for (std::size_t j = 0; j < state.directors.size(); ++j) {
        const Vector3 t = (state.nodes[j + 1] - state.nodes[j]).normalized();
        state.directors[j] = (state.directors[j] - t * t.dot(state.directors[j])).normalized();
        state.joint_twist[j] = 0.01 * static_cast<double>(j);
    }
    const double before = rod.energy(state, RodInputs{}).elastic();
    const Matrix3 turn = Eigen::AngleAxisd(2.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (Vector3& node : state.nodes) node = turn * node + Vector3(0.3, -0.2, 1);
    for (Vector3& director : state.directors) director = turn * director;
    for (RodFrame& end : state.ends) end.rotation = turn * end.rotation;
    cases.push_back(relative_case("rod", "rigid rotation of a bent, twisted, stretched rod",
                                  "elastic energy, J", rod.energy(state, RodInputs{}).elastic(), before,
                                  "energy before the rotation (frame invariance)", 1e-10));
}

void chain(std::vector<ValidationCase>& cases) {
    RodSpec spec = cantilever_spec(128, 1.0, 0.001);
    spec.ends[0] = spec.ends[1] = RodEnd::held;  // twist prescribed: otherwise the rod would be free to spin
    spec.young_modulus = 323e3;
    spec.linear_density = 0.01;
    const Rod rod(spec);
    Catenary catenary;
    catenary.weight = 9.81 * spec.linear_density;
    catenary.axial_stiffness = spec.young_modulus * pi * spec.outer_radius * spec.outer_radius;
    std::vector<Vector3> nodes;
    for (const double s : rod.node_arc_lengths())
        nodes.emplace_back(catenary.span * s, 0, -1.5 * s * (1 - s));
    RodState state = rod.make_state(nodes);
    RodInputs inputs;
    inputs.gravity = Vector3(0, 0, -9.81);
    const SolvedRod solved = solve_rod(rod, inputs, state);
    const double tension = catenary_tension(catenary);
    double worst = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const CatenaryPoint point = catenary_point(catenary, tension, rod.node_arc_lengths()[i]);
        worst = std::max(
            worst, std::hypot(solved.state.nodes[i].x() - point.x, solved.state.nodes[i].z() - point.z));
    }
    ValidationCase result = absolute_case(
        "rod", "chain between two supports that do not restrain bending, EI / (w L^3) = 3e-6, 128 segments",
        "sag, m", -solved.state.nodes[64].z(), -catenary_point(catenary, tension, 0.5).z,
        "elastic catenary in closed form (Irvine 1981)", 1e-3, spec.length, "worst distance of a node / L");
    result.error = worst / spec.length;
    result.passed = result.error <= result.tolerance && solved.report.converged;
    cases.push_back(result);
    cases.push_back(relative_case("rod", "the same chain", "horizontal reaction, N",
                                  solved.report.end_force[1].x(), tension,
                                  "elastic catenary in closed form (Irvine 1981)", 1e-3));
}

}  // namespace

std::vector<ValidationCase> rod_validation() {
    std::vector<ValidationCase> cases;
    dead_loads(cases);
    elliptic_cantilevers(cases);
    helix(cases);
    torque(cases);
    rigid_rotation(cases);
    chain(cases);
    return cases;
}

}  // namespace fulcrum::lab
