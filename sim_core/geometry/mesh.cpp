// SPDX-License-Identifier: Apache-2.0
#include "sim_core/geometry/mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

struct HalfEdge {
    std::uint64_t key;   // smaller vertex in the high half, larger in the low half
    std::int32_t place;  // 3 * triangle + edge
    bool operator<(const HalfEdge& other) const {
        return key != other.key ? key < other.key : place < other.place;
    }
};

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
    const auto low = static_cast<std::uint64_t>(std::min(a, b)),
               high = static_cast<std::uint64_t>(std::max(a, b));
    return (low << 32) | high;
}

void to_offsets(std::vector<std::int32_t>& counts) {
    std::int32_t sum = 0;
    for (auto& count : counts) {
        const auto here = count;
        count = sum;
        sum += here;
    }
}

}  // namespace

IndexSpan MeshAdjacency::triangles_of(std::int32_t vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return {vertex_triangles.data() + vertex_triangle_offsets[v],
            vertex_triangle_offsets[v + 1] - vertex_triangle_offsets[v]};
}

IndexSpan MeshAdjacency::neighbours_of(std::int32_t vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return {vertex_neighbours.data() + vertex_neighbour_offsets[v],
            vertex_neighbour_offsets[v + 1] - vertex_neighbour_offsets[v]};
}

MeshAdjacency build_adjacency(const TriangleMesh& mesh) {
    const auto vertex_count = mesh.vertices.size();
    const auto triangle_count = mesh.triangles.size();
    MeshAdjacency result;
    result.triangle_neighbours.assign(3 * triangle_count, -1);
    result.vertex_triangle_offsets.assign(vertex_count + 1, 0);
    result.vertex_neighbour_offsets.assign(vertex_count + 1, 0);

    std::vector<HalfEdge> edges;
    edges.reserve(3 * triangle_count);
    for (std::size_t t = 0; t < triangle_count; ++t) {
        const Triangle& triangle = mesh.triangles[t];
        for (std::size_t e = 0; e < 3; ++e) {
            const auto a = triangle[e], b = triangle[(e + 1) % 3];
            if (a < 0 || static_cast<std::size_t>(a) >= vertex_count) {
                throw InputError(
                    "mesh", "triangle " + std::to_string(t),
                    "vertex " + std::to_string(a) + " does not exist",
                    "use vertices 0 to " + std::to_string(static_cast<std::int64_t>(vertex_count) - 1));
            }
            edges.push_back({edge_key(a, b), static_cast<std::int32_t>(3 * t + e)});
            ++result.vertex_triangle_offsets[static_cast<std::size_t>(a)];
        }
    }
    to_offsets(result.vertex_triangle_offsets);
    result.vertex_triangles.resize(3 * triangle_count);
    std::vector<std::int32_t> next(result.vertex_triangle_offsets.begin(),
                                   result.vertex_triangle_offsets.end() - 1);
    for (std::size_t t = 0; t < triangle_count; ++t) {
        for (const auto v : mesh.triangles[t]) {
            result.vertex_triangles[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] =
                static_cast<std::int32_t>(t);
        }
    }

    std::sort(edges.begin(), edges.end());
    std::vector<std::uint64_t> unique;
    unique.reserve(edges.size() / 2 + 1);
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].key == edges[i].key) ++end;
        if (end - i >= 2) {
            const auto p = edges[i].place, q = edges[i + 1].place;
            result.triangle_neighbours[static_cast<std::size_t>(p)] = q / 3;
            result.triangle_neighbours[static_cast<std::size_t>(q)] = p / 3;
        }
        if ((edges[i].key >> 32) != (edges[i].key & 0xffffffffu)) unique.push_back(edges[i].key);
        i = end;
    }
    // Sorted by (smaller, larger), so each vertex meets its smaller neighbours first and every row is
    // ascending.
    for (const auto key : unique) {
        ++result.vertex_neighbour_offsets[key >> 32];
        ++result.vertex_neighbour_offsets[key & 0xffffffffu];
    }
    to_offsets(result.vertex_neighbour_offsets);
    result.vertex_neighbours.resize(2 * unique.size());
    next.assign(result.vertex_neighbour_offsets.begin(), result.vertex_neighbour_offsets.end() - 1);
    for (const auto key : unique) {
        const auto low = static_cast<std::int32_t>(key >> 32),
                   high = static_cast<std::int32_t>(key & 0xffffffffu);
        result.vertex_neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(low)]++)] = high;
        result.vertex_neighbours[static_cast<std::size_t>(next[static_cast<std::size_t>(high)]++)] = low;
    }
    return result;
}

SurfaceView view_of(const TriangleMesh& mesh, const MeshAdjacency& adjacency, const Vector3* positions) {
    SurfaceView view;
    view.positions = positions != nullptr ? positions : mesh.vertices.data();
    view.vertex_count = static_cast<std::int32_t>(mesh.vertices.size());
    view.triangles = mesh.triangles.data();
    view.triangle_count = static_cast<std::int32_t>(mesh.triangles.size());
    view.triangle_neighbours = adjacency.triangle_neighbours.data();
    view.vertex_triangle_offsets = adjacency.vertex_triangle_offsets.data();
    view.vertex_triangles = adjacency.vertex_triangles.data();
    view.vertex_neighbour_offsets = adjacency.vertex_neighbour_offsets.data();
    view.vertex_neighbours = adjacency.vertex_neighbours.data();
    return view;
}

Vector3 area_vector(const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b - a).cross(c - a);
}

double triangle_area(const Vector3& a, const Vector3& b, const Vector3& c) {
    return 0.5 * area_vector(a, b, c).norm();
}

Vector3 vertex_normal(const SurfaceView& surface, std::int32_t vertex) {
    Vector3 sum = Vector3::Zero();
    for (const auto t : surface.triangles_of(vertex)) {
        const Triangle& triangle = surface.triangles[t];
        sum += area_vector(surface.positions[triangle[0]], surface.positions[triangle[1]],
                           surface.positions[triangle[2]]);
    }
    const double length = sum.norm();
    return length > 0.0 ? Vector3(sum / length) : Vector3(Vector3::Zero());
}

double mean_triangle_area(const SurfaceView& surface, std::int32_t vertex) {
    const auto around = surface.triangles_of(vertex);
    double sum = 0.0;
    for (const auto t : around) {
        const Triangle& triangle = surface.triangles[t];
        sum += triangle_area(surface.positions[triangle[0]], surface.positions[triangle[1]],
                             surface.positions[triangle[2]]);
    }
    return around.count > 0 ? sum / around.count : 0.0;
}

double mean_edge_length(const SurfaceView& surface, std::int32_t vertex) {
    const auto around = surface.neighbours_of(vertex);
    double sum = 0.0;
    for (const auto v : around) sum += (surface.positions[v] - surface.positions[vertex]).norm();
    return around.count > 0 ? sum / around.count : 0.0;
}

std::vector<Vector3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Vector3> normals(mesh.vertices.size(), Vector3::Zero());
    for (const auto& triangle : mesh.triangles) {
        const auto a = static_cast<std::size_t>(triangle[0]), b = static_cast<std::size_t>(triangle[1]),
                   c = static_cast<std::size_t>(triangle[2]);
        const Vector3 area = area_vector(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
        normals[a] += area;
        normals[b] += area;
        normals[c] += area;
    }
    for (auto& normal : normals) {
        const double length = normal.norm();
        if (length > 0.0) normal /= length;
    }
    return normals;
}

double enclosed_volume(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles) {
    if (vertices.empty()) return 0.0;
    const Vector3& origin =
        vertices.front();  // a point close to the mesh: less cancellation than with the frame's origin
    double sum = 0.0;
    for (const auto& triangle : triangles) {
        const Vector3 a = vertices[static_cast<std::size_t>(triangle[0])] - origin;
        const Vector3 b = vertices[static_cast<std::size_t>(triangle[1])] - origin;
        const Vector3 c = vertices[static_cast<std::size_t>(triangle[2])] - origin;
        sum += a.dot(b.cross(c));
    }
    return sum / 6.0;
}

double surface_area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& triangle : mesh.triangles) {
        sum += triangle_area(mesh.vertices[static_cast<std::size_t>(triangle[0])],
                             mesh.vertices[static_cast<std::size_t>(triangle[1])],
                             mesh.vertices[static_cast<std::size_t>(triangle[2])]);
    }
    return sum;
}

}  // namespace fulcrum
