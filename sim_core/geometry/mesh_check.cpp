// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {
namespace {

// A triangle whose height over longest edge is below this is a line or a point in double precision.
constexpr double zero_area_ratio = 1e-13;

struct DirectedEdge {
    std::int32_t low, high;
    std::int32_t triangle;
    bool rising;  // runs from low to high
};

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
    std::vector<DirectedEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t e = 0; e < 3; ++e) {
            const auto a = mesh.triangles[t][e], b = mesh.triangles[t][(e + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(t), a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const DirectedEdge& p, const DirectedEdge& q) {
        if (p.low != q.low) return p.low < q.low;
        if (p.high != q.high) return p.high < q.high;
        return p.triangle < q.triangle;
    });
    return edges;
}

void name_triangle(MeshReport& report, std::int32_t triangle) {
    if (report.first_bad_triangle < 0) report.first_bad_triangle = triangle;
}

void name_vertex(MeshReport& report, std::int32_t vertex) {
    if (report.first_bad_vertex < 0) report.first_bad_vertex = vertex;
}

// Triangles reached from the first one around the vertex by crossing edges that hold the vertex.
std::int32_t fan_size(const TriangleMesh& mesh, const MeshAdjacency& adjacency, std::int32_t vertex) {
    const auto around = adjacency.triangles_of(vertex);
    const std::int32_t start = around[0];
    std::int32_t reached = 1;
    for (int direction = 0; direction < 2; ++direction) {
        std::int32_t from = -1, here = start;
        for (;;) {
            std::int32_t to = -1;
            int choice = 0;
            for (std::size_t e = 0; e < 3; ++e) {
                const Triangle& triangle = mesh.triangles[static_cast<std::size_t>(here)];
                if (triangle[e] != vertex && triangle[(e + 1) % 3] != vertex) continue;
                const auto other = adjacency.triangle_neighbours[3 * static_cast<std::size_t>(here) + e];
                if (from < 0 ? choice++ == direction : other != from) to = other;
            }
            if (to < 0 || to == start || reached >= around.count) break;
            from = here;
            here = to;
            ++reached;
        }
        if (reached >= around.count) break;
    }
    return reached;
}

void check_triangles(const TriangleMesh& mesh, MeshReport& report) {
    const auto vertex_count = static_cast<std::int32_t>(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (mesh.vertices[v].allFinite()) continue;
        report.finite = false;
        name_vertex(report, static_cast<std::int32_t>(v));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const auto inside = [vertex_count](std::int32_t v) { return v >= 0 && v < vertex_count; };
        if (!inside(a) || !inside(b) || !inside(c) || a == b || b == c || c == a) {
            report.indices_valid = false;
            name_triangle(report, static_cast<std::int32_t>(t));
            continue;
        }
        const Vector3 &p = mesh.vertices[static_cast<std::size_t>(a)],
                      &q = mesh.vertices[static_cast<std::size_t>(b)],
                      &r = mesh.vertices[static_cast<std::size_t>(c)];
        const double longest =
            std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
        if (!(area_vector(p, q, r).norm() > zero_area_ratio * longest)) {
            report.no_zero_area = false;
            name_triangle(report, static_cast<std::int32_t>(t));
        }
    }
}

std::int32_t check_edges(const std::vector<DirectedEdge>& edges, MeshReport& report) {
    std::int32_t count = 0;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
            ++end;
        ++count;
        if (end - i != 2) {
            report.closed = false;
            if (end - i > 2) report.manifold_edges = false;
            name_triangle(report, edges[i].triangle);
        } else if (edges[i].rising == edges[i + 1].rising) {
            report.oriented = false;
            name_triangle(report, edges[i].triangle);
        }
        i = end;
    }
    return count;
}

int count_components(const TriangleMesh& mesh) {
    std::vector<std::int32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](std::int32_t v) {
        while (parent[static_cast<std::size_t>(v)] != v) {
            auto& up = parent[static_cast<std::size_t>(v)];
            up = parent[static_cast<std::size_t>(up)];
            v = up;
        }
        return v;
    };
    for (const auto& triangle : mesh.triangles) {
        const auto a = root(triangle[0]);
        parent[static_cast<std::size_t>(root(triangle[1]))] = a;
        parent[static_cast<std::size_t>(root(triangle[2]))] = a;
    }
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const auto& triangle : mesh.triangles) used[static_cast<std::size_t>(root(triangle[0]))] = 1;
    return static_cast<int>(std::count(used.begin(), used.end(), 1));
}

}  // namespace

MeshReport check_mesh(const TriangleMesh& mesh) {
    MeshReport report;
    check_triangles(mesh, report);
    if (!report.indices_valid) {
        report.closed = report.manifold_edges = report.manifold_vertices = report.oriented = false;
        return report;
    }
    const auto edge_count = check_edges(sorted_edges(mesh), report);
    const MeshAdjacency adjacency = build_adjacency(mesh);
    std::int32_t used = 0;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(mesh.vertices.size()); ++v) {
        const auto around = adjacency.triangles_of(v);
        if (around.count == 0) {
            report.no_stray_vertex = false;
            continue;
        }
        ++used;
        if (fan_size(mesh, adjacency, v) != around.count) {
            report.manifold_vertices = false;
            name_vertex(report, v);
        }
    }
    if (mesh.triangles.empty()) report.closed = false;
    report.euler_characteristic = used - edge_count + static_cast<int>(mesh.triangles.size());
    report.components = count_components(mesh);
    if (report.finite) report.volume = enclosed_volume(mesh.vertices, mesh.triangles);
    return report;
}

std::string MeshReport::complaint() const {
    const auto triangle = " (triangle " + std::to_string(first_bad_triangle) + ")";
    const auto vertex = " (vertex " + std::to_string(first_bad_vertex) + ")";
    if (!indices_valid) return "a triangle uses a vertex twice or one that does not exist" + triangle;
    if (!finite) return "a coordinate is not a finite number" + vertex;
    if (!no_zero_area) return "a triangle has no area" + triangle;
    if (!manifold_edges) return "an edge has more than two triangles" + triangle;
    if (!closed)
        return first_bad_triangle < 0 ? "the mesh has no triangles" : "the surface has a hole" + triangle;
    if (!oriented) return "two neighbouring triangles have opposite orientation" + triangle;
    if (!manifold_vertices) return "two separate triangle fans share one vertex" + vertex;
    return {};
}

}  // namespace fulcrum
