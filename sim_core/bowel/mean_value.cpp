// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/mean_value.h"

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double on_surface =
    1e-13;  // distance relative to the cage's size below which a point is on the cage
constexpr double maybe_on_surface =
    1e-9;  // volume of the unit tetrahedron below which the closest point is checked
constexpr double well_spread = 1e-2;  // volume above which Cramer's rule is as good as elimination
// In the plane of a triangle but outside it, the component of the mean vector across the plane vanishes as
// the square of the height. Below these two limits it is rounding noise, and the weight along the null
// direction of the plane is dropped instead of amplified.
constexpr double flat_pivot = 1e-8;
constexpr double flat_residual = 1e-14;

// lambda with [a b c] lambda = m by elimination with complete pivoting: the residual stays at rounding level
// even if the three directions are nearly coplanar, and linear reproduction depends on that residual.
Vector3 solve_directions(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& m) {
    double matrix[3][4] = {
        {a.x(), b.x(), c.x(), m.x()}, {a.y(), b.y(), c.y(), m.y()}, {a.z(), b.z(), c.z(), m.z()}};
    int column_of[3] = {0, 1, 2};
    int rank = 0;
    for (; rank < 3; ++rank) {
        int pivot_row = rank, pivot_column = rank;
        double pivot = -1.0, rest = 0.0;
        for (int i = rank; i < 3; ++i) {
            rest = std::max(rest, std::abs(matrix[i][3]));
            for (int j = rank; j < 3; ++j) {
                if (std::abs(matrix[i][j]) > pivot) {
                    pivot = std::abs(matrix[i][j]);
                    pivot_row = i;
                    pivot_column = j;
                }
            }
        }
        if (pivot == 0.0 || (pivot < flat_pivot && rest < flat_residual)) break;
        std::swap(matrix[rank], matrix[pivot_row]);
        if (pivot_column != rank) {
            for (auto& row : matrix) std::swap(row[rank], row[pivot_column]);
            std::swap(column_of[rank], column_of[pivot_column]);
        }
        for (int i = rank + 1; i < 3; ++i) {
            const double factor = matrix[i][rank] / matrix[rank][rank];
            for (int j = rank; j < 4; ++j) matrix[i][j] -= factor * matrix[rank][j];
        }
    }
    Vector3 lambda = Vector3::Zero();
    for (int i = rank - 1; i >= 0; --i) {
        double value = matrix[i][3];
        for (int j = i + 1; j < rank; ++j) value -= matrix[i][j] * lambda[column_of[j]];
        lambda[column_of[i]] = value / matrix[i][i];
    }
    return lambda;
}

// True if the point lies on the triangle, within rounding of the cage's size.
bool lies_on(const std::vector<Vector3>& vertices, const Triangle& triangle, const Vector3& point,
             double size, double* weights) {
    const auto i = static_cast<std::size_t>(triangle[0]), j = static_cast<std::size_t>(triangle[1]),
               k = static_cast<std::size_t>(triangle[2]);
    const TrianglePoint closest = closest_point_on_triangle(point, vertices[i], vertices[j], vertices[k]);
    if ((closest.position - point).norm() > on_surface * size) return false;
    std::fill(weights, weights + vertices.size(), 0.0);
    weights[i] = closest.barycentric[0];
    weights[j] = closest.barycentric[1];
    weights[k] = closest.barycentric[2];
    return true;
}

// Each edge's sector is computed once and used with both signs, so that the mean vectors of a closed cage
// cancel to rounding for any angles.
void fill_sectors(const CageTopology& topology, MeanValueScratch& scratch) {
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const Vector3& a = scratch.direction[static_cast<std::size_t>(topology.edges[e][0])];
        const Vector3& b = scratch.direction[static_cast<std::size_t>(topology.edges[e][1])];
        const Vector3 cross = a.cross(b);
        const double sine = cross.norm();
        scratch.cross[e] = cross;
        // Parallel directions span no sector; opposite ones mean a point on the edge, which lies_on has
        // already handled.
        scratch.sector[e] = sine < 1e-300 ? Vector3(Vector3::Zero())
                                          : Vector3(cross * (0.5 * math::atan2(sine, a.dot(b)) / sine));
    }
}

}  // namespace

CageTopology::CageTopology(std::vector<Triangle> cage_triangles) : triangles(std::move(cage_triangles)) {
    for (const auto& triangle : triangles) {
        for (std::size_t e = 0; e < 3; ++e) {
            const auto a = triangle[e], b = triangle[(e + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& triangle : triangles) {
        std::array<std::int32_t, 3> numbers;
        std::array<double, 3> signs;
        for (std::size_t e = 0; e < 3; ++e) {
            const auto a = triangle[e], b = triangle[(e + 1) % 3];
            const std::array<std::int32_t, 2> edge = {std::min(a, b), std::max(a, b)};
            numbers[e] =
                static_cast<std::int32_t>(std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin());
            signs[e] = a < b ? 1.0 : -1.0;
        }
        triangle_edges.push_back(numbers);
        edge_signs.push_back(signs);
    }
}

void mean_value_weights(const std::vector<Vector3>& vertices, const CageTopology& topology,
                        const Vector3& point, MeanValueScratch& scratch, double* weights) {
    const std::size_t count = vertices.size();
    scratch.direction.resize(count);
    scratch.distance.resize(count);
    scratch.cross.resize(topology.edges.size());
    scratch.sector.resize(topology.edges.size());
    std::fill(weights, weights + count, 0.0);
    double size = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        scratch.direction[i] = vertices[i] - point;
        scratch.distance[i] = scratch.direction[i].norm();
        size = std::max(size, scratch.distance[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (scratch.distance[i] <= on_surface * size) {
            weights[i] = 1.0;
            return;
        }
        scratch.direction[i] /= scratch.distance[i];
    }
    fill_sectors(topology, scratch);
    for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
        const Triangle& triangle = topology.triangles[t];
        const auto i = static_cast<std::size_t>(triangle[0]), j = static_cast<std::size_t>(triangle[1]),
                   k = static_cast<std::size_t>(triangle[2]);
        const auto& edges = topology.triangle_edges[t];
        const auto& signs = topology.edge_signs[t];
        const auto ab = static_cast<std::size_t>(edges[0]), bc = static_cast<std::size_t>(edges[1]),
                   ca = static_cast<std::size_t>(edges[2]);
        const double volume = signs[0] * scratch.cross[ab].dot(scratch.direction[k]);
        if (std::abs(volume) < maybe_on_surface && lies_on(vertices, triangle, point, size, weights)) return;
        const Vector3 mean =
            signs[0] * scratch.sector[ab] + signs[1] * scratch.sector[bc] + signs[2] * scratch.sector[ca];
        Vector3 lambda;
        if (std::abs(volume) > well_spread) {
            lambda = Vector3(signs[1] * scratch.cross[bc].dot(mean), signs[2] * scratch.cross[ca].dot(mean),
                             signs[0] * scratch.cross[ab].dot(mean)) /
                     volume;
        } else {
            lambda = solve_directions(scratch.direction[i], scratch.direction[j], scratch.direction[k], mean);
        }
        weights[i] += lambda[0] / scratch.distance[i];
        weights[j] += lambda[1] / scratch.distance[j];
        weights[k] += lambda[2] / scratch.distance[k];
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weights[i];
    for (std::size_t i = 0; i < count; ++i) weights[i] /= sum;
}

}  // namespace fulcrum
