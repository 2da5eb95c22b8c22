// SPDX-License-Identifier: Apache-2.0
// The accuracy rows of quality.md for the rod, against references that share nothing with it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "sim_core/lab/elastica.h"
#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

RodSpec cantilever_spec(int segments, double length = 0.4, double radius = 0.015) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = length;
    spec.outer_radius = radius;
    spec.inner_radius = 0;
    spec.ends[0] = RodEnd::clamped;
    return spec;
}

struct Solved {
    RodReport report;
    RodState state;
};

Solved solve(const Rod& rod, RodInputs inputs, RodState state) {
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    RodScratch scratch = rod.make_scratch();
    Solved solved;
    RodSolve options;
    options.tolerance = 1e-9;
    solved.report = rod.solve(state, inputs, scratch, options);
    solved.state = state;
    return solved;
}

Solved distributed(const Rod& rod, double load) {
    const double l = rod.length(), q = load * rod.bending_stiffness() / (l * l * l);
    RodInputs inputs;
    inputs.gravity = Vector3(0, 0, -q / rod.spec().linear_density);
    return solve(rod, inputs, rod.make_state());
}

lab::CantileverTip reference(const Rod& rod, double load, double tip_load = 0, bool extensible = true) {
    const double l = rod.length();
    lab::Cantilever c;
    c.length = l;
    c.bending_stiffness = rod.bending_stiffness();
    c.axial_stiffness = extensible ? rod.axial_stiffness() : 0;
    c.distributed = load * rod.bending_stiffness() / (l * l * l);
    c.tip_force = tip_load * rod.bending_stiffness() / (l * l);
    return lab::solve_cantilever(c, 1000);
}

double tip_error(const Solved& solved, const lab::CantileverTip& tip, double length) {
    const Vector3& last = solved.state.nodes.back();
    return std::hypot(last.x() - tip.x, last.z() - tip.z) / length;
}

TEST(RodAccuracy, CantileverUnderDeadLoadsFromStraightWithDefaults) {
    for (const double load : {1.0, 10.0, 50.0, 346.0}) {
        const Rod rod(cantilever_spec(96));
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        inputs.ends[0] = state.ends[0];
        inputs.gravity.z() =
            -load * rod.bending_stiffness() / std::pow(rod.length(), 3) / rod.spec().linear_density;
        const RodReport report = rod.solve(state, inputs, scratch);
        EXPECT_TRUE(report.converged && report.positive_definite) << load;
        const double error = tip_error({report, state}, reference(rod, load), rod.length());
        std::printf("load %5.0f: tip error %.2e L, %d systems\n", load, error, report.iterations);
        EXPECT_LT(error, load < 20 ? 2e-5 : (load < 100 ? 1e-4 : 1e-3)) << load;
    }
}

TEST(RodAccuracy, CantileverIsOfSecondOrder) {
    double before = 0;
    const lab::CantileverTip tip = reference(Rod(cantilever_spec(32)), 10);
    for (const int segments : {32, 64, 128, 256}) {
        const Rod rod(cantilever_spec(segments));
        const double error = tip_error(distributed(rod, 10), tip, rod.length());
        if (before > 0) {
            EXPECT_GT(before / error, 3.5) << segments;
            EXPECT_LT(before / error, 5) << segments;
        }
        before = error;
    }
}

// Inextensible cantilever with a tip force across it (Bisshopp and Drucker 1945): sqrt(P L^2 / EI) = K(k) -
// F(phi, k).
TEST(RodAccuracy, SlenderCantileverMatchesEllipticIntegrals) {
    const double length = 1.0, radius = 0.0019;  // L / r_g = 1053
    for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
        const double tip = degrees * pi / 180, k = std::sqrt((1 + std::sin(tip)) / 2),
                     phi = std::asin(1 / (k * std::sqrt(2.0)));
        const double root = std::comp_ellint_1(k) - std::ellint_1(k, phi);
        const double down = 1 - 2 * (std::comp_ellint_2(k) - std::ellint_2(k, phi)) / root;
        const double along = std::sqrt(2 * std::sin(tip)) / root;
        const Rod rod(cantilever_spec(64, length, radius));
        ASSERT_GE(length / (radius / 2), 1000);
        RodInputs inputs;
        inputs.nodal_forces.assign(65, Vector3::Zero());
        inputs.nodal_forces.back() = Vector3(0, 0, -root * root * rod.bending_stiffness());
        const Solved solved = solve(rod, inputs, rod.make_state());
        EXPECT_TRUE(solved.report.converged);
        EXPECT_NEAR(solved.state.nodes.back().x(), along, 1e-3) << degrees;
        EXPECT_NEAR(solved.state.nodes.back().z(), -down, 1e-3) << degrees;
    }
}

TEST(RodAccuracy, ARigidRotationCostsNothing) {
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
    const RodEnergy before = rod.energy(state, RodInputs{});
    const Matrix3 turn = Eigen::AngleAxisd(2.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (Vector3& node : state.nodes) node = turn * node + Vector3(0.3, -0.2, 1);
    for (Vector3& director : state.directors) director = turn * director;
    for (RodFrame& end : state.ends) end.rotation = turn * end.rotation;
    const RodEnergy after = rod.energy(state, RodInputs{});
    EXPECT_NEAR(after.bend, before.bend, 1e-10 * before.bend);
    EXPECT_NEAR(after.twist, before.twist, 1e-10 * before.twist);
    EXPECT_NEAR(after.stretch, before.stretch, 1e-10 * before.stretch);
}

TEST(RodAccuracy, BothEndsHeldAndTwoGraspsMeetTheirTargets) {
    RodSpec spec = cantilever_spec(50, 0.9);
    spec.inner_radius = 0.012;
    spec.ends[1] = RodEnd::clamped;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    for (const double s : {0.3, 0.6}) {
        RodGrasp grasp;
        grasp.s = s;
        grasp.offset = Vector3(0.015, 0, 0);
        grasp.target = rod.wall_point(state, s, grasp.offset);
        inputs.grasps.push_back(grasp);
    }
    for (int i = 0; i < 100; ++i) {
        inputs.grasps[0].target += Vector3(0, 0, 0.00025);
        inputs.grasps[1].target += Vector3(0, 0.00025, 0);
        inputs.ends[1].position += Vector3(0.0001, 0.0002, 0);
        const RodReport report = rod.solve(state, inputs, scratch);
        ASSERT_TRUE(report.converged) << i << " " << report.residual << " " << report.constraint_residual;
        EXPECT_LE(report.constraint_residual, 1e-9);
        EXPECT_LE((state.nodes.front() - inputs.ends[0].position).norm(), 1e-9);
        EXPECT_LE((state.nodes.back() - inputs.ends[1].position).norm(), 1e-9);
        if (i > 0) {
            EXPECT_LE(report.iterations, 4) << i;
        }
    }
    // Without other loads the jaws and the supports balance.
    const RodReport report = rod.solve(state, inputs, scratch);
    const Vector3 sum =
        report.end_force[0] + report.end_force[1] + inputs.grasps[0].reaction + inputs.grasps[1].reaction;
    EXPECT_LT(sum.norm(), 1e-6 * inputs.grasps[0].reaction.norm());
}

TEST(RodAccuracy, HelixFromNaturalCurvatureAndTorsion) {
    RodSpec spec = cantilever_spec(128, 0.6, 0.004);
    const double curvature = 15, torsion = 12;
    spec.intrinsic_curvature[0] = curvature;
    spec.intrinsic_curvature[2] = torsion;
    const Rod rod(spec);
    // Started straight, so that the solver has to find the helix.
    RodState state = rod.make_state();
    RodState straight = state;
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        straight.nodes[i] = Vector3(rod.node_arc_lengths()[i], 0, 0);
    for (Vector3& director : straight.directors) director = Vector3(0, 1, 0);
    for (double& twist : straight.joint_twist) twist = 0;
    const Solved solved = solve(rod, RodInputs{}, straight);
    EXPECT_TRUE(solved.report.converged);
    // Exact helix: with w^2 = k^2 + t^2 the Darboux vector is k d1 + t d3, constant in space.
    const double w = std::sqrt(curvature * curvature + torsion * torsion), length = rod.length();
    const Vector3 axis = (curvature * Vector3(0, 1, 0) + torsion * Vector3(1, 0, 0)) / w, t(1, 0, 0);
    const Vector3 along = axis * axis.dot(t), across = t - along;
    const Vector3 tip = along * length + across * (std::sin(w * length) / w) +
                        axis.cross(across) * ((1 - std::cos(w * length)) / w);
    EXPECT_LT((solved.state.nodes.back() - tip).norm(), 1e-3 * length);
    EXPECT_LT(rod.energy(solved.state, RodInputs{}).elastic(), 1e-9);
}

// Smallest eigenvalue of the tangent on a shape, free unknowns only.
double smallest_eigenvalue(const Rod& rod, const RodState& state, RodScratch& scratch,
                           const std::vector<int>& held) {
    RodScratch::Data& d = scratch.data();
    RodInputs inputs;
    shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
    for (auto* array : {&d.inertia, &d.dead, &d.predicted}) std::fill(array->begin(), array->end(), 0.0);
    d.dt = 0;
    EXPECT_TRUE(evaluate(rod.tables(), d.shape, inputs, true, d));
    const Eigen::Index size = static_cast<Eigen::Index>(d.gradient.size());
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

TEST(RodAccuracy, EulerBucklingLoads) {
    struct Row {
        RodEnd near, far;
        double k;
        bool far_slides;
    };
    // K = 2, 1, 0.5 (the far clamp slides along the axis).
    for (const Row row :
         {Row{RodEnd::clamped, RodEnd::free, 2, false}, Row{RodEnd::pinned, RodEnd::pinned, 1, true},
          Row{RodEnd::clamped, RodEnd::clamped, 0.5, true}}) {
        const int n = 64;
        RodSpec spec = cantilever_spec(n, 0.5, 0.01);
        spec.ends[0] = row.near;
        spec.ends[1] = row.far;
        const Rod rod(spec);
        RodScratch scratch = rod.make_scratch();
        std::vector<int> held = {0, 1, 2, 4 * n + 3};
        if (row.near == RodEnd::pinned) held.push_back(3);  // the free spin
        if (row.far_slides) {
            held.push_back(4 * n + 1);
            held.push_back(4 * n + 2);
        }
        const auto lowest = [&](double strain) {
            RodState state = rod.make_state();
            for (Vector3& node : state.nodes) node.x() *= 1 - strain;
            return smallest_eigenvalue(rod, state, scratch, held);
        };
        double low = 0, high = 0.05;
        ASSERT_GT(lowest(1e-6), 0);
        ASSERT_LT(lowest(high), 0);
        for (int i = 0; i < 25; ++i) {
            const double middle = 0.5 * (low + high);
            (lowest(middle) > 0 ? low : high) = middle;
        }
        const double p = rod.axial_stiffness() * low;
        const double euler = pi * pi * rod.bending_stiffness() / std::pow(row.k * rod.length(), 2);
        EXPECT_NEAR(p * (1 - p / rod.axial_stiffness()) / euler, 1, 0.005) << row.k;
    }
}

TEST(RodAccuracy, TwistBucklingOfAClampedStraightRod) {
    const int n = 64;
    RodSpec spec = cantilever_spec(n, 0.5, 0.005);
    spec.ends[1] = RodEnd::clamped;
    const Rod rod(spec);
    RodScratch scratch = rod.make_scratch();
    const std::vector<int> held = {0, 1, 2, 4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3};
    const auto lowest = [&](double angle) {
        RodState state = rod.make_state();
        const auto turned = [&](double by) { return Vector3(0, std::cos(by), std::sin(by)); };
        double carried = 0;
        const double whole = rod.tables().node_s.back();
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const double part = angle * (1 / rod.tables().twist[at]) * rod.torsional_stiffness() / whole;
            state.joint_twist[at] = part;
            sum += part;
            carried += part;
            if (i < n) state.directors[at] = turned(carried);
        }
        EXPECT_NEAR(sum, angle, 1e-9);
        state.ends[1].rotation.col(0) = turned(angle);
        state.ends[1].rotation.col(1) = Vector3(1, 0, 0).cross(turned(angle));
        return smallest_eigenvalue(rod, state, scratch, held);
    };
    double low = 1, high = 20;
    ASSERT_GT(lowest(low), 0);
    ASSERT_LT(lowest(high), 0);
    for (int i = 0; i < 25; ++i) {
        const double middle = 0.5 * (low + high);
        (lowest(middle) > 0 ? low : high) = middle;
    }
    EXPECT_NEAR(low, 8.9868 * (1 + spec.poisson_ratio), 0.005 * 12.13);
}

TEST(RodAccuracy, TenTurnsSurviveSixteenSegmentsAndGiveTheirTorque) {
    RodSpec spec = cantilever_spec(16, 0.4, 0.015);
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    // Pulled, so that it stays straight: torque is then G J theta / L exactly.
    inputs.ends[1].position.x() += 0.4;
    RodReport report;
    const int steps = 400;
    for (int i = 1; i <= steps; ++i) {
        const double angle = 20 * pi * i / steps;
        inputs.ends[1].rotation.col(0) = Vector3(0, std::cos(angle), std::sin(angle));
        inputs.ends[1].rotation.col(1) = Vector3(1, 0, 0).cross(Vector3(inputs.ends[1].rotation.col(0)));
        report = rod.solve(state, inputs, scratch);
        ASSERT_TRUE(report.converged) << i;
    }
    const double torque = rod.torsional_stiffness() * 20 * pi / 0.4;
    EXPECT_NEAR(report.end_moment[1].x(), torque, 1e-6 * torque);
    EXPECT_NEAR(report.end_moment[0].x(), -torque, 1e-6 * torque);
}

}  // namespace
}  // namespace fulcrum
