// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/posterior_wall.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {
constexpr double uncovered = -1e9;
}

PosteriorWall::PosteriorWall(const TriangleMesh& cavity, double cell) : cell_(cell) {
    Vector3 low = cavity.vertices.front(), high = low;
    for (const Vector3& v : cavity.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    x0_ = low.x();
    y0_ = low.y();
    columns_ = static_cast<int>((high.x() - low.x()) / cell) + 2;
    rows_ = static_cast<int>((high.y() - low.y()) / cell) + 2;
    heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), uncovered);
    for (const Triangle& t : cavity.triangles) {
        const Vector3 &a = cavity.vertices[static_cast<std::size_t>(t[0])],
                      &b = cavity.vertices[static_cast<std::size_t>(t[1])],
                      &c = cavity.vertices[static_cast<std::size_t>(t[2])];
        const Vector3 normal = area_vector(a, b, c);
        if (normal.z() >= 0) continue;
        const int i0 = static_cast<int>(std::floor((std::min({a.x(), b.x(), c.x()}) - x0_) / cell));
        const int i1 = static_cast<int>(std::ceil((std::max({a.x(), b.x(), c.x()}) - x0_) / cell));
        const int j0 = static_cast<int>(std::floor((std::min({a.y(), b.y(), c.y()}) - y0_) / cell));
        const int j1 = static_cast<int>(std::ceil((std::max({a.y(), b.y(), c.y()}) - y0_) / cell));
        for (int j = std::max(0, j0); j <= std::min(rows_ - 1, j1); ++j) {
            for (int i = std::max(0, i0); i <= std::min(columns_ - 1, i1); ++i) {
                const double x = x0_ + i * cell, y = y0_ + j * cell;
                const auto side = [x, y](const Vector3& p, const Vector3& q) {
                    return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
                };
                // Seen from above the triangle is clockwise.
                if (side(a, b) > 1e-12 || side(b, c) > 1e-12 || side(c, a) > 1e-12) continue;
                const double z = a.z() - (normal.x() * (x - a.x()) + normal.y() * (y - a.y())) / normal.z();
                double& height = heights_[index(i, j)];
                height = std::max(height, z);
            }
        }
    }
}

double PosteriorWall::height(double x, double y) const {
    const int i = std::clamp(static_cast<int>(std::lround((x - x0_) / cell_)), 0, columns_ - 1);
    const int j = std::clamp(static_cast<int>(std::lround((y - y0_) / cell_)), 0, rows_ - 1);
    const int reach = std::max(columns_, rows_);
    for (int ring = 0; ring < reach; ++ring) {
        double best = uncovered;
        for (int b = std::max(0, j - ring); b <= std::min(rows_ - 1, j + ring); ++b) {
            for (int a = std::max(0, i - ring); a <= std::min(columns_ - 1, i + ring); ++a)
                best = std::max(best, heights_[index(a, b)]);
        }
        if (best > uncovered) return best;
    }
    return 0;
}

double PosteriorWall::resting_height(double x, double y, double radius) const {
    const int reach = static_cast<int>(std::ceil(radius / cell_));
    const int ci = static_cast<int>(std::lround((x - x0_) / cell_)),
              cj = static_cast<int>(std::lround((y - y0_) / cell_));
    double highest = uncovered;
    for (int j = std::max(0, cj - reach); j <= std::min(rows_ - 1, cj + reach); ++j) {
        for (int i = std::max(0, ci - reach); i <= std::min(columns_ - 1, ci + reach); ++i) {
            const double dx = x0_ + i * cell_ - x, dy = y0_ + j * cell_ - y;
            const double room = radius * radius - dx * dx - dy * dy;
            const double height = heights_[index(i, j)];
            if (room < 0 || height <= uncovered) continue;
            highest = std::max(highest, height + std::sqrt(room));
        }
    }
    return highest > uncovered ? highest : height(x, y) + radius;
}

}  // namespace fulcrum
