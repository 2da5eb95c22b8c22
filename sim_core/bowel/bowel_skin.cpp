// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/bowel_skin.h"

#include <algorithm>

#include "sim_core/bowel/ring_windows.h"

namespace fulcrum {
namespace {

std::vector<Vector3> rest_rings(const Cage& cage) {
    std::vector<RingFrame> frames;
    for (const double s : cage.arc_lengths) frames.push_back(rest_frame(s));
    std::vector<Vector3> vertices = cage_vertices(cage, frames.data());
    vertices.resize(vertices.size() - 2);  // the windows add the cap centres themselves
    return vertices;
}

}  // namespace

SkinBinder::SkinBinder(const Cage& cage) : cage_(&cage), windows_(rest_rings(cage), ring_size, 1) {}

int SkinBinder::gap_of(const Vector3& point) const {
    return windows_.gap_of(point);
}

SkinRow SkinBinder::bind(int gap, const Vector3& point) {
    windows_.weights(gap, point, weights_);
    SkinRow row;
    row.first_ring = std::min(weights_.first, cage_->rings() - skin_rings);
    for (int r = 0; r < weights_.rings; ++r) {
        const auto ring = static_cast<std::size_t>(weights_.first + r);
        const int j = weights_.first + r - row.first_ring;
        for (std::size_t k = 0; k < ring_size; ++k) {
            const double w = weights_.weight[static_cast<std::size_t>(r) * ring_size + k];
            row.weight[j] += w;
            row.offset[j] += w * cage_->templates[ring][k];
        }
    }
    return row;
}

BowelSkin::BowelSkin(TriangleMesh surface, Cage cage) : rest_(std::move(surface)), cage_(std::move(cage)) {
    adjacency_ = build_adjacency(rest_);
    rest_normals_ = vertex_normals(rest_);
    vertex_areas_.assign(rest_.vertices.size(), 0.0);
    for (const auto& triangle : rest_.triangles) {
        const double area = triangle_area(rest_.vertices[static_cast<std::size_t>(triangle[0])],
                                          rest_.vertices[static_cast<std::size_t>(triangle[1])],
                                          rest_.vertices[static_cast<std::size_t>(triangle[2])]);
        for (const auto v : triangle) vertex_areas_[static_cast<std::size_t>(v)] += area / 3.0;
    }
    SkinBinder binder(cage_);
    rows_.reserve(rest_.vertices.size());
    by_ring_offsets_.assign(static_cast<std::size_t>(rings()) + 1, 0);
    for (const auto& vertex : rest_.vertices) {
        rows_.push_back(binder.bind(binder.gap_of(vertex), vertex));
        ++by_ring_offsets_[static_cast<std::size_t>(rows_.back().first_ring) + 1];
    }
    for (std::size_t r = 1; r < by_ring_offsets_.size(); ++r) by_ring_offsets_[r] += by_ring_offsets_[r - 1];
    by_ring_.resize(rows_.size());
    std::vector<std::int32_t> next(by_ring_offsets_.begin(), by_ring_offsets_.end() - 1);
    for (std::size_t v = 0; v < rows_.size(); ++v) {
        by_ring_[static_cast<std::size_t>(next[static_cast<std::size_t>(rows_[v].first_ring)]++)] =
            static_cast<std::int32_t>(v);
    }
}

std::size_t BowelSkin::bytes() const {
    const auto size_of = [](const auto& list) { return list.size() * sizeof(list[0]); };
    return size_of(rest_.vertices) + size_of(rest_.triangles) + size_of(rest_.texture_coordinates) +
           size_of(adjacency_.triangle_neighbours) + size_of(adjacency_.vertex_triangle_offsets) +
           size_of(adjacency_.vertex_triangles) + size_of(adjacency_.vertex_neighbour_offsets) +
           size_of(adjacency_.vertex_neighbours) + size_of(rows_) + size_of(rest_normals_) +
           size_of(vertex_areas_) + size_of(by_ring_) + size_of(by_ring_offsets_) + size_of(cage_.templates) +
           size_of(cage_.arc_lengths);
}

void skin_all(const BowelSkin& skin, const RingFrame* frames, Vector3* positions) {
    const auto& rows = skin.rows();
    for (std::size_t v = 0; v < rows.size(); ++v) positions[v] = skin_vertex(rows[v], frames);
}

Vector3 skin_velocity(const SkinRow& row, const RingMotion* rings) {
    Vector3 velocity = Vector3::Zero();
    for (int j = 0; j < skin_rings; ++j) {
        const RingMotion& ring = rings[row.first_ring + j];
        velocity +=
            row.weight[j] * ring.velocity + ring.angular_velocity.cross(ring.frame.rotation * row.offset[j]);
    }
    return velocity;
}

void add_ring_wrenches(const SkinRow& row, const RingFrame* frames, const Vector3& force,
                       RingWrench* wrenches) {
    for (int j = 0; j < skin_rings; ++j) {
        const int r = row.first_ring + j;
        wrenches[r].force += row.weight[j] * force;
        wrenches[r].moment += (frames[r].rotation * row.offset[j]).cross(force);
    }
}

}  // namespace fulcrum
