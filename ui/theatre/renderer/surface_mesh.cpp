// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fulcrum::ui {
namespace {

constexpr int band_gaps = 8;                // gaps between two rows a band; even
constexpr std::size_t run_triangles = 400;  // a band's where there are no rows

// Rows of vertices between two poles: vertex 0, rows * columns in order, the last vertex.
struct Tube {
    int rows = 0, columns = 0;
    bool turned = false;  // triangles run the other way round
    std::int32_t at(int row, int column) const { return 1 + row * columns + column % columns; }
};

bool names(const Triangle& triangle, std::int32_t vertex) {
    return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

// None where the mesh is not laid out that way, or has too few vertices to leave any out.
Tube find_tube(const TriangleMesh& mesh) {
    Tube tube;
    const auto vertices = static_cast<int>(mesh.vertices.size());
    while (static_cast<std::size_t>(tube.columns) < mesh.triangles.size() &&
           names(mesh.triangles[static_cast<std::size_t>(tube.columns)], 0))
        ++tube.columns;
    if (tube.columns < 8 || tube.columns % 2 != 0 || (vertices - 2) % tube.columns != 0) return {};
    tube.rows = (vertices - 2) / tube.columns;
    if (tube.rows <= 2 * band_gaps ||
        mesh.triangles.size() != static_cast<std::size_t>(2 * tube.columns * tube.rows))
        return {};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const int half_gap = static_cast<int>(t) / tube.columns;  // from 0
        for (const std::int32_t vertex : mesh.triangles[t]) {
            const int row =
                vertex == 0 ? -1 : (vertex == vertices - 1 ? tube.rows : (vertex - 1) / tube.columns);
            if (row < (half_gap + 1) / 2 - 1 || row > (half_gap + 1) / 2) return {};
        }
    }
    const Triangle& fan = mesh.triangles[0];
    const auto pole = static_cast<std::size_t>(std::find(fan.begin(), fan.end(), 0) - fan.begin());
    tube.turned = fan[(pole + 1) % 3] == tube.at(0, 0);
    return tube;
}

// Triangles of every second vertex, appended to the mesh's own.
class CoarseTube {
  public:
    CoarseTube(const Tube& tube, std::vector<Triangle>& triangles) : tube_(tube), triangles_(triangles) {}

    // Rows `row` and `row` + 2, plain.
    IndexRange strip(int row) {
        return collect([&](int k) {
            const std::int32_t a = tube_.at(row, k), b = tube_.at(row, k + 2), c = tube_.at(row + 2, k + 2),
                               d = tube_.at(row + 2, k);
            if ((row / 2 + k / 2) % 2 == 0) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        });
    }
    // The same, with all vertices of `fine_row`, which is one of the two.
    IndexRange stitched(int row, int fine_row) {
        const int other = fine_row == row ? row + 2 : row;
        return collect([&](int k) {
            const std::int32_t a = tube_.at(fine_row, k), m = tube_.at(fine_row, k + 1),
                               b = tube_.at(fine_row, k + 2), c = tube_.at(other, k + 2),
                               d = tube_.at(other, k);
            if (fine_row == row) {
                add(a, m, d);
                add(m, b, c);
                add(m, c, d);
            } else {
                add(d, m, a);
                add(c, b, m);
                add(d, c, m);
            }
        });
    }

  private:
    template <typename Cell>
    IndexRange collect(Cell&& cell) {
        const std::size_t first = 3 * triangles_.size();
        for (int k = 0; k < tube_.columns; k += 2) cell(k);
        return {first, 3 * triangles_.size()};
    }
    void add(std::int32_t a, std::int32_t b, std::int32_t c) {
        triangles_.push_back(tube_.turned ? Triangle{a, c, b} : Triangle{a, b, c});
    }
    const Tube& tube_;
    std::vector<Triangle>& triangles_;
};

void add_bands(const Tube& tube, std::vector<Triangle>& triangles, SurfaceMesh& surface) {
    const auto columns = static_cast<std::size_t>(tube.columns);
    // Index of the first triangle of the gap above a row.
    const auto first_of_gap = [columns](int row) {
        return 3 * (columns + 2 * columns * static_cast<std::size_t>(row));
    };
    const std::size_t fine_end = 3 * triangles.size();
    surface.bands.push_back({{0, first_of_gap(0)}, {}, {}, {}, {}, {}});
    CoarseTube coarse(tube, triangles);
    int row = 0;
    for (; row + band_gaps < tube.rows; row += band_gaps) {
        SurfaceBand band;
        band.fine = {first_of_gap(row), first_of_gap(row + band_gaps)};
        band.first_plain = coarse.strip(row);
        band.first_stitched = coarse.stitched(row, row);
        const int last = row + band_gaps - 2;
        band.coarse = coarse.strip(row + 2);
        for (int r = row + 4; r < last; r += 2) band.coarse.last = coarse.strip(r).last;
        band.last_plain = coarse.strip(last);
        band.last_stitched = coarse.stitched(last, last + 2);
        surface.bands.push_back(band);
    }
    surface.bands.push_back({{first_of_gap(row), fine_end}, {}, {}, {}, {}, {}});
}

void add_runs(const std::vector<Triangle>& triangles, SurfaceMesh& surface) {
    for (std::size_t t = 0; t < triangles.size(); t += run_triangles)
        surface.bands.push_back(
            {{3 * t, 3 * std::min(t + run_triangles, triangles.size())}, {}, {}, {}, {}, {}});
}

// A vertex whose copies carry other coordinates than its own.
class Splitter {
  public:
    Splitter(const TriangleMesh& mesh, SurfaceMesh& surface) : mesh_(mesh), surface_(surface) {}

    void add(const Triangle& triangle) {
        double low = 1e9, high = -1e9, sum = 0;
        int around = 0;
        for (const auto vertex : triangle) {
            if (is_pole(vertex)) continue;
            low = std::min(low, u(vertex));
            high = std::max(high, u(vertex));
        }
        const bool seam = high - low > 0.5;
        for (const auto vertex : triangle) {
            if (is_pole(vertex)) continue;
            sum += u(vertex) + (seam && u(vertex) <= 0.5 ? 1 : 0);
            ++around;
        }
        for (const auto vertex : triangle) {
            if (is_pole(vertex)) {
                surface_.indices.push_back(copy(vertex, sum / around));
            } else if (seam && u(vertex) <= 0.5) {
                const auto [known, fresh] = copies_.emplace(vertex, 0U);
                if (fresh) known->second = copy(vertex, u(vertex) + 1);
                surface_.indices.push_back(known->second);
            } else {
                surface_.indices.push_back(static_cast<std::uint32_t>(vertex));
            }
        }
    }
    void set_poles(std::int32_t first, std::int32_t last) {
        poles_[0] = first;
        poles_[1] = last;
    }

  private:
    bool is_pole(std::int32_t vertex) const { return vertex == poles_[0] || vertex == poles_[1]; }
    double u(std::int32_t vertex) const {
        return mesh_.texture_coordinates[static_cast<std::size_t>(vertex)].x();
    }
    std::uint32_t copy(std::int32_t vertex, double new_u) {
        const auto index = static_cast<std::uint32_t>(surface_.vertices());
        surface_.source.push_back(static_cast<std::uint32_t>(vertex));
        surface_.coordinates.push_back(static_cast<float>(new_u));
        surface_.coordinates.push_back(
            static_cast<float>(mesh_.texture_coordinates[static_cast<std::size_t>(vertex)].y()));
        return index;
    }
    const TriangleMesh& mesh_;
    SurfaceMesh& surface_;
    std::map<std::int32_t, std::uint32_t> copies_;
    std::int32_t poles_[2] = {-1, -1};
};

void append(const SurfaceMesh& surface, const IndexRange& range, std::vector<std::uint32_t>& chosen) {
    chosen.insert(chosen.end(), surface.indices.begin() + static_cast<std::ptrdiff_t>(range.first),
                  surface.indices.begin() + static_cast<std::ptrdiff_t>(range.last));
}

/// What lies nearer to the tube's axis than most of it gets copies with coordinates across the axis, from the
/// middle between two taeniae.
void flatten_domes(const TriangleMesh& mesh, SurfaceMesh& surface) {
    constexpr double dome = 0.92;                      // of the tube's radius
    constexpr double middle = 1.0 / 3, reach = 0.115;  // of the tile's width
    const auto axial = [&mesh](std::uint32_t vertex) {
        const Vector3& p = mesh.vertices[vertex];
        return std::hypot(p.y(), p.z());
    };
    double radius = 0;
    for (std::uint32_t v = 0; v < surface.base; ++v) radius = std::max(radius, axial(v));
    std::map<std::uint32_t, std::uint32_t> copies;
    for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
        std::uint32_t vertex[3];
        bool within = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t index = surface.indices[i + c];
            vertex[c] = index < surface.base ? index : surface.source[index - surface.base];
            within = within && axial(vertex[c]) < dome * radius;
        }
        for (std::size_t c = 0; within && c < 3; ++c) {
            const auto [known, fresh] =
                copies.emplace(vertex[c], static_cast<std::uint32_t>(surface.vertices()));
            if (fresh) {
                const Vector3& p = mesh.vertices[vertex[c]];
                surface.source.push_back(vertex[c]);
                surface.coordinates.push_back(static_cast<float>(middle + reach * p.y() / radius));
                surface.coordinates.push_back(static_cast<float>(0.5 * reach * p.z() / radius));
            }
            surface.indices[i + c] = known->second;
        }
    }
}

}  // namespace

SurfaceMesh make_surface(const TriangleMesh& mesh) {
    SurfaceMesh surface;
    surface.base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& uv : mesh.texture_coordinates) {
        surface.coordinates.push_back(static_cast<float>(uv.x()));
        surface.coordinates.push_back(static_cast<float>(uv.y()));
    }
    std::vector<Triangle> triangles = mesh.triangles;
    Splitter splitter(mesh, surface);
    if (const Tube tube = find_tube(mesh); tube.rows > 0) {
        add_bands(tube, triangles, surface);
        splitter.set_poles(0, static_cast<std::int32_t>(surface.base) - 1);
        const int middle = tube.rows / 2;
        const auto vertex = [&](int row, int column) {
            return mesh.vertices[static_cast<std::size_t>(tube.at(row, column))];
        };
        surface.coarse_edge = (vertex(middle, 2) - vertex(middle, 0)).norm();
    } else {
        add_runs(triangles, surface);
    }
    if (mesh.texture_coordinates.empty()) {
        surface.coordinates.assign(2 * mesh.vertices.size(), 0.0F);
        for (const Triangle& triangle : triangles) {
            for (const auto vertex : triangle) surface.indices.push_back(static_cast<std::uint32_t>(vertex));
        }
        return surface;
    }
    for (const Triangle& triangle : triangles) splitter.add(triangle);
    return surface;
}

SurfaceMesh make_bowel_surface(const TriangleMesh& mesh, bool domes) {
    SurfaceMesh surface = make_surface(mesh);
    for (std::size_t i = 1; i < surface.coordinates.size(); i += 2) surface.coordinates[i] *= 0.5F;
    if (domes) flatten_domes(mesh, surface);
    return surface;
}

void choose_triangles(const SurfaceMesh& surface, const std::vector<std::size_t>& order,
                      const std::vector<char>& fine, std::vector<std::uint32_t>& chosen) {
    const auto is_fine = [&](std::size_t band) {
        return fine[band] != 0 || surface.bands[band].coarse.first == surface.bands[band].coarse.last;
    };
    for (const std::size_t b : order) {
        const SurfaceBand& band = surface.bands[b];
        if (is_fine(b)) {
            append(surface, band.fine, chosen);
            continue;
        }
        append(surface, is_fine(b - 1) ? band.first_stitched : band.first_plain, chosen);
        append(surface, band.coarse, chosen);
        append(surface, is_fine(b + 1) ? band.last_stitched : band.last_plain, chosen);
    }
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
