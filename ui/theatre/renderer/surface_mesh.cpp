// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/surface_mesh.h"

#include <array>
#include <cmath>
#include <map>

namespace fulcrum::ui {
namespace {

// Weight below which a plane does not show in the wall's program (the same number there).
constexpr double plane_threshold = 0.52;

void add_coordinates(SurfaceMesh& surface, double u, double v) {
    surface.coordinates.push_back(static_cast<float>(u));
    surface.coordinates.push_back(static_cast<float>(v));
}

}  // namespace

SurfaceMesh split_seam(const TriangleMesh& mesh) {
    SurfaceMesh surface;
    surface.base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& uv : mesh.texture_coordinates) add_coordinates(surface, uv.x(), uv.y());
    std::map<std::int32_t, std::uint32_t> copies;
    for (const Triangle& triangle : mesh.triangles) {
        double low = 1e9, high = -1e9;
        for (const auto vertex : triangle) {
            const double u = mesh.texture_coordinates[static_cast<std::size_t>(vertex)].x();
            low = std::min(low, u);
            high = std::max(high, u);
        }
        for (const auto vertex : triangle) {
            const auto& uv = mesh.texture_coordinates[static_cast<std::size_t>(vertex)];
            if (high - low <= 0.5 || uv.x() > 0.5) {
                surface.indices.push_back(static_cast<std::uint32_t>(vertex));
                continue;
            }
            const auto [copy, fresh] = copies.emplace(vertex, static_cast<std::uint32_t>(surface.vertices()));
            if (fresh) {
                surface.source.push_back(static_cast<std::uint32_t>(vertex));
                add_coordinates(surface, uv.x() + 1, uv.y());
            }
            surface.indices.push_back(copy->second);
        }
    }
    surface.blended_from = surface.indices.size();
    return surface;
}

SurfaceMesh split_by_plane(const TriangleMesh& mesh, double tile) {
    SurfaceMesh surface;
    surface.base = static_cast<std::uint32_t>(mesh.vertices.size());
    surface.coordinates.assign(2 * mesh.vertices.size(), 0.0F);
    const std::vector<Vector3> normals = vertex_normals(mesh);
    std::vector<int> own_plane(mesh.vertices.size(), -1);
    std::map<std::pair<std::int32_t, int>, std::uint32_t> copies;
    std::vector<std::uint32_t> blended;
    for (const Triangle& triangle : mesh.triangles) {
        int plane = -2;
        for (const auto vertex : triangle) {
            const Vector3& n = normals[static_cast<std::size_t>(vertex)];
            int clear = -1, seen = 0;
            for (int k = 0; k < 3; ++k) {
                if (std::abs(n[k]) <= plane_threshold) continue;
                clear = k;
                ++seen;
            }
            if (seen != 1) clear = -1;
            plane = plane == -2 || plane == clear ? clear : -1;
        }
        if (plane < 0) {
            for (const auto vertex : triangle) blended.push_back(static_cast<std::uint32_t>(vertex));
            continue;
        }
        for (const auto vertex : triangle) {
            const auto v = static_cast<std::size_t>(vertex);
            const Vector3& p = mesh.vertices[v];
            const double s = p[(plane + 1) % 3] / tile, t = p[(plane + 2) % 3] / tile;
            if (own_plane[v] < 0) {
                own_plane[v] = plane;
                surface.coordinates[2 * v] = static_cast<float>(s);
                surface.coordinates[2 * v + 1] = static_cast<float>(t);
            }
            if (own_plane[v] == plane) {
                surface.indices.push_back(static_cast<std::uint32_t>(vertex));
                continue;
            }
            const auto [copy, fresh] =
                copies.emplace(std::make_pair(vertex, plane), static_cast<std::uint32_t>(surface.vertices()));
            if (fresh) {
                surface.source.push_back(static_cast<std::uint32_t>(vertex));
                add_coordinates(surface, s, t);
            }
            surface.indices.push_back(copy->second);
        }
    }
    surface.blended_from = surface.indices.size();
    surface.indices.insert(surface.indices.end(), blended.begin(), blended.end());
    return surface;
}

std::vector<float> float_positions(const TriangleMesh& mesh) {
    std::vector<float> result;
    result.reserve(3 * mesh.vertices.size());
    for (const Vector3& v : mesh.vertices) {
        for (int c = 0; c < 3; ++c) result.push_back(static_cast<float>(v[c]));
    }
    return result;
}

std::vector<float> float_normals(const TriangleMesh& mesh) {
    std::vector<float> result;
    result.reserve(3 * mesh.vertices.size());
    for (const Vector3& n : vertex_normals(mesh)) {
        for (int c = 0; c < 3; ++c) result.push_back(static_cast<float>(n[c]));
    }
    return result;
}

}  // namespace fulcrum::ui
