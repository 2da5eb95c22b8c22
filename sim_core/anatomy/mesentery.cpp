// SPDX-License-Identifier: Apache-2.0
// The mesentery as a sheet between the bowel and its root, kept off the wall by its fat.
#include <algorithm>
#include <cmath>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/anatomy/posterior_wall.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr int sheet_columns = 13;
constexpr double row_spacing = 0.006;  // m

// Edge of the sheet: on the bowel's wall, on the side facing the root.
Vector3 edge_of(const Vector3& centre, const Vector3& tangent, const Vector3& root, double radius) {
    Vector3 towards = root - centre;
    towards -= towards.dot(tangent) * tangent;
    const double reach = towards.norm();
    return reach > 1e-6 ? Vector3(centre + std::min(radius, 0.8 * reach) / reach * towards) : centre;
}

Vector3 place(const MesenteryVertex& vertex, const Vector3& edge) {
    return (1 - vertex.fraction) * edge + vertex.fraction * vertex.root + vertex.lift;
}

}  // namespace

MesenteryShape make_mesentery(const BowelShape& bowel, const CavityShape& cavity, double first, double last) {
    if (!(first >= 0 && first < last && last <= 1))
        throw InputError("mesentery parameters", "first, last", "the range is not valid",
                         "give 0 <= first < last <= 1");
    const PosteriorWall wall(cavity.mesh);
    MesenteryShape mesentery;
    const double length = bowel.length * (last - first);
    mesentery.columns = sheet_columns;
    mesentery.rows = std::max(2, static_cast<int>(length / row_spacing) + 1);
    mesentery.attachment_radius = 0.82 * bowel.radius(0.5 * bowel.length);
    const auto points = static_cast<int>(bowel.centre_line.size());
    for (int row = 0; row < mesentery.rows; ++row) {
        const double share = first + (last - first) * row / (mesentery.rows - 1);
        const double at = share * (points - 1);
        const int i = std::clamp(static_cast<int>(at), 0, points - 2);
        const double t = at - i;
        const auto k = static_cast<std::size_t>(i);
        const Vector3 centre = (1 - t) * bowel.centre_line[k] + t * bowel.centre_line[k + 1];
        const Vector3 tangent = (bowel.centre_line[k + 1] - bowel.centre_line[k]).normalized();
        const Vector3 root = (1 - t) * bowel.root_line[k] + t * bowel.root_line[k + 1];
        const Vector3 edge = edge_of(centre, tangent, root, mesentery.attachment_radius);
        for (int column = 0; column < sheet_columns; ++column) {
            MesenteryVertex vertex;
            vertex.arc_length = share * bowel.length;
            vertex.fraction = static_cast<double>(column) / (sheet_columns - 1);
            vertex.root = root;
            const Vector3 straight = place(vertex, edge);
            // Fat: thick in the middle, lobulated; never below the wall.
            const double middle = 4 * vertex.fraction * (1 - vertex.fraction);
            const double lobes = noise3(straight / 0.011, 77) + 0.6 * noise3(straight / 0.005, 78);
            const double fat = middle * (0.0022 + 0.0016 * lobes);
            const double least = wall.height(straight.x(), straight.y()) + 0.0012 + 0.0025 * middle;
            vertex.lift = Vector3(0, 0, std::max(0.0, std::min(0.03, least - straight.z())) + fat);
            mesentery.mesh.vertices.push_back(place(vertex, edge));
            // The sheet is nearly flat at rest: projected coordinates do not shrink towards the root.
            const Vector3& rest = mesentery.mesh.vertices.back();
            mesentery.mesh.texture_coordinates.emplace_back(rest.x() / 0.06,
                                                            (rest.y() + 0.5 * rest.z()) / 0.06);
            mesentery.vertices.push_back(vertex);
        }
    }
    for (int row = 0; row + 1 < mesentery.rows; ++row) {
        for (int column = 0; column + 1 < sheet_columns; ++column) {
            const int a = row * sheet_columns + column, b = a + 1, d = a + sheet_columns, c = d + 1;
            if ((row + column) % 2 == 0) {
                mesentery.mesh.triangles.push_back({a, d, c});
                mesentery.mesh.triangles.push_back({a, c, b});
            } else {
                mesentery.mesh.triangles.push_back({a, d, b});
                mesentery.mesh.triangles.push_back({b, d, c});
            }
        }
    }
    return mesentery;
}

ReflectionShape make_reflection(const BowelShape& bowel) {
    constexpr int around = 48, rows = 20;
    constexpr double reach = 0.110, above = 0.036, below = 0.004;  // m
    constexpr double pi = 3.14159265358979323846;
    ReflectionShape shape;
    const double step = bowel.length / static_cast<double>(bowel.centre_line.size() - 1);
    const auto line_at = [&](double s) {
        const double at = std::max(0.0, s) / step;
        const auto i = std::min(static_cast<std::size_t>(at), bowel.centre_line.size() - 2);
        return Vector3(bowel.centre_line[i] +
                       (at - static_cast<double>(i)) * (bowel.centre_line[i + 1] - bowel.centre_line[i]));
    };
    const Vector3 tangent = (line_at(above) - line_at(0)).normalized();
    const Vector3 side = Vector3::UnitX() - tangent.x() * tangent;
    const Vector3 first = side.normalized(), second = tangent.cross(first);
    for (int row = 0; row < rows; ++row) {
        // From the wall inwards and up along the rectum: a quarter of a superellipse, steep at the bowel.
        const double t = static_cast<double>(row) / (rows - 1);
        const double s = below + (above - below) * t * t;
        const double inner = 0.97 * bowel.radius(s);
        const double radius = inner + (reach - inner) * (1 - t) * (1 - t) * (1 - t);
        for (int k = 0; k < around; ++k) {
            const double u = static_cast<double>(k) / around;
            double sine = 0, cosine = 1;
            math::sin_cos(2 * pi * u, sine, cosine);
            const Vector3 direction = cosine * first + sine * second;
            const double uneven = 1 + 0.10 * (1 - t) * noise3(Vector3(3 * cosine, 3 * sine, 2 * t), 91);
            shape.mesh.vertices.push_back(line_at(s) + uneven * radius * direction);
            shape.mesh.texture_coordinates.emplace_back(u, 0.5 * t);
            shape.thinness.push_back(static_cast<float>(t));
        }
    }
    const auto at = [](int row, int k) { return row * around + k % around; };
    for (int row = 0; row + 1 < rows; ++row) {
        for (int k = 0; k < around; ++k) {
            shape.mesh.triangles.push_back({at(row, k), at(row, k + 1), at(row + 1, k + 1)});
            shape.mesh.triangles.push_back({at(row, k), at(row + 1, k + 1), at(row + 1, k)});
        }
    }
    return shape;
}

void evaluate_mesentery(const MesenteryShape& mesentery, const RingFrame* rings,
                        const double* ring_arc_lengths, int ring_count, float* positions, float* normals) {
    const int columns = mesentery.columns, rows = mesentery.rows;
    int ring = 0;
    for (int row = 0; row < rows; ++row) {
        const auto start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
        const double s = mesentery.vertices[start].arc_length;
        while (ring + 2 < ring_count && ring_arc_lengths[ring + 1] < s) ++ring;
        const double span = ring_arc_lengths[ring + 1] - ring_arc_lengths[ring];
        const double t = std::clamp((s - ring_arc_lengths[ring]) / span, 0.0, 1.0);
        // Hermite between the two rings: the edge follows the bend of the bowel, not the chord.
        const Vector3 &p = rings[ring].position, &q = rings[ring + 1].position;
        const Vector3 u = span * rings[ring].rotation.col(2), v = span * rings[ring + 1].rotation.col(2);
        const double t2 = t * t, t3 = t2 * t;
        const Vector3 centre =
            (2 * t3 - 3 * t2 + 1) * p + (t3 - 2 * t2 + t) * u + (3 * t2 - 2 * t3) * q + (t3 - t2) * v;
        const Vector3 tangent =
            ((1 - t) * rings[ring].rotation.col(2) + t * rings[ring + 1].rotation.col(2)).normalized();
        const Vector3 edge =
            edge_of(centre, tangent, mesentery.vertices[start].root, mesentery.attachment_radius);
        for (int column = 0; column < columns; ++column) {
            const std::size_t k = start + static_cast<std::size_t>(column);
            const Vector3 point = place(mesentery.vertices[k], edge);
            for (int c = 0; c < 3; ++c)
                positions[3 * k + static_cast<std::size_t>(c)] = static_cast<float>(point[c]);
        }
    }
    const auto at = [&](int row, int column) {
        const float* f =
            positions + 3 * (std::clamp(row, 0, rows - 1) * columns + std::clamp(column, 0, columns - 1));
        return Eigen::Vector3f(f[0], f[1], f[2]);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Eigen::Vector3f normal =
                (at(row + 1, column) - at(row - 1, column)).cross(at(row, column + 1) - at(row, column - 1));
            const float size = normal.norm();
            normal = size > 1e-12F ? Eigen::Vector3f(normal / size) : Eigen::Vector3f::UnitZ();
            float* out = normals + 3 * (row * columns + column);
            for (int c = 0; c < 3; ++c) out[c] = normal[c];
        }
    }
}

}  // namespace fulcrum
