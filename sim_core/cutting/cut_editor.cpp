// SPDX-License-Identifier: Apache-2.0
// Transaction, journal and bookkeeping of the records; the operations are in cut_operations.cpp.
#include "sim_core/cutting/cut_editor.h"

#include <algorithm>

namespace fulcrum {

bool barycentric_in_other(const CutModel& model, const CutVertex& vertex, std::int32_t root,
                          Vector3& coordinates) {
    const Triangle& own = model.mesh.triangles[static_cast<std::size_t>(vertex.root)];
    const Triangle& other = model.mesh.triangles[static_cast<std::size_t>(root)];
    coordinates.setZero();
    for (int i = 0; i < 3; ++i) {
        if (vertex.barycentric[i] == 0) continue;
        int j = 0;
        while (j < 3 && other[static_cast<std::size_t>(j)] != own[static_cast<std::size_t>(i)]) ++j;
        if (j == 3) return false;
        coordinates[j] = vertex.barycentric[i];
    }
    return true;
}

CutEditor::CutEditor(const CutModel& model)
    : triangle_stamp_(model.capacity.triangles, 0),
      vertex_stamp_(model.capacity.vertices, 0),
      root_stamp_(model.root_count, 0),
      fragment_stamp_(model.capacity.fragments, 0),
      doomed_stamp_(model.capacity.triangles, 0),
      divided_stamp_(model.capacity.vertices, 0),
      counted_stamp_(model.capacity.vertices, 0),
      fan_count_(model.capacity.vertices, 0),
      undo_triangles_(model.capacity.triangles),
      undo_vertices_(model.capacity.vertices),
      undo_roots_(model.root_count),
      undo_fragments_(model.capacity.fragments),
      touched_triangles_(model.capacity.triangles),
      touched_roots_(model.root_count),
      new_vertices_(model.capacity.vertices),
      made_(2 * model.capacity.triangles),
      fan_(model.capacity.triangles) {}

std::uint64_t CutEditor::bytes() const {
    return triangle_stamp_.bytes() + vertex_stamp_.bytes() + root_stamp_.bytes() + fragment_stamp_.bytes() +
           doomed_stamp_.bytes() + divided_stamp_.bytes() + counted_stamp_.bytes() + fan_count_.bytes() +
           undo_triangles_.bytes() + undo_vertices_.bytes() + undo_roots_.bytes() + undo_fragments_.bytes() +
           touched_triangles_.bytes() + touched_roots_.bytes() + new_vertices_.bytes() + made_.bytes() +
           fan_.bytes();
}

void CutEditor::begin(const CutModel& model, CutState& state, Vector3* positions) {
    model_ = &model;
    state_ = &state;
    positions_ = positions;
    lacking_ = CutLimit::none;
    ++state.attempt;
    ++stamp_;
    undo_triangles_.clear();
    undo_vertices_.clear();
    undo_roots_.clear();
    undo_fragments_.clear();
    touched_triangles_.clear();
    touched_roots_.clear();
    new_vertices_.clear();
    made_.clear();
    before_ = {state.vertex_count,  state.triangle_count,        state.fragment_count,
               state.visible_count, state.free_triangles.size(), state.free_vertices.size(),
               state.area_visible,  state.area_removed};
}

void CutEditor::commit() {
    // Records created and dropped within this transaction can be reused; nothing else has seen them.
    for (const std::int32_t t : touched_triangles_)
        if (state_->triangles[t].state == CutTriangleState::vacant) state_->free_triangles.push(t);
    std::int32_t kept = 0;
    for (const std::int32_t v : new_vertices_) {
        if (state_->vertices[v].triangle < 0)
            state_->free_vertices.push(v);
        else
            new_vertices_[kept++] = v;
    }
    new_vertices_.resize(kept);
    ++state_->version;
}

void CutEditor::roll_back() {
    while (undo_triangles_.size() > 0) {
        const auto undo = undo_triangles_.pop();
        state_->triangles[undo.index] = undo.row;
    }
    while (undo_vertices_.size() > 0) {
        const auto undo = undo_vertices_.pop();
        state_->vertices[undo.index] = undo.row;
    }
    while (undo_roots_.size() > 0) {
        const auto undo = undo_roots_.pop();
        state_->roots[undo.index] = undo.row;
    }
    while (undo_fragments_.size() > 0) {
        const auto undo = undo_fragments_.pop();
        state_->fragments[undo.index] = undo.row;
    }
    state_->vertex_count = before_.vertices;
    state_->triangle_count = before_.triangles;
    state_->fragment_count = before_.fragments;
    state_->visible_count = before_.visible;
    state_->free_triangles.resize(before_.free_triangles);
    state_->free_vertices.resize(before_.free_vertices);
    state_->area_visible = before_.area_visible;
    state_->area_removed = before_.area_removed;
    ++state_->rolled_back;
    touched_triangles_.clear();
    touched_roots_.clear();
    new_vertices_.clear();
}

CutTriangle& CutEditor::edit_triangle(std::int32_t triangle) {
    CutTriangle& row = state_->triangles[triangle];
    if (triangle_stamp_[triangle] != stamp_) {
        triangle_stamp_[triangle] = stamp_;
        touched_triangles_.push(triangle);
        if (triangle < before_.triangles) undo_triangles_.push({triangle, row});
    }
    return row;
}

CutVertex& CutEditor::edit_vertex(std::int32_t vertex) {
    CutVertex& row = state_->vertices[vertex];
    if (vertex_stamp_[vertex] != stamp_) {
        vertex_stamp_[vertex] = stamp_;
        if (vertex < before_.vertices) undo_vertices_.push({vertex, row});
    }
    return row;
}

CutRoot& CutEditor::edit_root(std::int32_t root) {
    CutRoot& row = state_->roots[root];
    if (root_stamp_[root] != stamp_) {
        root_stamp_[root] = stamp_;
        touched_roots_.push(root);
        undo_roots_.push({root, row});
    }
    return row;
}

CutFragment& CutEditor::edit_fragment(std::int32_t fragment) {
    CutFragment& row = state_->fragments[fragment];
    if (fragment_stamp_[fragment] != stamp_) {
        fragment_stamp_[fragment] = stamp_;
        if (fragment < before_.fragments) undo_fragments_.push({fragment, row});
    }
    return row;
}

std::int32_t CutEditor::new_fragment(std::int32_t root, std::int32_t from) {
    if (state_->fragment_count == model_->capacity.fragments) {
        lacking_ = CutLimit::fragments;
        return -1;
    }
    const std::int32_t f = state_->fragment_count++;
    CutFragment& row = edit_fragment(f);
    row = CutFragment();
    row.root = root;
    row.from = from;
    row.next_of_root = state_->fragments[root].next_of_root;
    edit_fragment(root).next_of_root = f;  // fragment r is the first of root r
    return f;
}

bool CutEditor::has_room(std::int32_t vertices, std::int32_t triangles) {
    if (state_->free_vertices.size() + model_->capacity.vertices - state_->vertex_count < vertices)
        lacking_ = CutLimit::vertices;
    if (state_->free_triangles.size() + model_->capacity.triangles - state_->triangle_count < triangles)
        lacking_ = CutLimit::triangles;
    return lacking_ == CutLimit::none;
}

std::int32_t CutEditor::new_triangle() {
    const std::int32_t t =
        state_->free_triangles.size() > 0 ? state_->free_triangles.pop() : state_->triangle_count++;
    CutTriangle& row = edit_triangle(t);
    row = CutTriangle();
    row.attempt = state_->attempt;
    row.stroke = state_->stroke;
    return t;
}

std::int32_t CutEditor::new_vertex() {
    const std::int32_t v =
        state_->free_vertices.size() > 0 ? state_->free_vertices.pop() : state_->vertex_count++;
    edit_vertex(v) = CutVertex();
    new_vertices_.push(v);
    return v;
}

void CutEditor::show(std::int32_t triangle) {
    CutTriangle& row = edit_triangle(triangle);
    CutRoot& root = edit_root(row.root);
    row.state = CutTriangleState::visible;
    row.previous_in_root = -1;
    row.next_in_root = root.first_visible;
    if (root.first_visible >= 0) edit_triangle(root.first_visible).previous_in_root = triangle;
    root.first_visible = triangle;
    ++root.visible_count;
    ++state_->visible_count;
}

void CutEditor::hide(std::int32_t triangle, CutTriangleState as) {
    CutTriangle& row = edit_triangle(triangle);
    CutRoot& root = edit_root(row.root);
    if (row.previous_in_root >= 0)
        edit_triangle(row.previous_in_root).next_in_root = row.next_in_root;
    else
        root.first_visible = row.next_in_root;
    if (row.next_in_root >= 0) edit_triangle(row.next_in_root).previous_in_root = row.previous_in_root;
    row.next_in_root = row.previous_in_root = -1;
    --root.visible_count;
    --state_->visible_count;
    if (!made_now(triangle)) {
        row.state = as;
        return;
    }
    row.state = CutTriangleState::vacant;
    if (row.parent < 0) return;
    std::int32_t before = -1;
    for (std::int32_t child = state_->triangles[row.parent].first_child; child != triangle && child >= 0;
         child = state_->triangles[child].next_sibling)
        before = child;
    if (before >= 0)
        edit_triangle(before).next_sibling = row.next_sibling;
    else
        edit_triangle(row.parent).first_child = row.next_sibling;
    row.next_sibling = -1;
}

void CutEditor::add_child(std::int32_t parent, std::int32_t child) {
    if (parent < 0) return;
    CutTriangle& above = edit_triangle(parent);
    edit_triangle(child).next_sibling = above.first_child;
    above.first_child = child;
}

std::int32_t CutEditor::reshape(std::int32_t triangle) {
    if (made_now(triangle)) {
        edit_triangle(triangle);
        made_.push(triangle);
        return triangle;
    }
    const CutTriangle old = state_->triangles[triangle];
    hide(triangle, CutTriangleState::split);
    const std::int32_t t = new_triangle();
    CutTriangle& row = edit_triangle(t);
    row.vertices = old.vertices;
    row.neighbours = old.neighbours;
    row.root = old.root;
    row.fragment = old.fragment;
    row.share = old.share;
    row.parent = triangle;
    add_child(triangle, t);
    show(t);
    made_.push(t);
    return t;
}

std::int32_t CutEditor::sibling(std::int32_t triangle) {
    const std::int32_t t = new_triangle();
    const CutTriangle& like = state_->triangles[triangle];
    CutTriangle& row = edit_triangle(t);
    row.root = like.root;
    row.fragment = like.fragment;
    row.parent = like.parent;
    add_child(row.parent, t);
    show(t);
    made_.push(t);
    return t;
}

void CutEditor::link(std::int32_t triangle, int edge, std::int32_t neighbour) {
    edit_triangle(triangle).neighbours[static_cast<std::size_t>(edge)] = neighbour;
    if (neighbour < 0) return;
    const CutTriangle& row = state_->triangles[triangle];
    const int back = edge_of(state_->triangles[neighbour], vertex_at(row, edge + 1), vertex_at(row, edge));
    if (back >= 0) edit_triangle(neighbour).neighbours[static_cast<std::size_t>(back)] = triangle;
}

void CutEditor::settle(std::int32_t triangle) {
    for (const std::int32_t v : state_->triangles[triangle].vertices) {
        const std::int32_t known = state_->vertices[v].triangle;
        if (known < 0 || !visible(known) || corner_of(state_->triangles[known], v) < 0)
            edit_vertex(v).triangle = triangle;
    }
}

const CutList<std::int32_t>& CutEditor::fan(std::int32_t vertex, bool& closed) {
    fan_.clear();
    closed = false;
    const std::int32_t seed = state_->vertices[vertex].triangle;
    if (seed < 0) return fan_;
    const auto no_fan = [&]() -> const CutList<std::int32_t>& {
        fan_.clear();
        closed = false;
        return fan_;
    };
    // Clockwise to the border, or once around; each neighbour must refer back to the triangle it is reached
    // from.
    std::int32_t t = seed;
    const std::int32_t most = state_->visible_count + 1;
    for (std::int32_t turns = 0;; ++turns) {
        const CutTriangle& row = state_->triangles[t];
        const int i = corner_of(row, vertex);
        if (i < 0 || turns >= most || !fan_.push(t)) return no_fan();
        const std::int32_t next = neighbour_at(row, i);
        if (next < 0) break;
        const int j = corner_of(state_->triangles[next], vertex);
        if (j < 0 || neighbour_at(state_->triangles[next], j + 2) != t) return no_fan();
        t = next;
        closed = t == seed;
        if (closed) break;
    }
    // The seed is the first of a closed fan, and the last found of one that ends at a border.
    std::reverse(&fan_[closed ? 1 : 0], &fan_[0] + fan_.size());
    if (closed) return fan_;
    // From the seed to the other border.
    t = seed;
    for (;;) {
        const CutTriangle& row = state_->triangles[t];
        const std::int32_t next = neighbour_at(row, corner_of(row, vertex) + 2);
        if (next < 0) return fan_;
        const int j = corner_of(state_->triangles[next], vertex);
        if (j < 0 || neighbour_at(state_->triangles[next], j) != t || !fan_.push(next)) return no_fan();
        t = next;
    }
}

}  // namespace fulcrum
