// SPDX-License-Identifier: Apache-2.0
// The multigrid cycle: symmetric, positive, equally good on fine and coarse meshes, O(n), and correct after
// changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/membrane/mesh_multigrid.h"
#include "sim_core/membrane/springs.h"
#include "tests/sim_core/membrane/sheets.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

using Vectors = std::vector<Lanes>;

double dot(const Vectors& a, const Vectors& b) {
    Lanes sum = all_lanes(0);
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum_lanes(sum);
}

struct Graph {
    std::vector<GraphEdge> edges;
    std::vector<double> weight, diagonal;
    std::int32_t nodes = 0;

    Vectors times(const Vectors& x) const {
        Vectors product(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) product[i] = all_lanes(diagonal[i]) * x[i];
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const std::size_t i = at(edges[e][0]), j = at(edges[e][1]);
            const Lanes pull = all_lanes(weight[e]) * (x[i] - x[j]);
            product[i] += pull;
            product[j] -= pull;
        }
        return product;
    }
    Vectors random(std::uint64_t seed) const {
        Random generator(seed);
        Vectors x(at(nodes));
        for (Lanes& v : x) v = Lanes{generator.normal(), generator.normal(), generator.normal(), 0};
        return x;
    }
    MeshMultigrid multigrid() const {
        MeshMultigrid made(nodes, edges);
        EXPECT_TRUE(made.build(diagonal.data(), weight.data()));
        return made;
    }
};

/// Edges of a sheet, its nodes in sweep order; held weakly everywhere and strongly along one side. Uneven:
/// weights over a range of 1 to 30, and half of the diagonals in the other direction.
Graph graph_of(int columns, int rows, bool uneven) {
    TriangleMesh mesh = test::sheet(columns, rows);
    Random random(4);
    for (std::size_t t = 0; uneven && t + 1 < mesh.triangles.size(); t += 2) {
        if (random.uniform(0, 1) < 0.5) continue;
        // Corners of the cell, for either direction of its diagonal.
        const int cell = static_cast<int>(t / 2), a = cell / (columns - 1) * columns + cell % (columns - 1);
        mesh.triangles[t] = {a, a + 1, a + columns};
        mesh.triangles[t + 1] = {a + 1, a + columns + 1, a + columns};
    }
    std::vector<GraphEdge> by_vertex;
    for (const MembraneSpring& s : derive_springs(mesh, MembraneMaterial())) {
        if (s.kind == SpringKind::structural) by_vertex.push_back({s.first, s.second});
    }
    Graph graph;
    graph.nodes = columns * rows;
    const std::vector<std::int32_t> order = sweep_order(graph.nodes, by_vertex);
    std::vector<std::int32_t> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<std::int32_t>(k);
    for (const GraphEdge& e : by_vertex) {
        graph.edges.push_back({place[at(e[0])], place[at(e[1])]});
        graph.weight.push_back(uneven ? random.uniform(1, 30) : 10);
    }
    graph.diagonal.assign(at(graph.nodes), 1e-3);
    for (int r = 0; r < rows; ++r) graph.diagonal[at(place[at(r * columns)])] += 10;
    return graph;
}

/// Iterations of conjugate gradients preconditioned with the cycle until the error in its norm is 1e-10 of
/// the first.
int steps_to_solve(const Graph& graph, MeshMultigrid& multigrid) {
    Vectors x(at(graph.nodes), all_lanes(0)), r = graph.random(1), z = r;
    multigrid.solve(z.data());
    Vectors p = z;
    double product = dot(r, z);
    const double start = product;
    int steps = 0;
    while (steps < 500 && product > 1e-20 * start) {
        const Vectors q = graph.times(p);
        const double length = product / dot(p, q);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += all_lanes(length) * p[i];
            r[i] -= all_lanes(length) * q[i];
        }
        z = r;
        multigrid.solve(z.data());
        const double next = dot(r, z);
        for (std::size_t i = 0; i < x.size(); ++i) p[i] = z[i] + all_lanes(next / product) * p[i];
        product = next;
        ++steps;
    }
    const Vectors b = graph.random(1), ax = graph.times(x);
    double worst = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        const Lanes off = b[i] - ax[i];
        worst = std::max(worst, std::sqrt(sum_lanes(off * off)));
    }
    EXPECT_LT(worst, 1e-6);
    return steps;
}

TEST(MeshMultigrid, SolvesSmallSystemsExactly) {
    for (const int size : {2, 3, 6}) {
        const Graph graph = graph_of(size, size + 1, true);
        MeshMultigrid multigrid = graph.multigrid();
        EXPECT_EQ(multigrid.levels(), 1);
        const Vectors b = graph.random(2);
        Vectors x = b;
        multigrid.solve(x.data());
        const Vectors back = graph.times(x);
        for (std::size_t i = 0; i < b.size(); ++i) {
            const Lanes off = back[i] - b[i];
            EXPECT_LT(sum_lanes(off * off), 1e-20);
        }
    }
}

TEST(MeshMultigrid, CycleIsSymmetricAndPositive) {
    const Graph graph = graph_of(40, 31, true);
    MeshMultigrid multigrid = graph.multigrid();
    EXPECT_GE(multigrid.levels(), 3);
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
        const Vectors x = graph.random(seed), y = graph.random(100 + seed);
        Vectors bx = x, by = y;
        multigrid.solve(bx.data());
        multigrid.solve(by.data());
        EXPECT_NEAR(dot(y, bx), dot(x, by), 1e-11 * std::sqrt(dot(x, bx) * dot(y, by)));
        EXPECT_GT(dot(x, bx), 0);
    }
}

TEST(MeshMultigrid, NeedsAsManyStepsOnAFineMeshAsOnACoarseOne) {
    for (const bool uneven : {false, true}) {
        for (const int size : {16, 48, 120}) {
            const Graph graph = graph_of(size, size, uneven);
            MeshMultigrid multigrid = graph.multigrid();
            EXPECT_LE(steps_to_solve(graph, multigrid), 17) << size << " uneven " << uneven;
        }
    }
}

TEST(MeshMultigrid, OperationsGrowLinearlyWithTheNodes) {
    for (const bool uneven : {false, true}) {
        const Graph small = graph_of(22, 22, uneven), large = graph_of(224, 224, uneven);
        const MeshMultigrid few = small.multigrid(), many = large.multigrid();
        const auto exponent = [&](std::int64_t a, std::int64_t b) {
            return std::log(static_cast<double>(b) / static_cast<double>(a)) /
                   std::log(static_cast<double>(large.nodes) / small.nodes);
        };
        EXPECT_LE(exponent(few.solve_operations(), many.solve_operations()), 1.05);
        EXPECT_LE(exponent(few.build_operations(), many.build_operations()), 1.05);
        EXPECT_LE(static_cast<double>(many.bytes()) / large.nodes,
                  1.05 * static_cast<double>(few.bytes()) / small.nodes);
    }
}

TEST(MeshMultigrid, AppliesChangesWithoutAllocating) {
    Graph graph = graph_of(40, 37, true);
    MeshMultigrid multigrid = graph.multigrid();
    const int before = steps_to_solve(graph, multigrid);
    Vectors x = graph.random(3);
    const std::uint64_t made = test::allocations_in([&] {
        for (std::size_t e = 0; e < graph.edges.size(); e += 7) {
            const double change = e % 2 == 0 ? -graph.weight[e] : 5.0;
            graph.weight[e] += change;
            EXPECT_TRUE(multigrid.update(graph.edges[e][0], graph.edges[e][1], change));
        }
        graph.diagonal[20] += 300;
        EXPECT_TRUE(multigrid.update(20, -1, 300));
        multigrid.solve(x.data());
    });
    EXPECT_EQ(made, 0U);
    EXPECT_LE(steps_to_solve(graph, multigrid), before + 4) << "a cycle of the changed matrix";
    // Rebuilt, it has the same finest level, with aggregates of the remaining edges.
    EXPECT_EQ(test::allocations_in([&] { multigrid.build(graph.diagonal.data(), graph.weight.data()); }), 0U);
    EXPECT_LE(steps_to_solve(graph, multigrid), before + 3);
}

TEST(MeshMultigrid, RevertedChangeRestoresTheMatrix) {
    const Graph graph = graph_of(33, 30, true);
    MeshMultigrid multigrid = graph.multigrid(), copy = multigrid;
    for (std::size_t e = 0; e < graph.edges.size(); e += 11) {
        ASSERT_TRUE(copy.update(graph.edges[e][0], graph.edges[e][1], 40));
        ASSERT_TRUE(copy.update(graph.edges[e][0], graph.edges[e][1], -40));
    }
    ASSERT_TRUE(copy.update(3, -1, 1e5));
    Vectors x = graph.random(5), y = x;
    multigrid.solve(x.data());
    copy.solve(y.data());
    double apart = 0, size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Lanes off = x[i] - y[i];
        apart = std::max(apart, sum_lanes(off * off));
    }
    EXPECT_GT(apart, 1e-12);
    ASSERT_TRUE(copy.update(3, -1, -1e5));
    y = graph.random(5);
    copy.solve(y.data());
    apart = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Lanes off = x[i] - y[i];
        apart = std::max(apart, sum_lanes(off * off));
        size = std::max(size, sum_lanes(x[i] * x[i]));
    }
    EXPECT_LT(std::sqrt(apart), 1e-9 * std::sqrt(size));
}

TEST(MeshMultigrid, EveryEdgeCanBeRemoved) {
    Graph graph = graph_of(21, 20, true);
    MeshMultigrid multigrid = graph.multigrid();
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        ASSERT_TRUE(multigrid.update(graph.edges[e][0], graph.edges[e][1], -graph.weight[e]) ||
                    multigrid.build(graph.diagonal.data(), graph.weight.data()));
        graph.weight[e] = 0;
    }
    EXPECT_LE(steps_to_solve(graph, multigrid), 40);
    ASSERT_TRUE(multigrid.build(graph.diagonal.data(), graph.weight.data()));
    EXPECT_LE(steps_to_solve(graph, multigrid), 1) << "only the diagonal remains";
}

TEST(MeshMultigrid, RefusesMatricesThatAreNotPositive) {
    Graph graph = graph_of(9, 9, false);
    MeshMultigrid multigrid = graph.multigrid();
    EXPECT_FALSE(multigrid.update(40, -1, -1e3));
    ASSERT_TRUE(multigrid.build(graph.diagonal.data(), graph.weight.data()));
    graph.diagonal[0] = std::nan("");
    EXPECT_FALSE(multigrid.build(graph.diagonal.data(), graph.weight.data()));
    const std::vector<double> nothing(graph.weight.size(), 0.0);
    graph.diagonal.assign(graph.diagonal.size(), 0.0);
    EXPECT_FALSE(multigrid.build(graph.diagonal.data(), nothing.data()));
}

TEST(MeshMultigrid, ConsecutiveNodesOfASweepAreSeldomConnected) {
    const TriangleMesh mesh = test::sheet(30, 30);
    std::vector<GraphEdge> edges;
    for (const MembraneSpring& s : derive_springs(mesh, MembraneMaterial())) {
        if (s.kind == SpringKind::structural) edges.push_back({s.first, s.second});
    }
    std::vector<std::int32_t> order = sweep_order(900, edges), place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<std::int32_t>(k);
    int joined = 0;
    for (const GraphEdge& e : edges) joined += std::abs(place[at(e[0])] - place[at(e[1])]) < 8 ? 1 : 0;
    EXPECT_LT(joined, 40);
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < order.size(); ++k) EXPECT_EQ(order[k], static_cast<std::int32_t>(k));
}

}  // namespace
}  // namespace fulcrum
