// SPDX-License-Identifier: Apache-2.0
// The force filter: Eqs. 1-4, patches, no allocation. Sum and continuity are cases of sim_core/lab, asserted
// in tests/sim_core/lab.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim_core/bowel/force_filter.h"
#include "sim_core/lab/reference_tube.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

struct Surface {
    TriangleMesh mesh = lab::make_tube(0.3, 120, 48, lab::haustral_radius(0.016));
    MeshAdjacency adjacency = build_adjacency(mesh);
    SurfaceView view() const { return view_of(mesh, adjacency); }
};

const Surface& surface() {
    static const Surface instance;
    return instance;
}

constexpr std::int32_t contact_vertex = 48 * 60 + 11;

FilteredForce filtered(double area, FilterMode mode = FilterMode::adaptive, double sigma = 0.0) {
    FilterOptions options;
    options.mode = mode;
    options.sigma = sigma;
    FilteredForce result;
    filter_force(surface().view(), contact_vertex, area, options, result);
    return result;
}

std::map<std::int32_t, double> weights_of(const FilteredForce& force) {
    std::map<std::int32_t, double> weights;
    for (int i = 0; i < force.count; ++i) {
        weights[force.vertex[static_cast<std::size_t>(i)]] = force.weight[static_cast<std::size_t>(i)];
    }
    return weights;
}

double local_area() {
    return mean_triangle_area(surface().view(), contact_vertex);
}

TEST(ContactArea, IsEquationFour) {
    TipBox tip;
    tip.edges = Vector3(0.010, 0.004, 0.002);
    EXPECT_NEAR(contact_area(tip, Vector3::UnitX()), 0.5 * 0.004 * 0.002, 1e-18);
    EXPECT_NEAR(contact_area(tip, Vector3::UnitY()), 0.25 * 0.010 * 0.002, 1e-18);
    EXPECT_NEAR(contact_area(tip, -Vector3::UnitZ()), 0.25 * 0.010 * 0.004, 1e-18);
    tip.axes = Eigen::AngleAxisd(0.7, Vector3(1, 1, 0).normalized()).toRotationMatrix();
    const Vector3 normal = Vector3(0.2, -0.5, 0.7).normalized();
    double expected = 0.0;
    const double weights[] = {0.5, 0.25, 0.25}, faces[] = {8e-6, 20e-6, 40e-6};
    for (int i = 0; i < 3; ++i) expected += weights[i] * faces[i] * std::abs(tip.axes.col(i).dot(normal));
    EXPECT_NEAR(contact_area(tip, normal), expected, 1e-18);
}

TEST(FilterGrade, IsEquationThree) {
    EXPECT_EQ(filter_grade(0.999, 1.0), 0);
    EXPECT_EQ(filter_grade(1.0, 1.0), 1);
    EXPECT_EQ(filter_grade(4.0, 1.0), 1);
    EXPECT_EQ(filter_grade(4.001, 1.0), 2);
}

TEST(ForceFilter, TouchesTheRingsOfItsGrade) {
    const auto view = surface().view();
    const auto first_ring = view.neighbours_of(contact_vertex);
    EXPECT_EQ(filtered(0.0, FilterMode::grade_0).count, 1);
    EXPECT_EQ(filtered(0.0, FilterMode::grade_1).count, 1 + first_ring.count);
    const auto weights = weights_of(filtered(0.0, FilterMode::grade_2));
    EXPECT_EQ(weights.size(), 19u) << "valence six: 1 + 6 + 12";
    for (const auto v : first_ring) {
        for (const auto w : view.neighbours_of(v)) EXPECT_EQ(weights.count(w), 1u);
    }
}

TEST(ForceFilter, WeightsAreEquationsOneAndTwo) {
    const auto& mesh = surface().mesh;
    const Vector3 centre = mesh.vertices[contact_vertex];
    const double edge = mean_edge_length(surface().view(), contact_vertex);
    for (const int grade : {1, 2}) {
        for (const double given : {0.0, 0.003}) {
            const FilteredForce force = filtered(0.0, static_cast<FilterMode>(grade), given);
            const double sigma = given > 0.0 ? given : grade * edge;
            EXPECT_DOUBLE_EQ(force.sigma, sigma);
            const auto weights = weights_of(force);
            for (const auto& [vertex, weight] : weights) {
                const double r = (mesh.vertices[static_cast<std::size_t>(vertex)] - centre).norm();
                EXPECT_NEAR(weight / weights.at(contact_vertex), std::exp(-r * r / (2.0 * sigma * sigma)),
                            1e-14);
            }
        }
    }
}

TEST(ForceFilter, BlendsOnlyNearTheThresholds) {
    const double area = local_area();
    EXPECT_EQ(weights_of(filtered(0.89 * area)), weights_of(filtered(0.0, FilterMode::grade_0)));
    EXPECT_EQ(weights_of(filtered(1.11 * area)), weights_of(filtered(0.0, FilterMode::grade_1)));
    EXPECT_EQ(weights_of(filtered(3.59 * area)), weights_of(filtered(0.0, FilterMode::grade_1)));
    EXPECT_EQ(weights_of(filtered(4.41 * area)), weights_of(filtered(0.0, FilterMode::grade_2)));
    const auto between = weights_of(filtered(area));
    const auto zero = weights_of(filtered(0.0, FilterMode::grade_0)),
               one = weights_of(filtered(0.0, FilterMode::grade_1));
    for (const auto& [vertex, weight] : between) {
        const double other = zero.count(vertex) != 0 ? zero.at(vertex) : 0.0;
        EXPECT_NEAR(weight, 0.5 * (other + one.at(vertex)), 1e-12);
    }
    EXPECT_EQ(filtered(0.95 * area).grade, 0) << "the grade reported is Eq. 3's, unblended";
    EXPECT_EQ(filtered(1.05 * area).grade, 1);
}

TEST(ForceFilter, GivesTheSameResultOnAPatch) {
    // Cut the neighbourhood out of the tube: vertices within 12 mm and the triangles between them.
    const auto& mesh = surface().mesh;
    TriangleMesh patch;
    std::vector<std::int32_t> number(mesh.vertices.size(), -1), original;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if ((mesh.vertices[v] - mesh.vertices[contact_vertex]).norm() > 0.012) continue;
        number[v] = static_cast<std::int32_t>(patch.vertices.size());
        original.push_back(static_cast<std::int32_t>(v));
        patch.vertices.push_back(mesh.vertices[v]);
    }
    for (const auto& t : mesh.triangles) {
        const Triangle local = {number[static_cast<std::size_t>(t[0])],
                                number[static_cast<std::size_t>(t[1])],
                                number[static_cast<std::size_t>(t[2])]};
        if (local[0] >= 0 && local[1] >= 0 && local[2] >= 0) patch.triangles.push_back(local);
    }
    ASSERT_LT(patch.vertices.size(), 300u);
    const MeshAdjacency adjacency = build_adjacency(patch);
    FilteredForce force;
    filter_force(view_of(patch, adjacency), number[contact_vertex], 4.0 * local_area(), {}, force);
    std::map<std::int32_t, double> weights;
    for (int i = 0; i < force.count; ++i) {
        weights[original[static_cast<std::size_t>(force.vertex[static_cast<std::size_t>(i)])]] =
            force.weight[static_cast<std::size_t>(i)];
    }
    const auto whole = weights_of(filtered(4.0 * local_area()));
    ASSERT_EQ(weights.size(), whole.size());
    for (const auto& [vertex, weight] : whole) EXPECT_NEAR(weights.at(vertex), weight, 1e-15);
}

TEST(ForceFilter, HandlesDegenerateSurfaces) {
    // A fan of 200 triangles around one vertex exceeds the capacity; an isolated vertex has no ring.
    TriangleMesh fan;
    fan.vertices.emplace_back(0, 0, 0);
    for (int k = 0; k <= 200; ++k) fan.vertices.emplace_back(std::cos(0.03 * k), std::sin(0.03 * k), 0.0);
    for (int k = 1; k <= 200; ++k) fan.triangles.push_back({0, k, k + 1});
    fan.vertices.emplace_back(5, 5, 5);
    const MeshAdjacency adjacency = build_adjacency(fan);
    FilterOptions options;
    options.mode = FilterMode::grade_2;
    FilteredForce force;
    filter_force(view_of(fan, adjacency), 0, 1.0, options, force);
    EXPECT_TRUE(force.overflow);
    EXPECT_EQ(force.count, filter_capacity);
    double sum = 0.0;
    for (int i = 0; i < force.count; ++i) sum += force.weight[static_cast<std::size_t>(i)];
    EXPECT_NEAR(sum, 1.0, 1e-12);
    filter_force(view_of(fan, adjacency), 202, 1.0, {}, force);
    EXPECT_EQ(force.count, 1);
    EXPECT_EQ(force.weight[0], 1.0);
    for (auto& vertex : fan.vertices) vertex.setZero();
    filter_force(view_of(fan, adjacency), 3, TipBox{}, options, force);
    sum = 0.0;
    for (int i = 0; i < force.count; ++i) sum += force.weight[static_cast<std::size_t>(i)];
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ForceFilter, AllocatesNothing) {
    const auto view = surface().view();
    FilteredForce force;
    EXPECT_EQ(test::allocations_in([&] {
                  for (std::int32_t v = 1000; v < 1200; ++v) filter_force(view, v, TipBox{}, {}, force);
              }),
              0u);
    EXPECT_GT(force.count, 0);
}

}  // namespace
}  // namespace fulcrum
