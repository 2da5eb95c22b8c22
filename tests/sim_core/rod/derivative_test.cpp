// SPDX-License-Identifier: Apache-2.0
// Gradient and matrix of the rod's merit function compared with finite differences along the retraction, in a
// bent, twisted, stretched shape with natural curvature, tethers, a grasp with a lever arm, contacts and a
// self-contact.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

struct Fixture {
    Fixture(bool curved, bool constrained, MaterialLaw law)
        : rod(make_spec(curved, law)), scratch(rod.make_scratch()), state(rod.make_state()) {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> uniform(-1, 1);
        // EXP2 grows so fast that differences over large strains are meaningless.
        const double amplitude = law == MaterialLaw::exp2 ? 0.002 : 0.006;
        for (auto& node : state.nodes)
            node += amplitude * Vector3(uniform(random), uniform(random), uniform(random));
        for (std::size_t j = 0; j < state.directors.size(); ++j) {
            const Vector3 t = (state.nodes[j + 1] - state.nodes[j]).normalized();
            Vector3 d(uniform(random), uniform(random), uniform(random));
            state.directors[j] = (d - t * t.dot(d)).normalized();
        }
        inputs.ends[0] = state.ends[0];
        inputs.ends[1] = state.ends[1];
        if (constrained) {
            RodTether tether;
            tether.s = 0.055;
            tether.offset = Vector3(0.01, 0.012, 0.002);
            tether.anchor = Vector3(0.02, -0.05, 0.03);
            tether.stiffness = 40;
            tether.rest_length = 0.03;
            inputs.tethers = {tether};
            RodGrasp grasp;
            grasp.s = 0.081;
            grasp.offset = Vector3(-0.012, 0.009, 0.001);
            grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
            grasp.reaction = Vector3(0.3, -0.2, 0.4);
            grasp.hold_rotation = true;
            grasp.target_rotation = rod.frame_at(state, grasp.s).frame.rotation;
            grasp.moment = Vector3(0.004, -0.003, 0.002);
            inputs.grasps = {grasp};
            RodContact contact;
            contact.s = 0.035;
            contact.normal = Vector3(0.2, 0.3, 1).normalized();
            contact.point = Vector3(0, 0, 0);
            contact.radius = 0.02;
            contact.lambda = 0.2;
            inputs.contacts = {contact};
        }
        data().contact_points.resize(4);
        shape_from_state(rod.tables(), rod.spec(), state, inputs.ends, data().shape);
        RodScratch::Data& d = data();
        // The directors were set at random: compute the joints' twist from them.
        EXPECT_TRUE(retract(rod.tables(), d.shape, d.step.data(), 1.0, d.trial));
        std::swap(d.shape, d.trial);
        d.grasp_target[0] = inputs.grasps.empty() ? Vector3::Zero() : inputs.grasps[0].target;
        if (constrained) {
            d.tether_points[0] = locate(rod.tables(), inputs.tethers[0].s);
            d.grasp_points[0] = locate(rod.tables(), inputs.grasps[0].s);
            d.grasp_lambda[0] = -inputs.grasps[0].reaction;
            d.turn_lambda[0] = -inputs.grasps[0].moment;
            // The target is the orientation of the blended directors: there the penalty's contribution to the
            // matrix is exact.
            Matrix3 now;
            RodPoint turning = d.grasp_points[0];
            turning.node_weight[0] = turning.node_weight[1] = turning.node_weight[2] = 0;
            for (int k = 0; k < 3; ++k) now.col(k) = wall_position(d.shape, turning, Vector3::Unit(k));
            Matrix3 target = now;
            for (int i = 0; i < 100; ++i) target = 0.5 * (target + target.inverse().transpose()).eval();
            d.turn_target[0] = target;
            d.contact_points[0] = locate(rod.tables(), inputs.contacts[0].s);
            d.contact_lambda[0] = inputs.contacts[0].lambda;
        }
    }
    static RodSpec make_spec(bool curved, MaterialLaw law) {
        RodSpec spec;
        spec.law = law;
        spec.segments = 9;
        spec.length = 0.12;
        spec.ends[0] = RodEnd::clamped;
        spec.ends[1] = RodEnd::held;
        if (curved) {
            spec.intrinsic_curvature[0] = 12;
            spec.intrinsic_curvature[1] = -7;
            spec.intrinsic_curvature[2] = 9;
        }
        return spec;
    }
    RodScratch::Data& data() { return scratch.data(); }
    double merit(const std::vector<double>& step) {
        EXPECT_TRUE(retract(rod.tables(), data().shape, step.data(), 1.0, data().trial));
        EXPECT_TRUE(evaluate(rod.tables(), data().trial, inputs, false, data()));
        return data().energy;
    }
    Rod rod;
    RodScratch scratch;
    RodState state;
    RodInputs inputs;
};

void check(bool curved, bool constrained, MaterialLaw law = MaterialLaw::linear,
           double most = std::numeric_limits<double>::quiet_NaN()) {
    Fixture f(curved, constrained, law);
    RodScratch::Data& d = f.data();
    if (!std::isnan(most)) {  // a spring, stretched by 5 mm
        f.inputs.grasps[0].stiffness = 700;
        f.inputs.grasps[0].most = most;
        d.grasp_target[0] += Vector3(0.003, -0.004, 0);
    }
    const std::size_t entries = d.gradient.size();
    ASSERT_TRUE(evaluate(f.rod.tables(), d.shape, f.inputs, true, d));
    const std::vector<double> gradient = d.gradient;
    BlockBand matrix = d.matrix;
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> uniform(-1, 1);
    // Each unknown alone, then mixed directions: fourth-order differences of the merit.
    for (std::size_t trial = 0; trial < entries + 60; ++trial) {
        std::vector<double> direction(entries, 0.0), curvature(entries);
        for (std::size_t k = 0; k < entries; ++k) {
            if (k % 4 == 3 && k / 4 + 1 == entries / 4) continue;
            const double size = k % 4 == 3 ? 0.3 : 0.002;
            direction[k] = trial < entries ? (k == trial ? size : 0.0) : size * uniform(random);
        }
        const double h = constrained || law == MaterialLaw::exp2 ? 2e-3 : 1e-2;
        const auto at = [&](double x) {
            std::vector<double> step(entries);
            for (std::size_t k = 0; k < entries; ++k) step[k] = x * direction[k];
            return f.merit(step);
        };
        const double e0 = at(0), p1 = at(h), m1 = at(-h), p2 = at(2 * h), m2 = at(-2 * h);
        const double slope = (8 * (p1 - m1) - (p2 - m2)) / (12 * h);
        const double bend = (16 * (p1 + m1) - (p2 + m2) - 30 * e0) / (12 * h * h);
        double expected_slope = 0, expected_bend = 0;
        multiply(matrix, direction.data(), curvature.data());
        for (std::size_t k = 0; k < entries; ++k) {
            expected_slope += gradient[k] * direction[k];
            expected_bend += curvature[k] * direction[k];
        }
        if (trial + 1 == entries) continue;
        const double scale = std::fabs(e0) + std::fabs(bend);
        EXPECT_NEAR(slope, expected_slope, 1e-7 * scale) << trial;
        EXPECT_NEAR(bend, expected_bend, 3e-6 * scale)
            << trial << " block " << trial / 4 << " entry " << trial % 4;
    }
}

TEST(RodDerivatives, StraightRestShape) {
    check(false, false);
}
TEST(RodDerivatives, NaturalCurvatureAndTwist) {
    check(true, false);
}
TEST(RodDerivatives, TethersGraspsAndContacts) {
    check(true, true);
}
TEST(RodDerivatives, GraspThatYieldsAndOneThatSlides) {
    check(true, true, MaterialLaw::linear, 100);
    check(true, true, MaterialLaw::linear, 1.5);
}
TEST(RodDerivatives, Exp2) {
    check(false, false, MaterialLaw::exp2);
    check(true, false, MaterialLaw::exp2);
    check(true, true, MaterialLaw::exp2);
}

}  // namespace
}  // namespace fulcrum
