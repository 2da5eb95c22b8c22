// SPDX-License-Identifier: Apache-2.0
// Each invariant of docs/THEORY.md, section 5, violated on purpose: the full check reports it, and the check
// before a commit would have refused it.
#include <gtest/gtest.h>

#include <functional>

#include "tests/sim_core/cutting/surfaces.h"

namespace fulcrum {
namespace {

using test::cut_sheet;
using test::Surface;

struct Damage {
    const char* name;
    std::function<void(CutEditor&, CutState&, std::vector<Vector3>&, std::int32_t)>
        harm;  ///< on a visible triangle
    bool CutCheck::*flag;
};

// A visible child of a cut with no corner on the border.
std::int32_t some_child(const CutMesh& mesh) {
    for (std::int32_t t = 0; t < mesh.triangle_count(); ++t) {
        const CutTriangle& row = mesh.triangle(t);
        if (mesh.visible(t) && row.parent >= 0 && row.neighbours[0] >= 0 && row.neighbours[1] >= 0 &&
            row.neighbours[2] >= 0)
            return t;
    }
    return -1;
}

std::vector<Damage> damages() {
    return {
        {"a rest position that is not finite",
         [](CutEditor& e, CutState& s, std::vector<Vector3>&, std::int32_t t) {
             e.edit_triangle(t);
             e.edit_vertex(s.triangles[t].vertices[0]).rest.x() = std::nan("");
         },
         &CutCheck::finite},
        {"a position that is not finite",
         [](CutEditor& e, CutState& s, std::vector<Vector3>& positions, std::int32_t t) {
             e.edit_triangle(t);
             positions[static_cast<std::size_t>(s.triangles[t].vertices[1])].y() = INFINITY;
         },
         &CutCheck::finite},
        {"a triangle without area",
         [](CutEditor& e, CutState& s, std::vector<Vector3>&, std::int32_t t) {
             const CutTriangle row = e.edit_triangle(t);
             Vector3 b, c;
             barycentric_in(e.model(), s.vertices[row.vertices[1]], row.root, b);
             barycentric_in(e.model(), s.vertices[row.vertices[2]], row.root, c);
             CutVertex& v = e.edit_vertex(row.vertices[0]);
             v.root = row.root;
             v.barycentric = 0.5 * (b + c);
         },
         &CutCheck::no_zero_area},
        {"a triangle turned over",
         [](CutEditor& e, CutState&, std::vector<Vector3>&, std::int32_t t) {
             CutTriangle& row = e.edit_triangle(t);
             std::swap(row.vertices[0], row.vertices[1]);
             std::swap(row.neighbours[1], row.neighbours[2]);
         },
         &CutCheck::oriented},
        {"neighbours that disagree",
         [](CutEditor& e, CutState&, std::vector<Vector3>&, std::int32_t t) {
             e.edit_triangle(t).neighbours[0] = -1;
         },
         &CutCheck::conforming},
        {"a third triangle at an edge",
         [](CutEditor& e, CutState& s, std::vector<Vector3>&, std::int32_t t) {
             const std::int32_t copy = s.triangle_count++;
             const CutTriangle row = s.triangles[t];
             e.edit_triangle(copy) = row;
             e.edit_root(row.root).visible_count += 1;
             ++s.visible_count;
         },
         &CutCheck::manifold_edges},
        {"a vertex that joins two fans",
         [](CutEditor& e, CutState& s, std::vector<Vector3>&, std::int32_t t) {
             // Two copies that a cut has divided, made one again: found by equal rest position.
             for (std::int32_t v = 0; v < s.vertex_count; ++v)
                 for (std::int32_t w = v + 1; w < s.vertex_count; ++w) {
                     if (s.vertices[v].triangle < 0 || s.vertices[w].triangle < 0 ||
                         s.vertices[v].rest != s.vertices[w].rest)
                         continue;
                     bool closed = false;
                     std::vector<std::int32_t> fan;
                     for (const std::int32_t k : e.fan(w, closed)) fan.push_back(k);
                     for (const std::int32_t k : fan)
                         e.edit_triangle(k).vertices[static_cast<std::size_t>(corner_of(s.triangles[k], w))] =
                             v;
                     bool ignored = false;
                     for (const std::int32_t k : e.fan(v, ignored)) e.edit_triangle(k);
                     (void)t;
                     return;
                 }
         },
         &CutCheck::one_fan},
        {"ground that is lost",
         [](CutEditor& e, CutState& s, std::vector<Vector3>&, std::int32_t t) {
             e.edit_triangle(t);
             e.edit_root(s.triangles[t].root).removed_share += 1e-6;
             s.area_removed += 1e-10;
         },
         &CutCheck::area_kept},
    };
}

// A cut with children, and two removed triangles that meet in a vertex.
Surface hurt_surface() {
    Surface surface(cut_sheet(6, 6, 0.01), {}, 100);
    surface.cut(surface.step(0.012, 0.0231, 0.041, 0.0318, 0.001));
    for (const std::int32_t t : {0, 3}) {
        CutState state = surface.mesh.state();
        CutEditor editor(surface.mesh.model());
        CutList<std::int32_t> doomed(1);
        doomed.push(t);
        editor.begin(surface.mesh.model(), state, surface.positions.data());
        editor.remove(doomed);
        editor.commit();
        surface.mesh.restore(state);
    }
    return surface;
}

TEST(CutCheckTest, ReportsEachViolatedInvariant) {
    for (const Damage& damage : damages()) {
        SCOPED_TRACE(damage.name);
        Surface surface = hurt_surface();
        ASSERT_TRUE(surface.check().passed()) << surface.check().complaint();
        const std::int32_t t = some_child(surface.mesh);
        ASSERT_GE(t, 0);
        CutState state = surface.mesh.state();
        CutEditor editor(surface.mesh.model());
        editor.begin(surface.mesh.model(), state, surface.positions.data());
        EXPECT_EQ(editor.wrong_here(), nullptr);
        damage.harm(editor, state, surface.positions, t);
        EXPECT_NE(editor.wrong_here(), nullptr);
        surface.mesh.restore(state);
        const CutCheck check = surface.check();
        EXPECT_FALSE(check.passed());
        EXPECT_FALSE(check.*damage.flag) << check.complaint();
        EXPECT_STRNE(check.complaint(), "");
    }
}

}  // namespace
}  // namespace fulcrum
