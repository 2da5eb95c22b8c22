// SPDX-License-Identifier: Apache-2.0
// Coherent lists compared with brute force, planes, projection, self-collision, and the real-time rules of
// the loop.
#include "sim_core/collision/sphere_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"
#include "tests/support/allocation_count.h"
#include "tests/support/cavity.h"

namespace fulcrum {
namespace {

const Vector3 half_axes(0.06, 0.055, 0.05);

SphereChainShape chain(int count, double spacing, double radius) {
    SphereChainShape shape;
    for (int i = 0; i < count; ++i) {
        shape.arc_lengths.push_back(i * spacing);
        shape.radii.push_back(radius * (1 + 0.1 * std::sin(0.7 * i)));
    }
    return shape;
}

TEST(SphereCollision, DepthsStayExactWhileSpheresMove) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.06), FreeSide::behind);
    const SphereChainShape shape = chain(100, 0.009, 0.016);
    const SphereCollision collision(&cavity, shape);
    SphereCollision::Lists lists = collision.make_lists();
    std::vector<SphereDepth> results(100);
    int relisted = 0, touching = 0;
    for (int step = 0; step < 80; ++step) {
        const std::vector<Vector3> centres = test::coiled_centres(100, 0.009, 0.0004 * step);
        const int again = collision.depths(centres.data(), lists, results.data());
        if (step > 0) relisted += again;
        if (step % 7 != 0) continue;
        for (int i = 0; i < 100; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const CavityPoint exact = cavity.closest(centres[k], 1.0);
            const double reach = shape.radii[k] + collision.options().contact_margin;
            if (exact.distance < reach) {
                ++touching;
                ASSERT_GE(results[k].closest.triangle, 0);
                EXPECT_NEAR(results[k].closest.distance, exact.distance, 1e-13);
                EXPECT_NEAR(results[k].depth, shape.radii[k] - exact.distance, 1e-13);
            } else {
                EXPECT_EQ(results[k].closest.triangle, -1);
            }
        }
    }
    EXPECT_GT(touching, 200);
    EXPECT_LT(relisted, 79 * 100 / 4);  // coherence: most steps list nothing again
}

TEST(SphereCollision, ResultDoesNotDependOnTheHistoryOfTheLists) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.06), FreeSide::behind);
    const SphereCollision collision(&cavity, chain(60, 0.012, 0.017));
    SphereCollision::Lists old_lists = collision.make_lists();
    SphereContacts old_contacts = collision.make_contacts();
    for (int step = 0; step < 30; ++step) {
        const std::vector<Vector3> centres = test::coiled_centres(60, 0.012, 0.0003 * step);
        collision.collide(centres.data(), old_lists, old_contacts);
        SphereCollision::Lists fresh_lists = collision.make_lists();
        SphereContacts fresh = collision.make_contacts();
        collision.collide(centres.data(), fresh_lists, fresh);
        ASSERT_EQ(old_contacts.cavity_count, fresh.cavity_count);
        ASSERT_EQ(old_contacts.pair_count, fresh.pair_count);
        EXPECT_EQ(old_contacts.residual_cavity, fresh.residual_cavity);
        for (int c = 0; c < fresh.cavity_count; ++c) {
            const CavityContact& a = old_contacts.cavity[static_cast<std::size_t>(c)];
            const CavityContact& b = fresh.cavity[static_cast<std::size_t>(c)];
            EXPECT_EQ(a.sphere, b.sphere);
            EXPECT_EQ(a.triangle, b.triangle);
            EXPECT_EQ(a.gap, b.gap);
            EXPECT_EQ(a.normal, b.normal);
        }
    }
}

TEST(SphereCollision, SphereInACornerHasOnePlanePerWall) {
    // Three walls of a box corner, the free side along the diagonal.
    TriangleMesh corner;
    corner.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    corner.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
    const CavityModel cavity(corner, FreeSide::front);
    const SphereCollision collision(&cavity, {{0.0}, {0.02}});
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    const Vector3 centre(0.019, 0.0195, 0.0185);
    collision.collide(&centre, lists, contacts);
    ASSERT_EQ(contacts.cavity_count, 3);
    EXPECT_NEAR(contacts.deepest_cavity, 0.0015, 1e-12);
    for (int c = 0; c < 3; ++c) {
        const CavityContact& contact = contacts.cavity[static_cast<std::size_t>(c)];
        EXPECT_NEAR(contact.normal.maxCoeff(), 1.0, 1e-12);
        EXPECT_NEAR(contact.gap, contact.normal.dot(centre) - 0.02, 1e-12);
    }
    EXPECT_LT(contacts.residual_cavity, 1e-9);
    EXPECT_NEAR((lists.projected[0] - Vector3::Constant(0.02)).norm(), 0.0, 1e-9);
}

TEST(SphereCollision, FloorGivesExactlyOnePlane) {
    const CavityModel cavity(test::make_floor(0.3, 30), FreeSide::front);
    const SphereCollision collision(&cavity, {{0.0}, {0.016}});
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    Random random(11);
    for (int trial = 0; trial < 300; ++trial) {
        // Some trials are exactly over vertices and edges.
        const bool on_grid = trial % 3 == 0;
        const double x = on_grid ? 0.01 * (trial % 11 - 5) : random.uniform(-0.1, 0.1);
        const Vector3 centre(x, random.uniform(-0.1, 0.1), random.uniform(0.008, 0.0164));
        collision.collide(&centre, lists, contacts);
        ASSERT_EQ(contacts.cavity_count, 1) << trial;
        EXPECT_NEAR(contacts.cavity[0].normal.z(), 1.0, 1e-12);
        EXPECT_NEAR(contacts.cavity[0].gap, centre.z() - 0.016, 1e-12);
    }
}

TEST(SphereCollision, SphereBehindTheWallFindsTheExit) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.0), FreeSide::behind);
    const SphereCollision collision(&cavity, {{0.0}, {0.01}});
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    for (const double z : {-0.02, -0.049, -0.055, -0.08, -0.5}) {
        const Vector3 centre(0, 0, z);
        collision.collide(&centre, lists, contacts);
        if (z > -0.03) {
            EXPECT_EQ(contacts.cavity_count, 0);
            continue;
        }
        EXPECT_NEAR(contacts.deepest_cavity, 0.01 - (0.05 + z), 2e-4) << z;
        EXPECT_LT(contacts.residual_cavity, 1e-4) << z;
        EXPECT_GT(lists.projected[0].z(), -0.0401);
    }
}

TEST(SphereCollision, SelfCollisionAgreesWithBruteForce) {
    SphereCollisionOptions options;
    options.projection_iterations = 0;
    options.pair_capacity = 2000;
    const SphereChainShape shape = chain(150, 0.006, 0.015);
    const SphereCollision collision(nullptr, shape, options);
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    for (int step = 0; step < 40; ++step) {
        const std::vector<Vector3> centres = test::coiled_centres(150, 0.006, 0.0005 * step);
        collision.collide(centres.data(), lists, contacts);
        int expected = 0;
        double deepest = 0;
        for (std::size_t i = 0; i < 150; ++i) {
            for (std::size_t j = i + 1; j < 150; ++j) {
                const double along = shape.arc_lengths[j] - shape.arc_lengths[i];
                if (along < 3.141592653589793 * std::max(shape.radii[i], shape.radii[j])) continue;
                const double overlap = shape.radii[i] + shape.radii[j] - (centres[i] - centres[j]).norm();
                if (overlap > -options.contact_margin) ++expected;
                deepest = std::max(deepest, overlap);
            }
        }
        ASSERT_EQ(contacts.pair_count, expected);
        EXPECT_FALSE(contacts.pair_overflow);
        EXPECT_NEAR(contacts.deepest_pair, deepest, 1e-14);
    }
    EXPECT_GT(contacts.pair_count, 0);
}

TEST(SphereCollision, BendIsNotASelfCollision) {
    // A tube bent to its tightest radius, 180 degrees: neighbours along the line are excluded.
    const double radius = 0.015, spacing = 0.005;
    std::vector<Vector3> centres;
    SphereChainShape shape;
    for (int i = 0; i * spacing < 3.14159 * radius; ++i) {
        const double angle = i * spacing / radius;
        centres.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        shape.arc_lengths.push_back(i * spacing);
        shape.radii.push_back(radius);
    }
    const SphereCollision collision(nullptr, shape);
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    collision.collide(centres.data(), lists, contacts);
    EXPECT_EQ(contacts.pair_count, 0);
}

TEST(SphereCollision, ProjectionSeparatesTwoSpheresByHalves) {
    const SphereCollision collision(nullptr, {{0.0, 1.0}, {0.02, 0.01}});
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    const Vector3 centres[2] = {Vector3(0.01, 0, 0), Vector3(-0.01, 0, 0)};
    collision.collide(centres, lists, contacts);
    ASSERT_EQ(contacts.pair_count, 1);
    EXPECT_NEAR(contacts.pairs[0].gap, -0.01, 1e-15);
    EXPECT_NEAR(contacts.pairs[0].normal.x(), 1.0, 1e-15);
    EXPECT_NEAR(lists.projected[0].x(), 0.015, 1e-15);
    EXPECT_NEAR(lists.projected[1].x(), -0.015, 1e-15);
    EXPECT_LT(contacts.residual_pair, 1e-12);
}

TEST(SphereCollision, OverflowIsFlaggedAndTheClosestPointStaysExact) {
    // At the centre of a ball all triangles are equally near.
    const CavityModel cavity(test::make_bowl(Vector3::Constant(0.0155), 20, 30, 0.0), FreeSide::behind);
    SphereCollisionOptions options;
    options.list_capacity = 4;
    const SphereCollision collision(&cavity, {{0.0}, {0.016}}, options);
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    const Vector3 centre(0.0001, 0.0002, -0.0001);
    collision.collide(&centre, lists, contacts);
    EXPECT_TRUE(contacts.list_overflow);
    ASSERT_GE(contacts.cavity_count, 1);
    EXPECT_NEAR(contacts.deepest_cavity, 0.016 - cavity.closest(centre, 1.0).distance, 1e-15);
    EXPECT_NEAR(contacts.cavity[0].gap, cavity.closest(centre, 1.0).distance - 0.016, 1e-15);
}

TEST(SphereCollision, SmallListCapacityRelistsMoreOftenAndStaysExact) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.06), FreeSide::behind);
    int relisted[2] = {0, 0};
    for (int small = 0; small < 2; ++small) {
        SphereCollisionOptions options;
        if (small == 1) options.list_capacity = 6;
        const SphereChainShape shape = chain(100, 0.009, 0.016);
        const SphereCollision collision(&cavity, shape, options);
        SphereCollision::Lists lists = collision.make_lists();
        std::vector<SphereDepth> results(100);
        for (int step = 0; step < 40; ++step) {
            const std::vector<Vector3> centres = test::coiled_centres(100, 0.009, 0.0004 * step);
            relisted[small] += collision.depths(centres.data(), lists, results.data());
            for (std::size_t i = 0; i < 100; ++i) {
                const CavityPoint exact = cavity.closest(centres[i], 1.0);
                if (exact.distance >= shape.radii[i] + options.contact_margin) continue;
                EXPECT_NEAR(results[i].closest.distance, exact.distance, 1e-15) << i;
            }
        }
    }
    EXPECT_GT(relisted[1], relisted[0]);
}

TEST(SphereCollision, NoStepRelistsTheWholeChain) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.06), FreeSide::behind);
    const SphereCollision collision(&cavity, chain(100, 0.009, 0.016));
    SphereCollision::Lists lists = collision.make_lists();
    std::vector<SphereDepth> results(100);
    for (int step = 0; step < 60; ++step) {
        const std::vector<Vector3> centres = test::coiled_centres(100, 0.009, 0.00025 * step);
        const int relisted = collision.depths(centres.data(), lists, results.data());
        if (step > 0) {
            EXPECT_LE(relisted, 25) << step;
        }
    }
}

TEST(SphereCollision, OutputIsAlwaysFinite) {
    const CavityModel cavity(test::make_bowl(half_axes, 20, 30, 0.0), FreeSide::behind);
    const SphereCollision collision(&cavity, chain(4, 0.2, 0.01));
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    const Vector3 centres[4] = {Vector3(nan, 0, 0), Vector3(0, infinite, 0), Vector3(0, 0, -0.049),
                                Vector3(0, 0, -0.049)};
    collision.collide(centres, lists, contacts);
    EXPECT_EQ(contacts.pair_count, 1);  // the two at one place
    ASSERT_GE(contacts.cavity_count, 2);
    for (int c = 0; c < contacts.cavity_count; ++c) {
        EXPECT_TRUE(contacts.cavity[static_cast<std::size_t>(c)].normal.allFinite());
        EXPECT_TRUE(std::isfinite(contacts.cavity[static_cast<std::size_t>(c)].gap));
    }
    EXPECT_TRUE(lists.projected[2].allFinite());
    EXPECT_TRUE(lists.projected[3].allFinite());
}

TEST(SphereCollision, InvalidChainsAreRefused) {
    EXPECT_THROW(SphereCollision(nullptr, {{0.0, 1.0}, {0.01}}), InputError);
    EXPECT_THROW(SphereCollision(nullptr, {{0.0}, {0.0}}), InputError);
    EXPECT_THROW(SphereCollision(nullptr, {{0.0}, {std::numeric_limits<double>::quiet_NaN()}}), InputError);
}

TEST(SphereCollision, StepsDoNotAllocate) {
    const CavityModel cavity(test::make_bowl(half_axes, 40, 50, 0.06), FreeSide::behind);
    const SphereCollision collision(&cavity, chain(100, 0.009, 0.016));
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    std::vector<std::vector<Vector3>> steps;
    for (int step = 0; step < 20; ++step) steps.push_back(test::coiled_centres(100, 0.009, 0.001 * step));
    const std::uint64_t allocated = test::allocations_in([&] {
        for (const auto& centres : steps) collision.collide(centres.data(), lists, contacts);
    });
    EXPECT_EQ(allocated, 0U);
    EXPECT_GT(contacts.cavity_count, 0);
}

}  // namespace
}  // namespace fulcrum
