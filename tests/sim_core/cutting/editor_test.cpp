// SPDX-License-Identifier: Apache-2.0
// The primitive operations and their journal: each keeps the surface valid, and a transaction that is rolled
// back restores every bit.
#include <gtest/gtest.h>

#include "sim_core/numerics/random.h"
#include "tests/sim_core/cutting/surfaces.h"

namespace fulcrum {
namespace {

using test::cut_sheet;
using test::Surface;

// Random operations on a state, as far as each is possible.
void work(CutEditor& editor, const CutModel& model, const CutState& state, Random& random, int operations) {
    CutList<std::int32_t> doomed(4);
    for (int i = 0; i < operations; ++i) {
        std::int32_t t = -1;
        while (t < 0 || !editor.visible(t))
            t = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(state.triangle_count)));
        const int edge = static_cast<int>(random.below(3));
        switch (random.below(5)) {
            case 0:
            case 1:
                editor.split_edge(t, edge, random.uniform(0.2, 0.8));
                break;
            case 2:
                editor.flip(t, edge);
                break;
            case 3: {
                const std::int32_t v = vertex_at(state.triangles[t], edge);
                if (v >= model.original_vertices) editor.collapse(v, vertex_at(state.triangles[t], edge + 1));
                break;
            }
            default:
                if (random.below(4) != 0) break;
                doomed.clear();
                doomed.push(t);
                editor.remove(doomed);
        }
    }
}

class CutJournal : public ::testing::TestWithParam<int> {};

TEST_P(CutJournal, RestoresEveryBit) {
    Surface surface(cut_sheet(6, 6, 0.01), {0, 1}, 100);
    surface.stroke({{0.005, 0.02}, {0.05, 0.031}}, 0.002);
    CutEditor editor(surface.mesh.model());
    const auto seed = static_cast<std::uint64_t>(GetParam());
    Random random(seed);
    CutState state = surface.mesh.state();
    const auto digest = [&] {
        surface.mesh.restore(state);
        return surface.mesh.digest();
    };
    for (int k = 0; k < 15; ++k) {
        const std::uint64_t before = digest();
        editor.begin(surface.mesh.model(), state, surface.positions.data());
        work(editor, surface.mesh.model(), state, random, 40);
        EXPECT_NE(digest(), before);
        const CutCheck check = surface.check();
        EXPECT_TRUE(check.passed()) << check.complaint() << " at " << check.first_bad << " seed " << seed;
        EXPECT_EQ(editor.wrong_here(), nullptr);
        if (k % 3 == 2) {
            editor.commit();
            continue;
        }
        editor.roll_back();
        EXPECT_EQ(digest(), before);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CutJournal, ::testing::Range(0, 6));

class CutEditing : public ::testing::Test {
  protected:
    Surface surface_{cut_sheet(2, 2, 0.01), {}, 20};
    CutState state_ = surface_.mesh.state();
    CutEditor editor_{surface_.mesh.model()};
    void begin() { editor_.begin(surface_.mesh.model(), state_, surface_.positions.data()); }
    CutCheck check() {
        CutMesh mesh = surface_.mesh;
        mesh.restore(state_);
        return check_cut(mesh, surface_.positions.data());
    }
};

TEST_F(CutEditing, SplittingAnEdgeDoublesItsTriangles) {
    begin();
    int inner = 0, rims = 0;
    for (std::int32_t t = 0; t < 8; ++t)
        for (int e = 0; e < 3 && editor_.visible(t); ++e) {
            const bool rim = neighbour_at(state_.triangles[t], e) < 0;
            const std::int32_t before = state_.visible_count;
            ASSERT_GE(editor_.split_edge(t, e, 0.25), 0);
            EXPECT_EQ(state_.visible_count, before + (rim ? 1 : 2));
            ++(rim ? rims : inner);
            EXPECT_TRUE(check().passed()) << check().complaint();
        }
    EXPECT_GT(inner, 0);
    EXPECT_GT(rims, 0);
}

TEST_F(CutEditing, NewVertexIsOnItsEdge) {
    begin();
    const Triangle v = state_.triangles[0].vertices;
    surface_.positions[static_cast<std::size_t>(v[0])] += Vector3(0, 0, 0.004);
    const std::int32_t m = editor_.split_edge(0, 0, 0.25);
    const Vector3 rest = 0.75 * state_.vertices[v[0]].rest + 0.25 * state_.vertices[v[1]].rest;
    EXPECT_LT((state_.vertices[m].rest - rest).norm(), 1e-17);
    EXPECT_NEAR(surface_.positions[static_cast<std::size_t>(m)].z(), 0.003, 1e-15);
    EXPECT_EQ(state_.vertices[m].barycentric[2], 0.0);
}

TEST_F(CutEditing, VertexBetweenTwoFixedVerticesIsFixed) {
    Surface held(cut_sheet(2, 2, 0.01), {0, 1}, 20);
    CutState state = held.mesh.state();
    CutEditor editor(held.mesh.model());
    editor.begin(held.mesh.model(), state, held.positions.data());
    const int e = edge_of(state.triangles[0], 0, 1);
    ASSERT_GE(e, 0);
    EXPECT_TRUE(state.vertices[editor.split_edge(0, e, 0.5)].fixed);
    const int other =
        edge_of(state.triangles[1], 0, vertex_at(state.triangles[1], corner_of(state.triangles[1], 0) + 1));
    ASSERT_GE(other, 0);
    EXPECT_FALSE(state.vertices[editor.split_edge(1, other, 0.5)].fixed);
}

TEST_F(CutEditing, RemovingTwoOppositeTrianglesDividesTheirVertex) {
    // The middle vertex of four cells: two opposite triangles of its fan leave two fans.
    begin();
    const std::int32_t middle = 4;
    std::vector<std::int32_t> around;
    bool closed = false;
    for (const std::int32_t t : editor_.fan(middle, closed)) around.push_back(t);
    EXPECT_TRUE(closed);
    const std::size_t count = around.size();
    ASSERT_GE(count, 4U);
    CutList<std::int32_t> doomed(2);
    doomed.push(around[0]);
    doomed.push(around[count / 2]);
    const std::int32_t vertices = state_.vertex_count;
    ASSERT_TRUE(editor_.remove(doomed));
    EXPECT_EQ(state_.vertex_count, vertices + 1);
    EXPECT_EQ(state_.vertices[vertices].rest, state_.vertices[middle].rest);
    EXPECT_TRUE(check().passed()) << check().complaint();
}

TEST_F(CutEditing, CollapseUndoesASplitAndKeepsTheArea) {
    begin();
    const std::int32_t m = editor_.split_edge(0, 0, 0.4);
    const std::int32_t to = surface_.mesh.triangle(0).vertices[0];
    ASSERT_TRUE(editor_.collapse(m, to));
    EXPECT_EQ(state_.visible_count, 8);
    EXPECT_LT(state_.vertices[m].triangle, 0);
    EXPECT_TRUE(check().passed()) << check().complaint();
}

TEST_F(CutEditing, CollapseRefusesToLoseArea) {
    begin();
    // The corner of the sheet is on the border and not between its neighbours.
    const std::int32_t corner = 0, next = 1;
    EXPECT_FALSE(editor_.collapse(corner, next));
    EXPECT_EQ(state_.visible_count, 8);
    EXPECT_TRUE(check().passed());
}

TEST_F(CutEditing, FlipStaysWithinARoot) {
    begin();
    for (std::int32_t t = 0; t < 8; ++t)
        for (int e = 0; e < 3; ++e) EXPECT_FALSE(editor_.flip(t, e));
    const std::int32_t m = editor_.split_edge(0, 0, 0.5);
    int flipped = 0;
    for (std::int32_t t = 0; t < state_.triangle_count; ++t)
        if (editor_.visible(t) && corner_of(state_.triangles[t], m) >= 0)
            for (int e = 0; e < 3; ++e) flipped += editor_.flip(t, e) ? 1 : 0;
    EXPECT_EQ(flipped, 0);  // m lies on the edge: turning the halves would turn one over
    EXPECT_TRUE(check().passed());
}

TEST(CutRoom, FullTableIsReportedAndNothingChanges) {
    for (int k = 0; k < 3; ++k) {
        CutCapacity capacity = CutMesh::capacity_for(cut_sheet(4, 4, 0.01), 1);
        if (k == 0) capacity.vertices = 27;
        if (k == 1) capacity.triangles = 36;
        if (k == 2) capacity.fragments = 32;
        Surface surface(cut_sheet(4, 4, 0.01), {}, capacity);
        const std::uint64_t digest = surface.mesh.digest();
        const CutReport report = surface.cut(surface.step(-0.01, 0.0152, 0.05, 0.0231, 0.002));
        EXPECT_EQ(report.outcome, CutOutcome::full);
        EXPECT_EQ(report.lacking, k == 0   ? CutLimit::vertices
                                  : k == 1 ? CutLimit::triangles
                                           : CutLimit::fragments);
        EXPECT_EQ(surface.mesh.digest(), digest);
        EXPECT_TRUE(surface.check().passed());
    }
}

}  // namespace
}  // namespace fulcrum
