// SPDX-License-Identifier: Apache-2.0
// Rigid rings against closed forms: fall, slope, free turning, holds, pushes; and at the extremes.
#include "sim_core/rigid/capsule_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double gravity = 9.81, dt = 0.005;

struct Bench {
    BodyGround ground;
    std::vector<BodyState> bodies;
    BodyGrip grips[hand_count];
    BodyPusher pushers[hand_count];
    BodyShape shape = make_ring(6, 0.009, 0.0022, 0.003);
    std::unique_ptr<CapsuleBodies> solver;

    BodyState& add(const Vector3& position, const Quaternion& rotation = Quaternion::Identity()) {
        BodyState body;
        body.position = position;
        body.rotation = rotation;
        bodies.push_back(body);
        return bodies.back();
    }
    void run(double seconds) {
        if (!solver) solver = std::make_unique<CapsuleBodies>(shape, ground);
        for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i)
            solver->step(bodies, grips, pushers, hand_count, dt);
    }
    double energy(const BodyState& body) const {
        const Vector3 spin = body.rotation.conjugate() * body.spin;
        return 0.5 * shape.mass * body.velocity.squaredNorm() +
               0.5 * spin.dot(shape.inertia.cwiseProduct(spin)) -
               shape.mass * ground.gravity.dot(body.position);
    }
};

TEST(CapsuleBodies, FallAsAFreeBodyDoes) {
    Bench bench;
    bench.add(Vector3(0, 0, 1), Quaternion(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized())));
    bench.run(0.3);
    // The end of each substep is one substep's half ahead.
    const double fallen = 1 - bench.bodies[0].position.z();
    EXPECT_NEAR(fallen, 0.5 * gravity * 0.3 * (0.3 + CapsuleBodies::substep), 1e-9);
    EXPECT_NEAR(bench.bodies[0].velocity.z(), -gravity * 0.3, 1e-9);
    EXPECT_LT(bench.bodies[0].spin.norm(), 1e-12);
}

TEST(CapsuleBodies, StayOnASlopeWithinTheConeOfFrictionAndSlideBeyondItAsCoulombSays) {
    for (const double degrees : {5.0, 15.0, 20.0, 25.0, 30.0, 45.0}) {
        Bench bench;
        const double angle = degrees * 3.14159265358979 / 180;
        bench.ground.gravity = gravity * Vector3(std::sin(angle), 0, -std::cos(angle));
        bench.ground.friction = 0.4;
        bench.add(Vector3(0, 0, bench.shape.radius));
        bench.run(0.1);
        const double from = bench.bodies[0].position.x(), speed = bench.bodies[0].velocity.x();
        bench.run(0.5);
        const double slides = gravity * (std::sin(angle) - 0.4 * std::cos(angle));
        if (slides < 0) {
            EXPECT_LT(std::abs(bench.bodies[0].position.x() - from), 2e-5) << degrees;
            EXPECT_LT(bench.bodies[0].velocity.norm(), 1e-4) << degrees;
        } else {
            EXPECT_NEAR((bench.bodies[0].velocity.x() - speed) / 0.5, slides, 0.02 * slides) << degrees;
        }
        EXPECT_NEAR(bench.solver->height(bench.bodies[0]), 0, 1e-4) << degrees;
    }
}

TEST(CapsuleBodies, TurnFreelyWithoutLosingAngularMomentumOrGainingEnergy) {
    Bench bench;
    bench.ground.gravity.setZero();
    bench.ground.spin_damping = 0;
    BodyState& body = bench.add(Vector3(0, 0, 1));
    body.spin = Vector3(3, 1, 20);
    const Vector3 momentum = bench.shape.inertia.cwiseProduct(body.spin);
    const double energy = bench.energy(body);
    bench.run(1);
    const Vector3 spin = body.rotation.conjugate() * body.spin;
    const Vector3 after = body.rotation * Vector3(bench.shape.inertia.cwiseProduct(spin));
    EXPECT_LT((after - momentum).norm(), 0.02 * momentum.norm());
    EXPECT_LE(bench.energy(body), energy * (1 + 1e-9));
    EXPECT_GT(bench.energy(body), 0.97 * energy);
}

TEST(CapsuleBodies, HaveTheInertiaOfTheirTubes) {
    // Points drawn evenly in the tubes and in the balls at the corners.
    const BodyShape ring = make_ring(6, 0.009, 0.0022, 0.003);
    Random random(7);
    Vector3 sum = Vector3::Zero();
    double count = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        const Capsule capsule = {ring.corners[k], ring.corners[(k + 1) % 6], 0.0022};
        const Vector3 along = capsule.to - capsule.from, axis = along.normalized();
        for (int i = 0; i < 40000; ++i) {
            const Vector3 offset =
                0.0022 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            // In the cylinder: drawn in its box; in the ball: drawn in its cube. Equal densities.
            const double share = random.uniform(-0.0022 / along.norm(), 1 + 0.0022 / along.norm());
            for (int part = 0; part < 2; ++part) {
                Vector3 point;
                if (part == 0) {
                    if (share < 0 || share > 1) continue;
                    const Vector3 side = axis.unitOrthogonal(), other = axis.cross(side);
                    if (offset.x() * offset.x() + offset.y() * offset.y() > 0.0022 * 0.0022) continue;
                    point = capsule.from + share * along + offset.x() * side + offset.y() * other;
                } else {
                    // The cube's volume over that of the longer box.
                    if (random.uniform() > 0.0044 / (along.norm() + 0.0044)) continue;
                    if (offset.norm() > 0.0022) continue;
                    point = capsule.from + offset;
                }
                sum += Vector3(point.y() * point.y() + point.z() * point.z(),
                               point.x() * point.x() + point.z() * point.z(),
                               point.x() * point.x() + point.y() * point.y());
                ++count;
            }
        }
    }
    const Vector3 measured = 0.003 * sum / count;
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(ring.inertia[axis], measured[axis], 0.01 * measured[axis]) << axis;
}

TEST(CapsuleBodies, SagInAHoldByTheirWeightOverItsStiffness) {
    Bench bench;
    BodyState& body = bench.add(Vector3(0, 0, 0.1));
    BodyGrip& grip = bench.grips[0];
    grip.body = 0;
    grip.count = 3;
    grip.stiffness = 200;
    grip.damping = 0.5;
    const Vector3 at[3] = {Vector3(0.003, 0, 0), Vector3(-0.0015, 0.0026, 0), Vector3(-0.0015, -0.0026, 0)};
    for (std::size_t i = 0; i < 3; ++i) {
        grip.at[i] = at[i];
        grip.last[i] = grip.target[i] = body.position + at[i];
    }
    bench.run(1);
    EXPECT_NEAR(0.1 - bench.bodies[0].position.z(), 0.003 * gravity / 600, 1e-9);
    EXPECT_NEAR(bench.grips[0].force.z(), 0.003 * gravity, 1e-7);
    EXPECT_LT(bench.grips[0].force.head<2>().norm(), 1e-7);
}

TEST(CapsuleBodies, AreStableInHoldsOfAnyStiffness) {
    for (const double stiffness : {1.0, 1e3, 1e5, 1e7}) {
        Bench bench;
        BodyState& body = bench.add(Vector3(0, 0, 0.1));
        BodyGrip& grip = bench.grips[0];
        grip.body = 0;
        grip.count = 1;
        grip.stiffness = stiffness;
        grip.at[0] = Vector3(0.009, 0, 0);
        grip.last[0] = grip.target[0] = body.position + grip.at[0];
        bench.run(5);
        EXPECT_TRUE(bench.bodies[0].position.allFinite()) << stiffness;
        EXPECT_LT((point_of(bench.bodies[0], grip.at[0]) - grip.target[0]).norm(),
                  2.01 * 0.003 * gravity / stiffness + 1e-4)
            << stiffness;
    }
}

// The other hand, much stronger, takes the body along within one step.
TEST(CapsuleBodies, AreHeldByNoMoreThanTheJawsHold) {
    Bench bench;
    const BodyState body = bench.add(Vector3(0, 0, 0.1));
    for (int hand = 0; hand < hand_count; ++hand) {
        BodyGrip& grip = bench.grips[hand];
        grip.body = 0;
        grip.count = 1;
        grip.stiffness = 800;
        grip.damping = 0.5;
        grip.at[0] = Vector3(hand == 0 ? -0.009 : 0.009, 0, 0);
        grip.last[0] = grip.target[0] = body.position + grip.at[0];
    }
    bench.grips[0].most = 1.5;
    bench.grips[1].most = 40;
    double largest = 0;
    for (int step = 0; step < 20; ++step) {
        bench.grips[1].last[0] = bench.grips[1].target[0];
        bench.grips[1].target[0] += Vector3(0.002, 0, 0);
        bench.run(dt);
        largest = std::max(largest, bench.grips[0].force.norm());
        EXPECT_LE(bench.grips[0].force.norm(), 1.5 + 1e-9) << step;
    }
    EXPECT_GT(largest, 1.499) << "it was pulled to what it holds";
    EXPECT_GT(bench.bodies[0].position.x(), 0.03) << "and the body went with the stronger hand";
}

TEST(CapsuleBodies, PinnedByAnInstrumentPushBackAsItsSpring) {
    Bench bench;
    bench.add(Vector3(0, 0, bench.shape.radius));
    BodyPusher& pusher = bench.pushers[1];
    pusher.present = true;
    pusher.stiffness = 600;
    pusher.damping = 0.5;
    // Across two opposite tubes, 1 mm deep in both.
    const double z = 2 * bench.shape.radius + 0.0025 - 0.001;
    pusher.before = pusher.after = {Vector3(-0.03, 0, z), Vector3(0.03, 0, z), 0.0025};
    bench.run(1);
    EXPECT_NEAR(bench.pushers[1].force.z(), -2 * 600 * 0.001, 0.1) << "two corners, a millimetre each";
    EXPECT_NEAR(bench.pushers[1].place(), 0.5, 0.02);
    EXPECT_LT(std::abs(bench.bodies[0].position.z() - bench.shape.radius), 2e-4);
    // Moved along itself, it touches nearer to its begin.
    pusher.before = pusher.after = {Vector3(-0.02, 0, z), Vector3(0.04, 0, z), 0.0025};
    bench.run(1);
    EXPECT_NEAR(bench.pushers[1].place(), 1.0 / 3, 0.02);
    // A force that it no longer has is at its end.
    pusher.present = false;
    bench.run(dt);
    EXPECT_EQ(bench.pushers[1].place(), 1);
}

TEST(CapsuleBodies, ArePushedByAnInstrumentThatMovesAndComeToRestBehindIt) {
    Bench bench;
    bench.add(Vector3(0, 0, bench.shape.radius));
    BodyPusher& pusher = bench.pushers[0];
    pusher.present = true;
    for (int i = 0; i < 200; ++i) {
        const double x = -0.02 + 0.05 * dt * i;
        pusher.before = {Vector3(x, 0, 0.003), Vector3(x, 0, 0.05), 0.0025};
        pusher.after = {Vector3(x + 0.05 * dt, 0, 0.003), Vector3(x + 0.05 * dt, 0, 0.05), 0.0025};
        bench.run(dt);
    }
    EXPECT_GT(bench.bodies[0].position.x(), 0.03 + 0.0025) << "the instrument ended at 30 mm";
    pusher.before = pusher.after;
    bench.run(1);
    EXPECT_LT(bench.bodies[0].velocity.norm(), 1e-4);
}

TEST(CapsuleBodies, StayAroundAPost) {
    Bench bench;
    bench.ground.posts.push_back({Vector3::Zero(), Vector3(0, 0, 0.013), 0.0014});
    bench.ground.gravity = Vector3(9, 0, -9.81);  // a slope of 42 degrees
    bench.add(Vector3(0, 0, bench.shape.radius));
    bench.run(3);
    EXPECT_LT(bench.bodies[0].position.head<2>().norm(), 0.009);
    EXPECT_LT(bench.bodies[0].velocity.norm(), 0.002);
}

// Whatever they meet: thrown into each other, on posts, under instruments that move at random.
TEST(CapsuleBodies, StayFiniteAndComeToRestWhateverTheyMeet) {
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        Random random(seed);
        Bench bench;
        for (int i = 0; i < 6; ++i)
            bench.ground.posts.push_back({Vector3(0.03 * (i % 3), 0.03 * (i / 3), 0),
                                          Vector3(0.03 * (i % 3), 0.03 * (i / 3), 0.013), 0.0014});
        for (int i = 0; i < 6; ++i) {
            BodyState& body = bench.add(
                Vector3(random.uniform(0, 0.06), random.uniform(0, 0.03), random.uniform(0.005, 0.06)),
                Quaternion(random.normal(), random.normal(), random.normal(), random.normal()).normalized());
            body.velocity = Vector3(random.normal(), random.normal(), random.normal());
            body.spin = 30 * Vector3(random.normal(), random.normal(), random.normal());
        }
        Vector3 tip(0.03, 0.015, 0.01);
        for (int i = 0; i < 400; ++i) {
            const Vector3 next =
                Vector3(0.03, 0.015, 0.008) +
                0.02 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.5));
            BodyPusher& pusher = bench.pushers[0];
            pusher.present = i < 200;
            pusher.before = {tip, tip + Vector3(0.03, 0.03, 0.05), 0.0025};
            pusher.after = {next, next + Vector3(0.03, 0.03, 0.05), 0.0025};
            tip = next;
            bench.run(dt);
            for (const BodyState& body : bench.bodies) {
                ASSERT_TRUE(body.position.allFinite() && body.rotation.coeffs().allFinite()) << seed;
                ASSERT_LE(body.velocity.norm(), 5.01) << seed;
            }
        }
        bench.run(3);
        for (const BodyState& body : bench.bodies) {
            EXPECT_LT(body.velocity.norm(), 0.01) << seed;
            EXPECT_GT(bench.solver->height(body), -0.0005) << seed;
        }
    }
}

TEST(CapsuleBodies, GiveTheSameResultTwice) {
    const auto run = [] {
        Bench bench;
        bench.ground.posts.push_back({Vector3::Zero(), Vector3(0, 0, 0.013), 0.0014});
        for (int i = 0; i < 6; ++i)
            bench.add(Vector3(0.004 * i, 0.002 * i, 0.01 + 0.01 * i),
                      Quaternion(1, 0.1 * i, 0.2, 0).normalized());
        bench.run(1);
        return bench.bodies;
    };
    const std::vector<BodyState> one = run(), two = run();
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].position, two[i].position);
        EXPECT_EQ(one[i].rotation.coeffs(), two[i].rotation.coeffs());
    }
}

}  // namespace
}  // namespace fulcrum
