// SPDX-License-Identifier: Apache-2.0
// Dents: shape at the three filter grades, stiffness, relaxation, work and capacity (docs/THEORY.md, section
// 4; Figs. 3, 5).
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/bowel/dent.h"
#include "tests/support/allocation_count.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

const BowelSkin& skin() {
    static const BowelSkin instance = test::make_skin(0.3, 0.016, 0.016, 120, 48, test::plain_radius(0.016));
    return instance;
}

constexpr std::int32_t contact_vertex = 48 * 60 + 11;
WinklerBed endless_bed() {
    WinklerBed result = winkler_bed(32.3e3, 0.35, 0.003, 2.0e7, 0.05);
    result.most_depth = INFINITY;
    return result;
}
const WinklerBed bed = endless_bed();
const Vector3 push(0.1, -0.8, 0.2);

FilteredForce filtered(FilterMode mode) {
    FilterOptions options;
    options.mode = mode;
    FilteredForce result;
    filter_force(view_of(skin().rest(), skin().adjacency()), contact_vertex, 0.0, options, result);
    return result;
}

DentState settled(const FilteredForce& force) {
    DentState state;
    const SurfaceLoad load{&force, nullptr, push};
    for (int i = 0; i < 400; ++i) step_dents(bed, skin().vertex_areas().data(), &load, 1, 0.005, state);
    return state;
}

TEST(WinklerBed, CombinesWallAndBackingInSeries) {
    const double constrained = 32.3e3 * 0.65 / (1.35 * 0.30);
    const double wall = constrained / 0.003;
    EXPECT_NEAR(bed.stiffness_per_area, wall * 2.0e7 / (wall + 2.0e7), 1e-6);
    EXPECT_NEAR(winkler_bed(32.3e3, 0.35, 0.003, INFINITY, 0.05).stiffness_per_area, wall, 1e-6);
}

TEST(Dent, IsASpikeForGradeZeroAndBroadForGradesOneAndTwo) {
    const auto first_ring = skin().adjacency().neighbours_of(contact_vertex);
    double depth[3], width[3];
    for (int grade = 0; grade < 3; ++grade) {
        const DentState state = settled(filtered(static_cast<FilterMode>(grade)));
        depth[grade] = dent_at(state, contact_vertex).norm();
        width[grade] = state.count;
        double beside = 0.0;
        for (const auto v : first_ring) beside += dent_at(state, v).norm() / first_ring.count;
        std::printf("grade %d: depth %.3f mm, first ring %.3f mm, %d vertices\n", grade, 1e3 * depth[grade],
                    1e3 * beside, state.count);
        if (grade == 0) {
            EXPECT_EQ(beside, 0.0);
        }
        if (grade == 1) {
            EXPECT_NEAR(beside / depth[1], std::exp(-0.5), 0.06);
        }
        if (grade == 2) {
            EXPECT_NEAR(beside / depth[2], std::exp(-0.125), 0.03);
        }
    }
    EXPECT_GT(depth[0], 2.0 * depth[1]);
    EXPECT_GT(depth[1], 1.5 * depth[2]);
    EXPECT_EQ(width[0], 1);
    EXPECT_EQ(width[1], 7);
    EXPECT_EQ(width[2], 19);
}

// u_i = C_ii F_i at rest, and the work of the force matches the contact's stiffness.
TEST(Dent, SettlesWhereBedAndForceBalance) {
    for (const auto mode : {FilterMode::grade_0, FilterMode::grade_1, FilterMode::grade_2}) {
        const FilteredForce force = filtered(mode);
        const DentState state = settled(force);
        Vector3 held = Vector3::Zero();
        double conjugate = 0.0;
        for (int i = 0; i < force.count; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const Vector3 u = dent_at(state, force.vertex[n]);
            held +=
                bed.stiffness_per_area * skin().vertex_areas()[static_cast<std::size_t>(force.vertex[n])] * u;
            conjugate += force.weight[n] * u.dot(push.normalized());
        }
        EXPECT_LE((held - push).norm(), 1e-9);
        EXPECT_NEAR(push.norm() / conjugate, contact_stiffness(bed, skin().vertex_areas().data(), force),
                    1e-9 * push.norm() / conjugate);
    }
}

TEST(Dent, HasTheStiffnessOfTheContactThatCausedIt) {
    const FilteredForce force = filtered(FilterMode::grade_1);
    SurfaceLoad load{&force, nullptr, push, 500.0};
    DentState state;
    for (int i = 0; i < 400; ++i) step_dents(bed, skin().vertex_areas().data(), &load, 1, 0.005, state);
    double conjugate = 0.0;
    for (int i = 0; i < force.count; ++i) {
        const auto n = static_cast<std::size_t>(i);
        conjugate += force.weight[n] * dent_at(state, force.vertex[n]).dot(push.normalized());
    }
    EXPECT_NEAR(push.norm() / conjugate, 500.0, 1e-6);
}

TEST(Dent, RelaxesWithItsTimeConstantForAnyStep) {
    const FilteredForce force = filtered(FilterMode::grade_2);
    const SurfaceLoad load{&force, nullptr, push};
    const double final_depth = dent_at(settled(force), contact_vertex).norm();
    for (const int steps : {10, 100}) {
        DentState state;
        for (int i = 0; i < steps; ++i)
            step_dents(bed, skin().vertex_areas().data(), &load, 1, 0.05 / steps, state);
        EXPECT_NEAR(dent_at(state, contact_vertex).norm() / final_depth, 1.0 - std::exp(-1.0), 1e-6);
        for (int i = 0; i < steps; ++i)
            step_dents(bed, skin().vertex_areas().data(), nullptr, 0, 0.05 / steps, state);
        EXPECT_NEAR(dent_at(state, contact_vertex).norm() / final_depth,
                    (1.0 - std::exp(-1.0)) * std::exp(-1.0), 1e-6);
    }
}

TEST(Dent, IsLimitedInDepth) {
    const WinklerBed shallow = winkler_bed(32.3e3, 0.35, 0.003, 2.0e7, 0.05);
    const FilteredForce force = filtered(FilterMode::grade_0);
    const auto depth_under = [&](double newton) {
        const SurfaceLoad load{&force, nullptr, Vector3(0, 0, newton)};
        DentState state;
        for (int i = 0; i < 400; ++i)
            step_dents(shallow, skin().vertex_areas().data(), &load, 1, 0.005, state);
        return dent_at(state, contact_vertex).norm();
    };
    const double stiffness = contact_stiffness(shallow, skin().vertex_areas().data(), force);
    EXPECT_NEAR(depth_under(0.01) * stiffness / 0.01, 1.0, 0.001) << "a small dent matches the linear bed";
    double last = 0.0;
    for (double newton = 0.1; newton < 1000.0; newton *= 2.0) {
        const double depth = depth_under(newton);
        EXPECT_GT(depth, last);
        EXPECT_LE(depth, shallow.most_depth);
        last = depth;
    }
}

TEST(Dent, VanishesAfterTheToolIsWithdrawn) {
    DentState state = settled(filtered(FilterMode::grade_2));
    EXPECT_EQ(state.count, 19);
    for (int i = 0; i < 400; ++i) step_dents(bed, skin().vertex_areas().data(), nullptr, 0, 0.005, state);
    EXPECT_EQ(state.count, 0);
    EXPECT_EQ(state.entries[0].vertex, -1) << "the hashed state contains no old values";
}

TEST(Dent, DentsOfTwoToolsAddUpAndPatchNumbersAreMapped) {
    const FilteredForce one = filtered(FilterMode::grade_1);
    FilteredForce local = one;
    std::vector<std::int32_t> vertex_of(100, -1);
    for (int i = 0; i < one.count; ++i) {
        vertex_of[static_cast<std::size_t>(99 - i)] = one.vertex[static_cast<std::size_t>(i)];
        local.vertex[static_cast<std::size_t>(i)] = 99 - i;
    }
    const SurfaceLoad loads[] = {{&one, nullptr, push}, {&local, vertex_of.data(), push}};
    DentState both;
    for (int i = 0; i < 400; ++i) step_dents(bed, skin().vertex_areas().data(), loads, 2, 0.005, both);
    EXPECT_LE((dent_at(both, contact_vertex) - 2.0 * dent_at(settled(one), contact_vertex)).norm(), 1e-12);
    EXPECT_NEAR(contact_stiffness(bed, skin().vertex_areas().data(), local, vertex_of.data()),
                contact_stiffness(bed, skin().vertex_areas().data(), one), 1e-9);
    for (int i = 1; i < both.count; ++i) {
        EXPECT_LT(both.entries[static_cast<std::size_t>(i - 1)].vertex,
                  both.entries[static_cast<std::size_t>(i)].vertex);
    }
}

TEST(Dent, ReportsFullCapacityAndAllocatesNothing) {
    DentState state;
    FilterOptions options;
    options.mode = FilterMode::grade_2;
    bool overflow = false;
    FilteredForce force;
    const auto view = view_of(skin().rest(), skin().adjacency());
    EXPECT_EQ(test::allocations_in([&] {
                  for (std::int32_t v = 500; v < 3000; v += 5) {
                      filter_force(view, v, 0.0, options, force);
                      const SurfaceLoad load{&force, nullptr, push};
                      step_dents(bed, skin().vertex_areas().data(), &load, 1, 0.0001, state);
                      overflow = overflow || state.overflow;
                  }
              }),
              0u);
    EXPECT_TRUE(overflow);
    EXPECT_LE(state.count, dent_capacity);
}

}  // namespace
}  // namespace fulcrum
