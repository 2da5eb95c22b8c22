// SPDX-License-Identifier: Apache-2.0
// Requirements on every energy of the rod, for both laws, plain and layered walls: force and tangent are its
// derivatives (whole system: derivative_test.cpp), the rest state has no force, rigid motion does not change
// the energy, momentum is conserved.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

struct Kind {
    MaterialLaw law;
    bool layered, curved;
};
constexpr Kind kinds[] = {{MaterialLaw::linear, false, false},
                          {MaterialLaw::linear, true, true},
                          {MaterialLaw::exp2, false, false},
                          {MaterialLaw::exp2, false, true},
                          {MaterialLaw::exp2, true, true}};

RodSpec make(const Kind& kind, int segments, double length = 0.3) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = length;
    spec.law = kind.law;
    if (kind.layered) spec.layers = bowel_wall_layers();
    if (kind.curved) {
        spec.intrinsic_curvature[0] = 6;
        spec.intrinsic_curvature[1] = -4;
        spec.intrinsic_curvature[2] = 5;
    }
    return spec;
}

// Randomly bent, stretched and twisted.
RodState disturbed(const Rod& rod, double size) {
    RodState state = rod.make_state();
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Vector3& node : state.nodes)
        node += size * Vector3(uniform(random), uniform(random), uniform(random));
    RodScratch scratch = rod.make_scratch();
    RodScratch::Data& d = scratch.data();
    shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
    for (std::size_t j = 0; j < state.directors.size(); ++j) {
        const Vector3 t = (state.nodes[j + 1] - state.nodes[j]).normalized();
        state.directors[j] = (state.directors[j] - t * t.dot(state.directors[j])).normalized();
    }
    shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
    for (std::size_t k = 3; k + 4 < d.step.size(); k += 4) d.step[k] = 0.3 * uniform(random);
    EXPECT_TRUE(retract(rod.tables(), d.shape, d.step.data(), 1.0, d.trial));
    state_from_shape(d.trial, state);
    return state;
}

// The public energy, differentiated numerically by nodes, against the solver's gradient.
TEST(RodConformance, ForceIsMinusTheSlopeOfTheEnergy) {
    for (const Kind& kind : kinds) {
        const Rod rod(make(kind, 12));
        const RodState state = disturbed(rod, 0.002);
        RodScratch scratch = rod.make_scratch();
        RodScratch::Data& d = scratch.data();
        RodInputs inputs;
        shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
        ASSERT_TRUE(evaluate(rod.tables(), d.shape, inputs, false, d));
        const std::vector<double> gradient = d.gradient;
        double size = 0;
        for (const double g : gradient) size = std::max(size, std::fabs(g));
        const double h = 2e-6;
        std::vector<double> step(gradient.size(), 0.0);
        for (std::size_t k = 0; k < gradient.size(); ++k) {
            if (k % 4 == 3) continue;  // positions only: the retraction updates the twist of the neighbours
            const auto energy = [&](double by) {
                step[k] = by;
                EXPECT_TRUE(retract(rod.tables(), d.shape, step.data(), 1.0, d.trial));
                step[k] = 0;
                RodState moved = state;
                state_from_shape(d.trial, moved);
                return rod.energy(moved, inputs).elastic();
            };
            const double slope = (8 * (energy(h) - energy(-h)) - energy(2 * h) + energy(-2 * h)) / (12 * h);
            EXPECT_NEAR(gradient[k], slope, 1e-7 * size) << k;
        }
    }
}

// The rod's matrix at d.shape, dense.
Eigen::MatrixXd tangent_of(const BlockBand& matrix, Eigen::Index unknowns) {
    Eigen::MatrixXd tangent(unknowns, unknowns);
    std::vector<double> unit(static_cast<std::size_t>(unknowns), 0.0);
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        unit[static_cast<std::size_t>(k)] = 1;
        multiply(matrix, unit.data(), tangent.col(k).data());
        unit[static_cast<std::size_t>(k)] = 0;
    }
    return tangent;
}

// Fourth-order differences of the gradient along each unknown, symmetrised. The gradient at a moved shape
// refers to directors transported to that shape; the transport around a loop of two motions turns them by an
// angle that is antisymmetric in the two, so the symmetric part of the differences is the second derivative.
Eigen::MatrixXd differences_of_force(const Rod& rod, RodScratch::Data& d, Eigen::Index unknowns) {
    RodInputs inputs;
    Eigen::MatrixXd slopes(unknowns, unknowns);
    std::vector<double> step(static_cast<std::size_t>(unknowns), 0.0);
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        const double h = k % 4 == 3 ? 1e-3 : 2e-6;  // rad, m
        const auto gradient = [&](double by) -> Eigen::VectorXd {
            step[static_cast<std::size_t>(k)] = by;
            EXPECT_TRUE(retract(rod.tables(), d.shape, step.data(), 1.0, d.trial));
            step[static_cast<std::size_t>(k)] = 0;
            EXPECT_TRUE(evaluate(rod.tables(), d.trial, inputs, false, d));
            return Eigen::Map<const Eigen::VectorXd>(d.gradient.data(), unknowns);
        };
        slopes.col(k) = (8 * (gradient(h) - gradient(-h)) - gradient(2 * h) + gradient(-2 * h)) / (12 * h);
    }
    return 0.5 * (slopes + slopes.transpose());
}

// Largest difference of two tangents, relative to the stiffness of the two unknowns. The twist of the last
// node is not an unknown.
double worst_difference(const Eigen::MatrixXd& tangent, const Eigen::MatrixXd& slopes) {
    const Eigen::Index unknowns = tangent.rows() - 1;
    double worst = 0;
    for (Eigen::Index i = 0; i < unknowns; ++i) {
        for (Eigen::Index j = 0; j < unknowns; ++j) {
            const double scale = std::sqrt(std::fabs(slopes(i, i) * slopes(j, j)));
            worst = std::max(worst, std::fabs(tangent(i, j) - slopes(i, j)) / scale);
        }
    }
    return worst;
}

TEST(RodConformance, TangentIsTheSlopeOfTheForce) {
    constexpr double tolerance = 1e-7, perturbation = 1e-5;
    for (const Kind& kind : kinds) {
        const Rod rod(make(kind, 12));
        const RodState state = disturbed(rod, 0.002);
        RodScratch scratch = rod.make_scratch();
        RodScratch::Data& d = scratch.data();
        RodInputs inputs;
        shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
        ASSERT_TRUE(evaluate(rod.tables(), d.shape, inputs, true, d));
        const BlockBand matrix = d.matrix;
        const auto unknowns = static_cast<Eigen::Index>(d.gradient.size());
        const Eigen::MatrixXd slopes = differences_of_force(rod, d, unknowns);
        EXPECT_LT(worst_difference(tangent_of(matrix, unknowns), slopes), tolerance);
        // The comparison detects a tangent that is wrong by 1e-5 in one entry of any block.
        for (std::size_t row = 0; row + 2 < matrix.diagonal.size(); row += 3) {
            for (int block = 0; block < 3; ++block) {
                BlockBand wrong = matrix;
                const auto first = static_cast<Eigen::Index>(4 * row), second = first + 4 * block;
                const double scale = std::sqrt(std::fabs(slopes(first, first) * slopes(second, second)));
                auto& blocks = block == 0 ? wrong.diagonal : block == 1 ? wrong.first : wrong.second;
                blocks[row].column[0][0] += perturbation * scale;
                EXPECT_GT(worst_difference(tangent_of(wrong, unknowns), slopes), tolerance)
                    << "block " << block << " of row " << row;
            }
        }
    }
}

TEST(RodConformance, RestStateHasNoForce) {
    for (const Kind& kind : kinds) {
        const Rod rod(make(kind, 40));
        RodState state = rod.make_state();
        RodScratch scratch = rod.make_scratch();
        RodInputs inputs;
        RodScratch::Data& d = scratch.data();
        shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
        ASSERT_TRUE(evaluate(rod.tables(), d.shape, inputs, false, d));
        for (const double g : d.gradient) EXPECT_LT(std::fabs(g), 1e-12 * rod.axial_stiffness());
        EXPECT_LT(rod.energy(state, inputs).elastic(), 1e-15);  // J; natural curvature squared, to rounding
    }
}

TEST(RodConformance, RigidMotionKeepsTheEnergyAndRotatesTheForces) {
    for (const Kind& kind : kinds) {
        const Rod rod(make(kind, 30));
        RodState state = disturbed(rod, 0.002);
        RodScratch scratch = rod.make_scratch();
        RodScratch::Data& d = scratch.data();
        RodInputs inputs;
        const auto gradient = [&] {
            shape_from_state(rod.tables(), rod.spec(), state, state.ends, d.shape);
            EXPECT_TRUE(evaluate(rod.tables(), d.shape, inputs, false, d));
            return d.gradient;
        };
        const std::vector<double> before = gradient();
        const double energy = rod.energy(state, inputs).elastic();
        const Matrix3 turn = Eigen::AngleAxisd(1.7, Vector3(0.3, -1, 0.8).normalized()).toRotationMatrix();
        for (Vector3& node : state.nodes) node = turn * node + Vector3(0.4, 0.1, -0.7);
        for (Vector3& director : state.directors) director = turn * director;
        for (RodFrame& end : state.ends) end.rotation = turn * end.rotation;
        const std::vector<double> after = gradient();
        EXPECT_NEAR(rod.energy(state, inputs).elastic(), energy, 1e-10 * energy);
        double size = 0;
        Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
        for (std::size_t i = 0; i < state.nodes.size(); ++i) {
            const Vector3 a(before[4 * i], before[4 * i + 1], before[4 * i + 2]),
                b(after[4 * i], after[4 * i + 1], after[4 * i + 2]);
            size = std::max(size, a.norm());
            EXPECT_LT((turn * a - b).norm(), 1e-9 * size) << i;
            EXPECT_NEAR(before[4 * i + 3], after[4 * i + 3], 1e-10 * size) << i;
            sum += b;
            moment += state.nodes[i].cross(b);
            if (i + 1 < state.nodes.size())
                moment += (state.nodes[i + 1] - state.nodes[i]).normalized() * after[4 * i + 3];
        }
        // Forces and moments of a free rod are in equilibrium.
        EXPECT_LT(sum.norm(), 1e-11 * size * 30);
        EXPECT_LT(moment.norm(), 1e-10 * size);
    }
}

struct Lost {
    double linear, angular;
};

// Momentum lost by a free rod that flies, rotates and oscillates for 0.1 s. In a plane, no segment spins
// about its own axis.
Lost flight(const Kind& kind, bool plane, double dt) {
    RodSpec spec = make(kind, 20);
    spec.mass_damping = 0;
    if (plane && kind.curved) spec.intrinsic_curvature[1] = spec.intrinsic_curvature[2] = 0;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    const Vector3 turn = plane ? Vector3(0, 6, 0) : Vector3(0.5, 1, 6);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const Vector3 r = state.nodes[i] - state.nodes[10];
        state.velocities[i] = Vector3(0.3, plane ? 0.0 : -0.2, 0.1) + turn.cross(r) +
                              Vector3(0, 0, 0.2 * std::sin(0.3 * static_cast<double>(i)));
    }
    const auto momentum = [&](Vector3& linear, Vector3& angular) {
        linear = angular = Vector3::Zero();
        for (std::size_t i = 0; i < state.nodes.size(); ++i) {
            const Vector3 p = rod.node_mass(static_cast<int>(i)) * state.velocities[i];
            linear += p;
            angular += state.nodes[i].cross(p);
            if (i + 1 == state.nodes.size()) continue;
            const Vector3 t = (state.nodes[i + 1] - state.nodes[i]).normalized();
            angular += rod.tables().spin_inertia[i] * state.spins[i] * t;
        }
    };
    Vector3 linear, angular, linear_end, angular_end;
    momentum(linear, angular);
    RodSolve exact;
    exact.tolerance = 1e-12;
    const int steps = static_cast<int>(std::lround(0.1 / dt));
    for (int i = 0; i < steps; ++i) {
        const RodReport report = rod.step(state, inputs, dt, scratch, exact);
        EXPECT_TRUE(report.finite && report.fault == RodFault::none) << i;
    }
    momentum(linear_end, angular_end);
    return {(linear_end - linear).norm(), (angular_end - angular).norm() / angular.norm()};
}

TEST(RodConformance, ImplicitEulerConservesLinearMomentumAndAngularMomentumToFirstOrder) {
    for (const Kind& kind : kinds) {
        for (const bool plane : {true, false}) {
            Lost before{};
            for (const double dt : {0.002, 0.001, 0.0005}) {
                const Lost lost = flight(kind, plane, dt);
                EXPECT_LT(lost.linear, 1e-10);
                if (before.angular > 0) {
                    std::printf(
                        "%s%s%s%s: %.2e of the angular momentum lost in 0.1 s at %.2g ms, ratio %.2f\n",
                        kind.law == MaterialLaw::exp2 ? "EXP2" : "linear", kind.layered ? ", layered" : "",
                        kind.curved ? ", curved" : "", plane ? ", in a plane" : "", lost.angular, 1e3 * dt,
                        before.angular / lost.angular);
                    EXPECT_GT(before.angular / lost.angular, 1.7);
                    EXPECT_LT(before.angular / lost.angular, 2.3);
                }
                before = lost;
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum
