// SPDX-License-Identifier: Apache-2.0
// A strand compared with statics: tension at rest, a displaced node, weight on the posts; division; extremes.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/strand/strand.h"
#include "tests/support/allocation_count.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

constexpr double length = 0.026, strain = 0.15;

StrandModel band() {
    StrandModel model;
    model.rest_length = length / strand_segments / (1 + strain);
    model.gravity.setZero();
    return model;
}
StrandState stretched() {
    return make_strand_state(Vector3(0, 0, 0), Vector3(length, 0, 0));
}

void settle(const StrandModel& model, const StrandHold (&holds)[hand_count], StrandState& state,
            int steps = 2000) {
    for (int i = 0; i < steps; ++i) step_strand(model, holds, 0.005, state);
}

TEST(Strand, HasItsPreStrainAtRest) {
    const StrandModel model = band();
    StrandState state = stretched();
    const StrandHold none[hand_count];
    settle(model, none, state, 100);
    for (int s = 0; s < strand_segments; ++s)
        EXPECT_NEAR(strand_tension(model, state, s), model.stiffness * model.rest_length * strain, 1e-9);
}

TEST(Strand, DisplacedNodeIsHeldByTwoTensions) {
    // Node 6 held by a stiff spring 10 mm aside: 2 T h / l on the hand, T from each half's length.
    const StrandModel model = band();
    StrandState state = stretched();
    StrandHold holds[hand_count];
    holds[1] = {6, Vector3(length / 2, 0, 0.010), 1e6};
    settle(model, holds, state);
    const double half = std::hypot(length / 2, state.position[6].z());
    const double tension = model.stiffness * (half / 6 - model.rest_length);
    const Vector3 force = hold_force(holds[1], state);
    EXPECT_NEAR(force.z(), 2 * tension * state.position[6].z() / half, 1e-5);
    EXPECT_NEAR(force.x(), 0, 1e-5);
    for (int s = 0; s < strand_segments; ++s) EXPECT_NEAR(strand_tension(model, state, s), tension, 1e-6);
}

TEST(Strand, AHoldPullsAtMostItsFriction) {
    const StrandModel model = band();
    StrandState state = stretched();
    StrandHold holds[hand_count];
    holds[1] = {6, Vector3(length / 2, 0, 0.030), 800, 1.5};
    settle(model, holds, state);
    EXPECT_NEAR(hold_force(holds[1], state).norm(), 1.5, 1e-12);
    const double half = std::hypot(length / 2, state.position[6].z());
    const double tension = model.stiffness * (half / 6 - model.rest_length);
    EXPECT_NEAR(1.5, 2 * tension * state.position[6].z() / half, 1e-5) << "the strand answers with as much";
}

TEST(Strand, PostsCarryItsWeight) {
    StrandModel model = band();
    model.gravity = Vector3(0, 0, -9.81);
    model.damping = 200;
    StrandState state = stretched();
    const StrandHold none[hand_count];
    settle(model, none, state, 4000);
    const auto up = [&](int segment, int from, int to) {
        const Vector3 along =
            (state.position[static_cast<std::size_t>(to)] - state.position[static_cast<std::size_t>(from)])
                .normalized();
        return strand_tension(model, state, segment) * along.z();
    };
    const double weight = (strand_nodes - 2) * model.node_mass * 9.81;
    // A step's gravity is damped with the velocity, so the suspended weight is weight / (1 + damping dt).
    EXPECT_NEAR(-(up(0, 0, 1) + up(strand_segments - 1, strand_segments, strand_segments - 1)),
                weight / (1 + 200 * 0.005), 1e-6);
}

TEST(Strand, DividedEndsRecoilAndCarryNoForce) {
    const StrandModel model = band();
    StrandState state = stretched();
    const StrandHold none[hand_count];
    settle(model, none, state, 50);
    state.parted = 1U << 4U;
    settle(model, none, state);
    EXPECT_EQ(strand_tension(model, state, 4), 0.0);
    EXPECT_LE((state.position[4] - state.position[0]).norm(), 4 * model.rest_length + 1e-6);
    EXPECT_LT(state.position[4].x() + 0.002, state.position[5].x());
    double distance = 0;
    EXPECT_EQ(nearest_node(state, Vector3(length, 0.001, 0), distance), strand_segments);
    EXPECT_NEAR(distance, 0.001, 1e-12);
    EXPECT_EQ(strand_stiffness(model, state, 4), model.stiffness);
    EXPECT_EQ(strand_stiffness(model, state, 6), 2 * model.stiffness);
}

TEST(Strand, AllocatesNothing) {
    const StrandModel model = band();
    StrandState state = stretched();
    StrandHold holds[hand_count];
    holds[0] = {4, Vector3(0.01, 0.004, 0.003), 800};
    EXPECT_EQ(test::allocations_in([&] { settle(model, holds, state, 50); }), 0u);
}

TEST(StrandExtremes, StaysFiniteAndNeverGainsEnergy) {
    Random random(11);
    for (int trial = 0; trial < test::cases_asked() / 10; ++trial) {
        StrandModel model = band();
        model.stiffness = test::between(random, 1e-3, 1e7);
        model.node_mass = test::between(random, 1e-8, 1);
        model.damping = random.below(2) == 0 ? 0 : test::between(random, 1e-2, 1e4);
        StrandState state = stretched();
        StrandHold holds[hand_count];
        const double dt = test::between(random, 5e-5, 5e-2);
        for (int i = 0; i < 30; ++i) {
            for (StrandHold& hold : holds) {
                hold.node = static_cast<int>(random.below(strand_nodes + 2)) - 1;
                hold.stiffness = test::between(random, 1e-2, 1e5);
                hold.target = test::inside_unit_box(random);
                if (random.below(6) == 0) hold.target.x() = test::not_a_length(random);
                if (random.below(9) == 0) hold.stiffness = test::not_a_length(random);
            }
            if (random.below(5) == 0) state.parted |= 1U << random.below(strand_segments);
            step_strand(model, holds, dt, state);
            for (const Vector3& p : state.position)
                ASSERT_TRUE(p.allFinite() && p.norm() < 100) << trial << " " << p.transpose();
            for (const Vector3& v : state.velocity) ASSERT_TRUE(v.allFinite()) << trial;
        }
    }
}

}  // namespace
}  // namespace fulcrum
