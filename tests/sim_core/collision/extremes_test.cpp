// SPDX-License-Identifier: Apache-2.0
// The extremes of docs/QUALITY.md for collision, generated: walls without area, slivers, coincident spheres,
// a chain thrown by a metre, non-finite centres. Results are finite and agree with brute force (for walls
// with two sides), overflows are reported, and the history of the lists does not change the result.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "sim_core/collision/sphere_collision.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"
#include "tests/support/cavity.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

struct Outcome {
    int refused = 0, overflowed = 0, cavity = 0, pairs = 0, compared = 0;
};

// has_sides: closed and not folded, so that behind and in front are defined everywhere.
TriangleMesh extreme_wall(Random& random, double scale, bool& poisoned, bool& has_sides) {
    const auto kind = random.below(8);
    has_sides = random.below(2) == 0;
    TriangleMesh mesh =
        has_sides ? test::make_bowl(Vector3(0.06, 0.055, 0.05), static_cast<int>(4 + random.below(9)),
                                    static_cast<int>(4 + random.below(12)), 0.1)
                  : test::make_floor(0.2, static_cast<int>(1 + random.below(6)));
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    if (kind == 0) {  // coincident vertices, zero-length edges
        for (int i = 0; i < 4; ++i) mesh.vertices[random.below(count)] = mesh.vertices[0];
    } else if (kind == 1) {  // slivers of aspect 1e6
        for (Vector3& p : mesh.vertices) p.x() *= 1e-6;
    } else if (kind == 2) {  // a wall folded onto itself
        for (Vector3& p : mesh.vertices) p.z() = std::abs(p.z());
        has_sides = false;
    } else if (kind == 3) {  // no wall at all
        for (Vector3& p : mesh.vertices) p = Vector3(0.01, 0.02, 0.03);
    } else if (kind == 4 && random.below(2) == 0) {
        mesh.vertices[random.below(count)][static_cast<int>(random.below(3))] = test::not_a_length(random);
        poisoned = true;
    }
    for (Vector3& p : mesh.vertices) p *= scale;
    return mesh;
}

void check_finite(const SphereCollision& collision, const SphereCollision::Lists& lists,
                  const SphereContacts& contacts, const std::vector<Vector3>& centres) {
    const SphereCollisionOptions& options = collision.options();
    ASSERT_LE(contacts.cavity_count, collision.spheres() * options.planes_per_sphere);
    ASSERT_LE(contacts.pair_count, options.pair_capacity);
    for (const double value :
         {contacts.deepest_cavity, contacts.deepest_pair, contacts.residual_cavity, contacts.residual_pair}) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0) << value;
    }
    const auto sound = [&](std::int32_t sphere) {
        return sphere >= 0 && sphere < collision.spheres() &&
               centres[static_cast<std::size_t>(sphere)].allFinite();
    };
    for (int k = 0; k < contacts.cavity_count; ++k) {
        const CavityContact& contact = contacts.cavity[static_cast<std::size_t>(k)];
        ASSERT_TRUE(sound(contact.sphere));
        ASSERT_TRUE(contact.point.allFinite() && std::isfinite(contact.gap));
        ASSERT_NEAR(contact.normal.norm(), 1, 1e-9);
    }
    for (int k = 0; k < contacts.pair_count; ++k) {
        const SphereContact& contact = contacts.pairs[static_cast<std::size_t>(k)];
        ASSERT_TRUE(sound(contact.first) && sound(contact.second) && contact.first != contact.second);
        ASSERT_TRUE(std::isfinite(contact.gap));
        ASSERT_NEAR(contact.normal.norm(), 1, 1e-9);
    }
    for (std::size_t i = 0; i < centres.size(); ++i) {
        if (centres[i].allFinite()) {
            ASSERT_TRUE(lists.projected[i].allFinite()) << i;
        }
    }
}

// Deepest overlap of two spheres that may meet, by all pairs.
double deepest_pair(const SphereChainShape& chain, const SphereCollisionOptions& options,
                    const std::vector<Vector3>& centres) {
    double deepest = 0;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        for (std::size_t j = i + 1; j < centres.size(); ++j) {
            const double along = std::abs(chain.arc_lengths[i] - chain.arc_lengths[j]);
            if (along < options.rest_exclusion * std::max(chain.radii[i], chain.radii[j])) continue;
            if (!centres[i].allFinite() || !centres[j].allFinite()) continue;
            deepest = std::max(deepest, chain.radii[i] + chain.radii[j] - (centres[i] - centres[j]).norm());
        }
    }
    return deepest;
}

bool same(const SphereContacts& a, const SphereContacts& b) {
    bool equal = a.cavity_count == b.cavity_count && a.pair_count == b.pair_count &&
                 a.residual_cavity == b.residual_cavity && a.residual_pair == b.residual_pair;
    for (int k = 0; equal && k < a.cavity_count; ++k) {
        const auto n = static_cast<std::size_t>(k);
        equal = a.cavity[n].sphere == b.cavity[n].sphere && a.cavity[n].normal == b.cavity[n].normal &&
                a.cavity[n].gap == b.cavity[n].gap;
    }
    for (int k = 0; equal && k < a.pair_count; ++k) {
        const auto n = static_cast<std::size_t>(k);
        equal = a.pairs[n].first == b.pairs[n].first && a.pairs[n].second == b.pairs[n].second &&
                a.pairs[n].normal == b.pairs[n].normal;
    }
    return equal;
}

void run(std::uint64_t number, Outcome& outcome) {
    Random random(number, 31);
    // Exact within a metre; finite beyond.
    const bool within = random.below(4) != 0;
    const double scale = within ? test::between(random, 1e-2, 5) : test::between(random, 5, 1e6);
    bool poisoned = false, has_sides = true;
    std::unique_ptr<CavityModel> wall;
    if (random.below(8) != 0) {
        const TriangleMesh mesh = extreme_wall(random, scale, poisoned, has_sides);
        const FreeSide side = random.below(2) == 0 ? FreeSide::behind : FreeSide::front;
        try {
            wall = std::make_unique<CavityModel>(mesh, side);
            ASSERT_FALSE(poisoned);
        } catch (const InputError&) {
            ++outcome.refused;
            return;
        }
    }
    SphereChainShape chain;
    const int spheres = static_cast<int>(1 + random.below(30));
    const double radius = test::between(random, 1e-6, 0.5) * scale,
                 spacing = test::between(random, 1e-3, 4) * radius;
    for (int i = 0; i < spheres; ++i) {
        chain.arc_lengths.push_back(i * spacing);
        chain.radii.push_back(radius * test::between(random, 0.5, 2));
    }
    if (random.below(20) == 0) {
        const double bad[] = {0, -1, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()};
        chain.radii[random.below(static_cast<std::uint32_t>(spheres))] = bad[random.below(4)];
        EXPECT_THROW(SphereCollision(wall.get(), chain), InputError);
        ++outcome.refused;
        return;
    }
    SphereCollisionOptions options;
    options.list_margin = random.below(6) == 0 ? 0 : test::between(random, 1e-4, 0.01);
    options.projection_iterations = static_cast<int>(random.below(9));
    const bool tight = random.below(5) == 0;
    if (tight) {
        options.list_capacity = static_cast<int>(1 + random.below(4));
        options.planes_per_sphere = static_cast<int>(1 + random.below(2));
        options.pair_capacity = static_cast<int>(1 + random.below(4));
        options.near_row_capacity = static_cast<int>(1 + random.below(4));
    }
    const SphereCollision collision(wall.get(), chain, options);
    SphereCollision::Lists lists = collision.make_lists();
    SphereContacts contacts = collision.make_contacts();
    std::vector<Vector3> centres(static_cast<std::size_t>(spheres));
    const auto place = random.below(4);
    for (int i = 0; i < spheres; ++i) {
        Vector3& centre = centres[static_cast<std::size_t>(i)];
        if (place == 0) {
            centre = scale * 0.01 * Vector3(1, 2, 3);  // all at one point
        } else if (place == 1) {
            centre = Vector3(i * spacing, 0, 0);
        } else {
            centre = 0.08 * scale * test::inside_unit_box(random);
        }
    }
    for (int step = 0; step < 4; ++step) {
        const auto event = random.below(6);
        std::vector<Vector3> now = centres;
        if (event == 0) {  // the whole chain by up to a metre in one step
            for (Vector3& centre : centres) centre.x() += scale * random.uniform(-1, 1);
            now = centres;
        } else if (event == 1) {
            now[random.below(static_cast<std::uint32_t>(spheres))][static_cast<int>(random.below(3))] =
                test::not_a_length(random);
        } else {
            for (Vector3& centre : centres)
                centre += scale * test::between(random, 1e-9, 0.02) * test::inside_unit_box(random);
            now = centres;
        }
        collision.collide(now.data(), lists, contacts);
        check_finite(collision, lists, contacts, now);
        if (testing::Test::HasFatalFailure()) return;
        outcome.cavity += contacts.cavity_count;
        outcome.pairs += contacts.pair_count;
        const bool overflow = contacts.list_overflow || contacts.plane_overflow || contacts.pair_overflow;
        outcome.overflowed += overflow ? 1 : 0;
        if (!within || !has_sides || overflow) continue;
        ++outcome.compared;
        EXPECT_NEAR(contacts.deepest_pair, std::max(0.0, deepest_pair(chain, options, now)),
                    1e-12 + 1e-12 * scale);
        if (wall != nullptr) {
            double deepest = 0;
            for (std::size_t i = 0; i < now.size(); ++i) {
                const CavityPoint nearest = wall->closest(now[i], 1e6);
                if (nearest.triangle >= 0) deepest = std::max(deepest, chain.radii[i] - nearest.distance);
            }
            EXPECT_NEAR(contacts.deepest_cavity, deepest, 1e-9 * scale)
                << "case " << number << " step " << step;
        }
        SphereCollision::Lists fresh = collision.make_lists();
        SphereContacts again = collision.make_contacts();
        collision.collide(now.data(), fresh, again);
        EXPECT_TRUE(same(contacts, again)) << "case " << number << " step " << step;
    }
}

TEST(CollisionExtremes, QueriesStayFiniteAndReportOverflows) {
    Outcome outcome;
    for (int i = 0; i < test::cases_asked() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(i);
        run(static_cast<std::uint64_t>(i), outcome);
    }
    std::printf(
        "%d refused, %d steps overflowed and said so, %d planes, %d pairs, %d steps against brute force\n",
        outcome.refused, outcome.overflowed, outcome.cavity, outcome.pairs, outcome.compared);
    EXPECT_GT(outcome.refused, 0);
    EXPECT_GT(outcome.overflowed, 0) << "the cases must include overflows";
    EXPECT_GT(outcome.compared, outcome.overflowed);
    EXPECT_GT(outcome.cavity, 0);
    EXPECT_GT(outcome.pairs, 0);
}

}  // namespace
}  // namespace fulcrum
