// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/patch_surface.h"

#include <algorithm>

#include "sim_core/bowel/bowel_skin.h"

namespace fulcrum {
namespace {

// Rotation for a rotation vector (rad), by Cayley's formula: an exact rotation without a sine, correct to
// third order of the angle.
Matrix3 small_rotation(const Vector3& turn) {
    const Vector3 h = 0.5 * turn;
    Matrix3 cross;
    cross << 0, -h.z(), h.y(), h.z(), 0, -h.x(), -h.y(), h.x(), 0;
    return Matrix3::Identity() + (2.0 / (1.0 + h.squaredNorm())) * (cross + cross * cross);
}

std::int32_t find(const std::int32_t* begin, std::int32_t count, std::int32_t id) {
    const std::int32_t* place = std::lower_bound(begin, begin + count, id);
    return place != begin + count && *place == id ? static_cast<std::int32_t>(place - begin) : -1;
}

}  // namespace

std::int32_t SurfacePatch::find_triangle(std::int32_t id) const {
    return find(triangle_id.data(), triangle_count, id);
}
std::int32_t SurfacePatch::find_vertex(std::int32_t id) const {
    return find(vertex_id.data(), vertex_count, id);
}

PatchSurface::PatchSurface(const SurfacePatch& patch, double seconds, ToolContactScratch& scratch)
    : patch_(patch), scratch_(scratch) {
    for (std::size_t r = 0; r < static_cast<std::size_t>(patch.ring_count); ++r) {
        const RingMotion& ring = patch.rings[r];
        scratch.rings[r].position = ring.frame.position + seconds * ring.velocity;
        scratch.rings[r].rotation = small_rotation(seconds * ring.angular_velocity) * ring.frame.rotation;
    }
    if (++scratch.stamp == 0) {  // wrapped around: old stamps could appear current
        scratch.position_stamp.fill(0);
        scratch.normal_stamp.fill(0);
        scratch.stamp = 1;
    }
}

const Vector3& PatchSurface::position(std::int32_t vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    if (scratch_.position_stamp[v] != scratch_.stamp) {
        scratch_.position_stamp[v] = scratch_.stamp;
        scratch_.positions[v] = skin_vertex(patch_.rows[v], scratch_.rings);
    }
    return scratch_.positions[v];
}

const Vector3& PatchSurface::normal(std::int32_t vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    if (scratch_.normal_stamp[v] != scratch_.stamp) {
        scratch_.normal_stamp[v] = scratch_.stamp;
        Vector3 sum = Vector3::Zero();
        for (auto k = static_cast<std::size_t>(patch_.vertex_triangle_offsets[v]);
             k < static_cast<std::size_t>(patch_.vertex_triangle_offsets[v + 1]); ++k) {
            const Triangle& t = patch_.triangles[static_cast<std::size_t>(patch_.vertex_triangles[k])];
            const Vector3& a = position(t[0]);
            sum += (position(t[1]) - a).cross(position(t[2]) - a);
        }
        const double length = sum.norm();
        scratch_.normals[v] = length > 0 ? Vector3(sum / length) : Vector3(Vector3::Zero());
    }
    return scratch_.normals[v];
}

Vector3 PatchSurface::velocity(std::int32_t vertex) const {
    return skin_velocity(patch_.rows[static_cast<std::size_t>(vertex)], patch_.rings.data());
}

void PatchSurface::skin_neighbourhood(std::int32_t vertex) {
    const SurfaceView surface = view();
    position(vertex);
    for (const std::int32_t first : surface.neighbours_of(vertex)) {
        position(first);
        for (const std::int32_t second : surface.neighbours_of(first)) position(second);
    }
}

SurfaceView PatchSurface::view() const {
    SurfaceView surface;
    surface.positions = scratch_.positions.data();
    surface.vertex_count = patch_.vertex_count;
    surface.triangles = patch_.triangles.data();
    surface.triangle_count = patch_.triangle_count;
    surface.triangle_neighbours = patch_.triangle_neighbours.data();
    surface.vertex_triangle_offsets = patch_.vertex_triangle_offsets.data();
    surface.vertex_triangles = patch_.vertex_triangles.data();
    surface.vertex_neighbour_offsets = patch_.vertex_neighbour_offsets.data();
    surface.vertex_neighbours = patch_.vertex_neighbours.data();
    return surface;
}

}  // namespace fulcrum
