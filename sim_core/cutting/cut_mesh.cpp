// SPDX-License-Identifier: Apache-2.0
// Construction, queries and saving; cutting itself is in cut_step.cpp.
#include "sim_core/cutting/cut_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_hash.h"

namespace fulcrum {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& wrong, const std::string& hint) {
    throw InputError("mesh to cut", place, wrong, hint);
}

void require_manifold(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) refuse("", "the mesh has no triangle", "give a surface");
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!mesh.vertices[v].allFinite())
            refuse("vertex " + std::to_string(v), "a coordinate is not finite", "give finite coordinates");
    const auto count = static_cast<std::int32_t>(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& v = mesh.triangles[t];
        if (*std::min_element(v.begin(), v.end()) < 0 || *std::max_element(v.begin(), v.end()) >= count)
            refuse("triangle " + std::to_string(t), "the triangle uses a vertex that does not exist",
                   "use vertices 0 to " + std::to_string(count - 1));
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            refuse("triangle " + std::to_string(t), "the triangle uses a vertex twice",
                   "remove the triangle");
    }
    const MeshReport report = check_mesh(mesh);
    if (!report.manifold_edges) refuse("", "an edge has more than two triangles", "split the surface there");
    if (!report.oriented)
        refuse("", "two neighbouring triangles have opposite orientation",
               "orient all triangles the same way");
    if (!report.manifold_vertices)
        refuse("vertex " + std::to_string(report.first_bad_vertex),
               "the vertex joins two separate triangle fans", "give each fan a vertex of its own");
}

std::shared_ptr<const CutModel> make_model(const TriangleMesh& mesh, const CutCapacity& capacity) {
    require_manifold(mesh);
    auto model = std::make_shared<CutModel>();
    model->mesh = mesh;
    model->adjacency = build_adjacency(mesh);
    model->original_vertices = static_cast<std::int32_t>(mesh.vertices.size());
    model->root_count = static_cast<std::int32_t>(mesh.triangles.size());
    model->capacity = capacity;
    if (capacity.vertices < model->original_vertices || capacity.triangles < model->root_count ||
        capacity.fragments < model->root_count || capacity.stroke_triangles < 0)
        refuse("capacity", "the capacity is smaller than the mesh itself needs", "use CutMesh::capacity_for");
    for (const Triangle& t : mesh.triangles) {
        const Vector3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        const Vector3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
        const Vector3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
        const double area = triangle_area(a, b, c);
        const Vector3 centre = (a + b + c) / 3;
        const double longest =
            std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
        model->areas.push_back(area);
        model->area += area;
        model->centres.push_back(centre);
        model->radii.push_back(std::sqrt(
            std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()})));
        model->flat.push_back(area <= 1e-13 * longest * longest);
    }
    return model;
}

}  // namespace

CutCapacity CutMesh::capacity_for(const TriangleMesh& mesh, std::int32_t steps) {
    const auto vertices = static_cast<std::int32_t>(mesh.vertices.size());
    const auto triangles = static_cast<std::int32_t>(mesh.triangles.size());
    CutCapacity capacity;
    capacity.vertices = 4 * vertices + 40 * steps + 256;
    capacity.triangles = 6 * triangles + 120 * steps + 1024;
    capacity.fragments = 3 * triangles + 20 * steps + 256;
    capacity.stroke_triangles = triangles + 20 * steps;
    return capacity;
}

CutMesh::CutMesh(const TriangleMesh& mesh, const std::vector<std::int32_t>& fixed,
                 const CutCapacity& capacity)
    : model_(make_model(mesh, capacity)),
      editor_(*model_),
      sides_(capacity.vertices),
      root_mark_(model_->root_count, 0),
      triangle_mark_(capacity.triangles, 0),
      vertex_mark_(capacity.vertices, 0),
      queue_(std::max(model_->root_count, capacity.triangles)),
      met_(capacity.triangles),
      band_(4 * capacity.triangles),
      around_(capacity.vertices),
      parts_(capacity.triangles),
      piece_of_(capacity.triangles, -1),
      pieces_(capacity.triangles),
      sides_met_(capacity.triangles) {
    state_.triangles = CutTable<CutTriangle>(capacity.triangles);
    state_.vertices = CutTable<CutVertex>(capacity.vertices);
    state_.roots = CutTable<CutRoot>(model_->root_count);
    state_.fragments = CutTable<CutFragment>(capacity.fragments);
    state_.free_triangles = CutList<std::int32_t>(capacity.triangles);
    state_.free_vertices = CutList<std::int32_t>(capacity.vertices);
    state_.stroke_triangles = CutList<StrokeTriangle>(capacity.stroke_triangles);
    state_.stroke_place = CutTable<std::int32_t>(capacity.triangles, 0);
    for (const std::int32_t v : fixed) {
        if (v < 0 || v >= model_->original_vertices)
            refuse("fixed", "vertex " + std::to_string(v) + " does not exist",
                   "use vertex numbers of the mesh");
        state_.vertices[v].fixed = true;
    }
    reset();
}

void CutMesh::reset() {
    const std::int32_t roots = model_->root_count, vertices = model_->original_vertices;
    for (std::int32_t v = 0; v < vertices; ++v) {
        CutVertex& row = state_.vertices[v];
        const bool fixed = row.fixed;
        row = CutVertex();
        row.fixed = fixed;
        row.rest = model_->mesh.vertices[static_cast<std::size_t>(v)];
    }
    for (std::int32_t t = 0; t < roots; ++t) {
        CutTriangle& row = state_.triangles[t];
        row = CutTriangle();
        row.vertices = model_->mesh.triangles[static_cast<std::size_t>(t)];
        for (int e = 0; e < 3; ++e) {
            const auto place = static_cast<std::size_t>(e);
            row.neighbours[place] =
                model_->adjacency.triangle_neighbours[3 * static_cast<std::size_t>(t) + place];
            CutVertex& vertex = state_.vertices[row.vertices[place]];
            if (vertex.triangle >= 0) continue;
            vertex.triangle = vertex.root = t;
            vertex.barycentric = Vector3::Unit(e);
        }
        row.root = row.fragment = t;
        row.state = CutTriangleState::visible;
        row.share = 1;
        state_.roots[t] = {t, 1, 0.0};
        state_.fragments[t] = {t, -1, -1, 1, 1.0};
        state_.stroke_place[t] = 0;
    }
    state_.free_triangles.clear();
    state_.free_vertices.clear();
    state_.stroke_triangles.clear();
    state_.vertex_count = vertices;
    state_.triangle_count = state_.visible_count = state_.fragment_count = roots;
    state_.stroke = state_.stroke_step = state_.stroke_unnamed = 0;
    state_.version = state_.rolled_back = 0;
    state_.area_visible = model_->area;
    state_.area_removed = 0;
}

std::vector<Triangle> CutMesh::visible_triangles() const {
    std::vector<Triangle> triangles;
    triangles.reserve(static_cast<std::size_t>(state_.visible_count));
    for (std::int32_t t = 0; t < state_.triangle_count; ++t)
        if (visible(t)) triangles.push_back(state_.triangles[t].vertices);
    return triangles;
}

std::int32_t CutMesh::nearest_root(const Vector3& point, const Vector3* positions) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::int32_t root = -1;
    for (std::int32_t t = 0; t < state_.triangle_count; ++t) {
        if (!visible(t)) continue;
        const CutTriangle& row = state_.triangles[t];
        const TrianglePoint foot = closest_point_on_triangle(
            point, positions[row.vertices[0]], positions[row.vertices[1]], positions[row.vertices[2]]);
        const double distance = (foot.position - point).squaredNorm();
        if (!(distance < nearest)) continue;
        nearest = distance;
        root = row.root;
    }
    return root;
}

std::int32_t CutMesh::fragment_of_vertex(std::int32_t v) const {
    const std::int32_t t = state_.vertices[v].triangle;
    return t < 0 ? -1 : state_.triangles[t].fragment;
}

std::uint64_t CutMesh::digest() const {
    StateHash hash;
    const auto add = [&hash](std::int32_t value) { hash.add(static_cast<std::int64_t>(value)); };
    for (std::int32_t t = 0; t < state_.triangle_count; ++t) {
        const CutTriangle& row = state_.triangles[t];
        for (const std::int32_t v : row.vertices) add(v);
        for (const std::int32_t n : row.neighbours) add(n);
        for (const std::int32_t n : {row.root, row.parent, row.first_child, row.next_sibling,
                                     row.next_in_root, row.previous_in_root, row.fragment, row.stroke})
            add(n);
        hash.add(static_cast<std::uint64_t>(row.state));
        hash.add(static_cast<std::uint64_t>(row.attempt));
        hash.add(row.share);
    }
    for (std::int32_t v = 0; v < state_.vertex_count; ++v) {
        const CutVertex& row = state_.vertices[v];
        hash.add(row.rest);
        hash.add(row.barycentric);
        add(row.root);
        add(row.triangle);
        hash.add(static_cast<std::uint64_t>(row.fixed ? 1 : 0) + (row.divided ? 2U : 0U));
    }
    for (std::int32_t r = 0; r < model_->root_count; ++r) {
        add(state_.roots[r].first_visible);
        add(state_.roots[r].visible_count);
        hash.add(state_.roots[r].removed_share);
    }
    for (std::int32_t f = 0; f < state_.fragment_count; ++f) {
        const CutFragment& row = state_.fragments[f];
        for (const std::int32_t n : {row.root, row.from, row.next_of_root, row.triangles}) add(n);
        hash.add(row.share);
    }
    for (const std::int32_t t : state_.free_triangles) add(t);
    for (const std::int32_t v : state_.free_vertices) add(v);
    for (const std::int32_t n : {state_.vertex_count, state_.triangle_count, state_.fragment_count,
                                 state_.visible_count, state_.stroke, state_.stroke_step})
        add(n);
    hash.add(state_.version);
    hash.add(state_.area_visible);
    hash.add(state_.area_removed);
    return hash.value();
}

std::uint64_t CutMesh::bytes() const {
    return state_.triangles.bytes() + state_.vertices.bytes() + state_.roots.bytes() +
           state_.fragments.bytes() + state_.free_triangles.bytes() + state_.free_vertices.bytes() +
           state_.stroke_triangles.bytes() + state_.stroke_place.bytes() + editor_.bytes() + sides_.bytes() +
           root_mark_.bytes() + triangle_mark_.bytes() + vertex_mark_.bytes() + queue_.bytes() +
           met_.bytes() + band_.bytes() + around_.bytes() + parts_.bytes() + piece_of_.bytes() +
           pieces_.bytes() + sides_met_.bytes();
}

}  // namespace fulcrum
