// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/mean_value.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double on_surface = 1e-13;  // distance over the cage's size below which the point is on the cage
constexpr double maybe_on_surface =
    1e-9;  // volume of the unit tetrahedron that makes the closest point worth a look
// In the plane of a triangle but outside it, the mean vector's part across the plane vanishes as the square
// of the height: below these two it is rounding, and the weight along the plane's null direction is dropped
// instead of amplified.
constexpr double flat_pivot = 1e-8;
constexpr double flat_residual = 1e-14;

// beta times the unit normal of the sector between two unit vectors. Swapping them changes the sign and no
// bit else, so the mean vectors of a closed cage cancel to rounding whatever the angles.
Vector3 sector(const Vector3& a, const Vector3& b) {
    const Vector3 cross = a.cross(b);
    const double sine = cross.norm();
    if (sine < 1e-300) return Vector3::Zero();
    return cross * (math::atan2(sine, a.dot(b)) / sine);
}

// lambda with [a b c] lambda = m by elimination with complete pivoting: the residual stays at rounding even
// where the three directions are nearly coplanar, and the residual is what linear reproduction rests on.
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

}  // namespace

void mean_value_weights(const std::vector<Vector3>& vertices, const std::vector<Triangle>& triangles,
                        const Vector3& point, MeanValueScratch& scratch, double* weights) {
    const std::size_t count = vertices.size();
    scratch.direction.resize(count);
    scratch.distance.resize(count);
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
    for (const auto& triangle : triangles) {
        const auto i = static_cast<std::size_t>(triangle[0]), j = static_cast<std::size_t>(triangle[1]),
                   k = static_cast<std::size_t>(triangle[2]);
        const Vector3 &a = scratch.direction[i], &b = scratch.direction[j], &c = scratch.direction[k];
        if (std::abs(a.dot(b.cross(c))) < maybe_on_surface) {
            const TrianglePoint closest =
                closest_point_on_triangle(point, vertices[i], vertices[j], vertices[k]);
            if ((closest.position - point).norm() <= on_surface * size) {
                std::fill(weights, weights + count, 0.0);
                weights[i] = closest.barycentric[0];
                weights[j] = closest.barycentric[1];
                weights[k] = closest.barycentric[2];
                return;
            }
        }
        const Vector3 mean = 0.5 * (sector(a, b) + sector(b, c) + sector(c, a));
        const Vector3 lambda = solve_directions(a, b, c, mean);
        weights[i] += lambda[0] / scratch.distance[i];
        weights[j] += lambda[1] / scratch.distance[j];
        weights[k] += lambda[2] / scratch.distance[k];
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weights[i];
    assert(sum != 0.0 && "the point is outside a cage that is not closed");
    for (std::size_t i = 0; i < count; ++i) weights[i] /= sum;
}

}  // namespace fulcrum
