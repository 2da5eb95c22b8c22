// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md, generated: every step's result is finite, and failures are reported.
// FULCRUM_CASES sets the number of cases (default 60; the full run is 2500).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sim_core/rod/rod.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

struct Outcome {
    int converged = 0, small = 0, degraded = 0, fault = 0, refused = 0;
};

class Generator {
  public:
    explicit Generator(std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15ULL + 1) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
    int integer(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    Vector3 direction() {
        Vector3 v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        return v.norm() > 1e-3 ? Vector3(v.normalized()) : Vector3(Vector3::UnitX());
    }

  private:
    std::mt19937_64 random_;
};

bool finite_report(const RodReport& r) {
    double sum = r.residual + r.force_residual + r.constraint_residual + r.penetration + r.contact_sum;
    for (int e = 0; e < 2; ++e) sum += r.end_force[e].sum() + r.end_moment[e].sum();
    return std::isfinite(sum);
}

void run(std::uint64_t seed, Outcome& outcome) {
    Generator g(seed);
    RodSpec spec;
    // 2 to 2000 nodes; few are large, so that no size dominates the run time.
    spec.segments =
        std::max(2, static_cast<int>(1999 / g.log_uniform(1, 1999) / (g.integer(0, 7) == 0 ? 1 : 10)));
    spec.length = g.log_uniform(0.02, 2);
    // Slenderness L / sqrt(I / A) of 5 to 1000.
    const double gyration = spec.length / g.log_uniform(5, 1000),
                 hollow = g.uniform(0, 0.95) * g.integer(0, 1);
    spec.outer_radius = 2 * gyration / std::sqrt(1 + hollow * hollow);
    spec.inner_radius = hollow * spec.outer_radius;
    spec.young_modulus = g.log_uniform(1, 1e9);
    spec.linear_density = g.log_uniform(0.01, 5);
    spec.law = g.integer(0, 2) == 0 ? MaterialLaw::exp2 : MaterialLaw::linear;
    for (RodEnd& end : spec.ends) end = static_cast<RodEnd>(g.integer(0, 3));
    const int kind = g.integer(0, 9);
    if (kind == 1) {
        for (double& k : spec.intrinsic_curvature) k = g.uniform(-3, 3) * spec.segments / spec.length / 2;
    }
    if (kind == 2) {
        Vector3 at = Vector3::Zero();
        for (int i = 0; i <= spec.segments; ++i) {
            spec.rest_nodes.push_back(at);
            at += g.log_uniform(1e-3, 1) * spec.length / spec.segments *
                  (Vector3::UnitX() + 0.5 * g.direction());
        }
        if (g.integer(0, 3) == 0) spec.rest_nodes[1] = spec.rest_nodes[0];  // no segment has zero length
    }
    std::unique_ptr<Rod> rod;
    try {
        rod = std::make_unique<Rod>(spec);
    } catch (const std::invalid_argument&) {
        EXPECT_TRUE(kind == 1 || kind == 2) << seed;
        ++outcome.refused;
        return;
    }
    RodState state = rod->make_state();
    RodScratch scratch = rod->make_scratch();
    RodInputs inputs;
    inputs.gravity = g.direction() * (g.integer(0, 1) == 0 ? 9.81 : g.log_uniform(1e-3, 1e3));
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    if (kind >= 3 && kind <= 5) {
        RodLoad load;
        load.s = g.uniform(0, spec.length);
        load.force = g.direction() * g.log_uniform(1e-3, 1e3);  // to 1 kN
        load.moment = g.direction() * g.log_uniform(1e-6, 1);
        inputs.loads.push_back(load);
    }
    const bool grasped = kind >= 5;
    const int turns = kind == 6 ? 10 : 0;
    if (grasped) {
        for (int k = g.integer(1, 2); k > 0; --k) {
            RodGrasp grasp;
            grasp.s = g.uniform(0, spec.length);
            grasp.offset = spec.outer_radius * g.direction();
            grasp.target = rod->wall_point(state, grasp.s, grasp.offset);
            grasp.hold_rotation = turns > 0 || g.integer(0, 1) == 1;
            grasp.target_rotation = rod->frame_at(state, grasp.s).frame.rotation;
            inputs.grasps.push_back(grasp);
        }
        if (kind == 7)
            inputs.grasps[0].target += g.direction() * g.log_uniform(1e-3, 1);  // a tool moved by 1 m
    }
    if (g.integer(0, 2) == 0) {
        for (int i = 0; i < 10; ++i) {
            RodContact contact;
            contact.s = spec.length * (i + 0.5) / 10;
            contact.radius = spec.outer_radius;
            contact.point = Vector3(0, 0, -1.5 * spec.outer_radius);
            contact.friction = 0.3;
            inputs.contacts.push_back(contact);
        }
    }
    const double dt = g.log_uniform(5e-5, 0.05);
    // A rod without support has no equilibrium.
    const bool dynamic =
        g.integer(0, 3) != 0 || (spec.ends[0] == RodEnd::free && spec.ends[1] == RodEnd::free);
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                          1e300};
    RodSolve solve;
    if (!dynamic) solve.iterations = 40;
    if (seed % 8 == 1) {
        solve.level = RodSolve::Level::linearised;
        solve.iterations = 1;
    } else if (seed % 8 == 3) {
        solve.level = RodSolve::Level::newton_k;
        solve.iterations = 8;
    }
    const int steps = turns > 0 ? 20 : 4;
    for (int i = 0; i < steps; ++i) {
        if (turns > 0) {
            const double by = 2 * pi * turns / steps;
            const Matrix3 now = inputs.grasps[0].target_rotation;
            const Vector3 d1 = now.col(0) * std::cos(by) + now.col(1) * std::sin(by);
            inputs.grasps[0].target_rotation.col(0) = d1;
            inputs.grasps[0].target_rotation.col(1) = now.col(2).cross(d1);
        }
        bool poisoned = false;
        if (kind == 8 && i == 2) {
            inputs.grasps[0].target[g.integer(0, 2)] = bad[g.integer(0, 2)];
            poisoned = true;
        }
        if (kind == 9 && i == 1) {
            // Two coincident nodes: the direction is undefined.
            const auto at = static_cast<std::size_t>(g.integer(0, spec.segments - 1));
            state.nodes[at + 1] = state.nodes[at];
        }
        const RodReport report = dynamic ? rod->step(state, inputs, dt, scratch, solve)
                                         : rod->solve(state, inputs, scratch, solve);
        ASSERT_TRUE(Rod::finite(state)) << "case " << seed << " step " << i;
        ASSERT_TRUE(finite_report(report)) << "case " << seed << " step " << i;
        if (!report.finite) {
            ASSERT_EQ(report.fault, RodFault::frozen) << "case " << seed << " step " << i;
        }
        if (poisoned && !std::isfinite(inputs.grasps[0].target.sum())) {
            ASSERT_FALSE(report.finite) << "case " << seed;
        }
        for (const RodGrasp& grasp : inputs.grasps) {
            ASSERT_TRUE(std::isfinite(grasp.reaction.sum() + grasp.moment.sum()))
                << "case " << seed << " step " << i;
        }
        for (const RodContact& contact : inputs.contacts) {
            ASSERT_TRUE(std::isfinite(contact.lambda) && contact.lambda >= 0)
                << "case " << seed << " step " << i;
        }
        // The report must be consistent: solved to its residual, or not solved and by how much, or given up.
        if (report.fault == RodFault::frozen) {
            ++outcome.fault;
            EXPECT_FALSE(report.converged);
        } else if (report.converged) {
            ++outcome.converged;
        } else {
            // Stiff, fine rods are limited by rounding: small and stated.
            ++(report.residual < 1e-3 ? outcome.small : outcome.degraded);
            EXPECT_TRUE(report.residual > 0 || report.constraint_residual > 0 || !report.positive_definite)
                << seed;
        }
    }
}

TEST(RodExtremes, StepsStayFiniteAndReportFaults) {
    const int cases = test::cases_asked(60);
    Outcome outcome;
    for (int i = 0; i < cases && !HasFatalFailure(); ++i) run(static_cast<std::uint64_t>(i), outcome);
    std::printf(
        "%d cases: %d steps solved, %d to a small stated residual, %d to a larger one, %d given up, %d "
        "specifications refused\n",
        cases, outcome.converged, outcome.small, outcome.degraded, outcome.fault, outcome.refused);
    EXPECT_GT(outcome.converged, outcome.degraded);
    EXPECT_GT(outcome.fault, 0) << "the cases must include faults";
}

}  // namespace
}  // namespace fulcrum
