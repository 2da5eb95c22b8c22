// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/sheet_mesh.h"

#include <algorithm>

namespace fulcrum::ui {

void SheetMesh::add(const Vector3& position, const Vector3& normal, const Vector3& rest, float detail) {
    for (int c = 0; c < 3; ++c) vertices_.push_back(static_cast<float>(position[c]));
    for (int c = 0; c < 3; ++c) vertices_.push_back(static_cast<float>(normal[c]));
    vertices_.push_back(static_cast<float>(rest.x()));
    vertices_.push_back(static_cast<float>(rest.y()));
    vertices_.push_back(detail);
}

void SheetMesh::add_edge(const SheetSurface& surface, std::int32_t from, std::int32_t to) {
    const auto place = [&surface](std::int32_t v) {
        return static_cast<std::uint64_t>(surface.places == nullptr ? v : surface.places[v]);
    };
    const std::uint64_t a = place(from), b = place(to);
    edges_.push_back({(std::min(a, b) << 32U) | std::max(a, b), from, to});
}

void SheetMesh::build(const SheetSurface& surface) {
    vertices_.clear();
    indices_.clear();
    edges_.clear();
    rim_edges_ = 0;
    normals_.assign(surface.vertices, Vector3::Zero());
    const auto known = [&surface](const Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&surface](std::int32_t v) {
            return v >= 0 && static_cast<std::size_t>(v) < surface.vertices;
        });
    };
    const auto at = [](std::int32_t v) { return static_cast<std::size_t>(v); };
    for (std::size_t t = 0; t < surface.count; ++t) {
        const Triangle& triangle = surface.triangles[t];
        if (!known(triangle)) continue;
        const Vector3& p = surface.positions[at(triangle[0])];
        const Vector3 area =
            (surface.positions[at(triangle[1])] - p).cross(surface.positions[at(triangle[2])] - p);
        for (std::size_t c = 0; c < 3; ++c) {
            normals_[at(triangle[c])] += area;
            if (surface.thickness > 0) add_edge(surface, triangle[c], triangle[(c + 1) % 3]);
        }
    }
    for (std::size_t e = 0; e < surface.beside_count; ++e)
        add_edge(surface, surface.beside[e][0], surface.beside[e][1]);
    for (Vector3& normal : normals_) {
        const double length = normal.norm();
        normal = length > 0 ? Vector3(normal / length) : Vector3(Vector3::UnitZ());
    }
    if (surface.normals != nullptr) normals_.assign(surface.normals, surface.normals + surface.vertices);
    // m before the positions that a face lies, and what its vertices know.
    const auto before = [&surface](double side) {
        return surface.wall ? std::min(0.0, side) * surface.thickness : 0.5 * side * surface.thickness;
    };
    const auto detail = [&surface](std::size_t v, double side) {
        if (surface.wall) return side > 0 ? 0.0F : 1.0F;
        return surface.burnt == nullptr ? 0.0F : std::clamp(surface.burnt[v], 0.0F, 1.0F);
    };
    for (const double side : {1.0, -1.0}) {
        if (side < 0 && surface.thickness <= 0) break;
        const auto first = static_cast<std::uint32_t>(vertices_.size() / floats);
        for (std::size_t v = 0; v < surface.vertices; ++v)
            add(surface.positions[v] + before(side) * normals_[v], side * normals_[v], surface.rest[v],
                detail(v, side));
        for (std::size_t t = 0; t < surface.count; ++t) {
            const Triangle& triangle = surface.triangles[t];
            if (!known(triangle)) continue;
            for (std::size_t c = 0; c < 3; ++c)
                indices_.push_back(first + static_cast<std::uint32_t>(triangle[side > 0 ? c : 2 - c]));
        }
    }
    if (surface.thickness <= 0) return;
    // An edge that only one triangle has is a rim: the cut through the sheet shows there.
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.key < b.key; });
    for (std::size_t e = 0; e < edges_.size();) {
        std::size_t next = e + 1;
        while (next < edges_.size() && edges_[next].key == edges_[e].key) ++next;
        if (next == e + 1) {
            ++rim_edges_;
            const std::size_t from = at(edges_[e].from), to = at(edges_[e].to);
            const Vector3 along = surface.positions[to] - surface.positions[from];
            Vector3 out = along.cross(normals_[from] + normals_[to]);
            const double length = out.norm();
            out = length > 0 ? Vector3(out / length) : Vector3(Vector3::UnitX());
            const auto first = static_cast<std::uint32_t>(vertices_.size() / floats);
            for (const std::size_t end : {from, to}) {
                for (const double side : {1.0, -1.0})
                    add(surface.positions[end] + before(side) * normals_[end], out, surface.rest[end],
                        cut_detail + detail(end, side));
            }
            for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) indices_.push_back(first + corner);
        }
        e = next;
    }
}

}  // namespace fulcrum::ui
