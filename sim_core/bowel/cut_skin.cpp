// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/cut_skin.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/numerics/state_hash.h"

namespace fulcrum {
namespace {

constexpr int reach_rings = 5;                // rings on each side of the blade that a step may reach
constexpr int most_spanned = 4 * skin_rings;  // rings between the corners of a root

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

CutCapacity room_for(const TriangleMesh& mesh, std::int32_t steps) {
    CutCapacity room = CutMesh::capacity_for(mesh, steps);
    // Most of a bowel is never cut: the tables hold only what cut steps add to the mesh itself.
    room.vertices -= 3 * static_cast<std::int32_t>(mesh.vertices.size());
    room.triangles -= 5 * static_cast<std::int32_t>(mesh.triangles.size());
    room.fragments -= 2 * static_cast<std::int32_t>(mesh.triangles.size());
    return room;
}

}  // namespace

SkinRow interpolate_rows(const SkinRow& a, const SkinRow& b, const SkinRow& c, const Vector3& barycentric,
                         const std::vector<double>& arc_lengths) {
    const SkinRow* const corner[3] = {&a, &b, &c};
    std::int32_t first = std::min({a.first_ring, b.first_ring, c.first_ring});
    std::int32_t last = std::max({a.first_ring, b.first_ring, c.first_ring}) + skin_rings - 1;
    double weight[most_spanned] = {};
    Vector3 offset[most_spanned];
    for (Vector3& one : offset) one.setZero();
    assert(last - first < most_spanned);
    const std::int32_t base = first;
    for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < skin_rings; ++j) {
            const std::int32_t r = corner[k]->first_ring + j - base;
            weight[r] += barycentric[k] * corner[k]->weight[j];
            offset[r] += barycentric[k] * corner[k]->offset[j];
        }
    }
    while (last - first >= skin_rings) {
        const bool lower = std::abs(weight[first - base]) <= std::abs(weight[last - base]);
        const std::int32_t from = lower ? first++ : last--, to = lower ? from + 1 : from - 1;
        weight[to - base] += weight[from - base];
        offset[to - base] += offset[from - base] + weight[from - base] *
                                                       (arc_lengths[at(from)] - arc_lengths[at(to)]) *
                                                       Vector3::UnitZ();
    }
    SkinRow row;
    row.first_ring = first;
    for (int j = 0; j < skin_rings; ++j) {
        row.weight[j] = weight[first - base + j];
        row.offset[j] = offset[first - base + j];
    }
    return row;
}

CutSkin::CutSkin(const BowelSkin& skin, const std::vector<std::int32_t>& held, std::int32_t steps)
    : skin_(skin),
      surface_(skin.rest(), held, room_for(skin.rest(), steps)),
      rows_(at(surface_.capacity().vertices) - skin.rows().size()),
      loose_of_(at(surface_.capacity().vertices), 0),
      positions_(at(surface_.capacity().vertices), Vector3::Zero()),
      marks_(at(surface_.capacity().triangles), 0) {
    queue_.reserve(at(surface_.capacity().triangles));
}

void CutSkin::place_all(const RingFrame* frames, Vector3* positions) const {
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) positions[v] = position(v, frames);
}

void CutSkin::place_near(std::int32_t root, const RingFrame* frames) {
    const std::int32_t middle = skin_.rows()[at(skin_.rest().triangles[at(root)][0])].first_ring;
    const std::int32_t from = std::max(0, middle - reach_rings);
    const std::int32_t to = std::min(skin_.rings() - 1, middle + reach_rings);
    const auto& offsets = skin_.by_ring_offsets();
    for (std::int32_t k = offsets[at(from)]; k < offsets[at(to) + 1]; ++k) {
        const std::int32_t v = skin_.by_ring()[at(k)];
        positions_[at(v)] = position(v, frames);
    }
    for (auto v = static_cast<std::int32_t>(skin_.rows().size()); v < surface_.vertex_count(); ++v) {
        const std::int32_t ring = row(v).first_ring;
        if (ring >= from && ring <= to && surface_.vertex(v).triangle >= 0)
            positions_[at(v)] = position(v, frames);
    }
}

void CutSkin::bind_new() {
    const auto own = static_cast<std::int32_t>(skin_.rows().size());
    for (const std::int32_t v : surface_.new_vertices()) {
        if (v < own) continue;
        const CutVertex& vertex = surface_.vertex(v);
        const Triangle& corner = skin_.rest().triangles[at(vertex.root)];
        rows_[at(v - own)] =
            interpolate_rows(skin_.rows()[at(corner[0])], skin_.rows()[at(corner[1])],
                             skin_.rows()[at(corner[2])], vertex.barycentric, skin_.cage().arc_lengths);
        loose_of_[at(v)] = 0;
    }
    // What is cut off a falling piece continues to fall with it.
    for (const std::int32_t root : surface_.touched_roots()) {
        for (std::int32_t t = surface_.root(root).first_visible; t >= 0;
             t = surface_.triangle(t).next_in_root) {
            const Triangle& corner = surface_.triangle(t).vertices;
            const std::uint8_t piece =
                std::max({loose_of_[at(corner[0])], loose_of_[at(corner[1])], loose_of_[at(corner[2])]});
            for (const std::int32_t v : corner) loose_of_[at(v)] = piece;
        }
    }
    note_commit();
}

void CutSkin::note_commit() {
    StateHash hash;
    hash.add(history_);
    for (const std::int32_t root : surface_.touched_roots()) {
        hash.add(static_cast<std::int64_t>(root));
        for (std::int32_t t = surface_.root(root).first_visible; t >= 0;
             t = surface_.triangle(t).next_in_root) {
            const CutTriangle& row = surface_.triangle(t);
            for (const std::int32_t v : row.vertices) hash.add(static_cast<std::int64_t>(v));
            hash.add(row.share);
        }
    }
    for (const std::int32_t v : surface_.new_vertices()) {
        hash.add(static_cast<std::int64_t>(v));
        hash.add(surface_.vertex(v).barycentric);
    }
    history_ = hash.value();
}

CutSkin::Report CutSkin::cut(const BladeStep& blade, const RingFrame* frames) {
    Report report;
    if (blade.root < 0 || blade.root >= surface_.root_count()) return report;
    place_near(blade.root, frames);
    report.cut = surface_.cut(blade, positions_.data());
    if (report.cut.outcome != CutOutcome::cut) return report;
    bind_new();
    std::int32_t firsts[most_loose];
    const std::int32_t found = std::min<std::int32_t>(most_loose, surface_.find_parted(firsts, most_loose));
    for (std::int32_t k = 0; k < found; ++k) {
        if (loose_of_triangle(firsts[k]) == 0) let_fall(firsts[k], report);
    }
    return report;
}

void CutSkin::let_fall(std::int32_t first, Report& report) {
    int piece = 0;
    while (piece < most_loose && loose_[static_cast<std::size_t>(piece)].falls) ++piece;
    const bool room = piece < most_loose;
    if (!room) piece = most_loose - 1;  // joins the last falling piece
    Loose& loose = loose_[static_cast<std::size_t>(piece)];
    if (room) loose = Loose();
    loose.falls = true;
    // All triangles connected to it.
    double area = 0;
    queue_.clear();
    const auto take = [&](std::int32_t t) {
        const CutTriangle& row = surface_.triangle(t);
        area += row.share * surface_.model().areas[at(row.root)];
        for (const std::int32_t v : row.vertices) loose_of_[at(v)] = static_cast<std::uint8_t>(piece + 1);
        queue_.push_back(t);
    };
    const std::uint32_t mark = ++mark_;
    marks_[at(first)] = mark;
    take(first);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        for (const std::int32_t n : surface_.triangle(queue_[head]).neighbours) {
            if (n < 0 || marks_[at(n)] == mark) continue;
            marks_[at(n)] = mark;
            take(n);
        }
    }
    loose.area += area;
    ++fallen_;
    ++report.parted;
    report.parted_area += area;
}

double CutSkin::fall(const Vector3& gravity, double dt) {
    const double before = surface_.area_removed();
    for (int k = 0; k < most_loose; ++k) {
        Loose& loose = loose_[static_cast<std::size_t>(k)];
        if (!loose.falls) continue;
        loose.velocity += dt * gravity;
        loose.displacement += dt * loose.velocity;
        loose.age += dt;
        if (loose.age > falling_time) remove(k);
    }
    return surface_.area_removed() - before;
}

void CutSkin::remove(int piece) {
    // It may have been cut while it fell: each round removes one of its parts.
    for (bool more = true; more;) {
        more = false;
        const std::int32_t pieces = surface_.find_pieces();
        for (std::int32_t p = 0; p < pieces && !more; ++p) {
            if (loose_of_triangle(surface_.piece(p).first) != piece + 1) continue;
            if (surface_.remove_piece(p, positions_.data()).outcome != CutOutcome::cut)
                return;  // starts over with the current list
            bind_new();
            more = true;
        }
    }
    loose_[static_cast<std::size_t>(piece)] = Loose();
}

CutSkin::State CutSkin::save() const {
    State state;
    state.surface = surface_.state();
    state.loose = loose_;
    state.loose_of = loose_of_;
    state.fallen = fallen_;
    state.history = history_;
    return state;
}

void CutSkin::restore(const State& state) {
    surface_.restore(state.surface);
    loose_ = state.loose;
    loose_of_ = state.loose_of;
    fallen_ = state.fallen;
    history_ = state.history;
    const auto own = static_cast<std::int32_t>(skin_.rows().size());
    for (std::int32_t v = own; v < surface_.vertex_count(); ++v) {
        const CutVertex& vertex = surface_.vertex(v);
        if (vertex.root < 0) continue;
        const Triangle& corner = skin_.rest().triangles[at(vertex.root)];
        rows_[at(v - own)] =
            interpolate_rows(skin_.rows()[at(corner[0])], skin_.rows()[at(corner[1])],
                             skin_.rows()[at(corner[2])], vertex.barycentric, skin_.cage().arc_lengths);
    }
}

std::uint64_t CutSkin::digest() const {
    StateHash hash;
    hash.add(history_);
    hash.add(surface_.version());
    hash.add(surface_.area_visible());
    hash.add(surface_.area_removed());
    for (const Loose& loose : loose_) {
        if (loose.falls) hash.add(loose.displacement);
    }
    return hash.value();
}

std::size_t CutSkin::bytes() const {
    return static_cast<std::size_t>(surface_.bytes()) + rows_.capacity() * sizeof(SkinRow) +
           loose_of_.capacity() + positions_.capacity() * sizeof(Vector3) +
           queue_.capacity() * sizeof(std::int32_t) + marks_.capacity() * sizeof(std::uint32_t);
}

}  // namespace fulcrum
