// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/ribbon.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {

void Ribbon::strip(const std::vector<Vector3>& way, double width) {
    positions.clear();
    rest.clear();
    triangles.clear();
    double reached = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const Vector3 along = way[std::min(i + 1, way.size() - 1)] - way[i == 0 ? 0 : i - 1];
        Vector3 across = Vector3::UnitZ().cross(along);
        across = across.norm() > 1e-9 ? Vector3(across.normalized()) : Vector3(Vector3::UnitY());
        if (i > 0) reached += (way[i] - way[i - 1]).norm();
        for (const double side : {-0.5, 0.5}) {
            positions.push_back(way[i] + side * width * across);
            rest.emplace_back(reached, side * width, 0);
        }
        if (i == 0) continue;
        const auto d = static_cast<std::int32_t>(2 * i + 1), c = d - 1, b = d - 2, a = d - 3;
        triangles.push_back({a, c, d});
        triangles.push_back({a, d, b});
    }
}

void Ribbon::cord(const std::vector<Vector3>& way, double radius) {
    constexpr int around = 7;  // the last lies on the first: the texture's seam
    positions.clear();
    rest.clear();
    triangles.clear();
    Vector3 across = Vector3::UnitX();
    double reached = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const Vector3 along = (way[std::min(i + 1, way.size() - 1)] - way[i == 0 ? 0 : i - 1]).normalized();
        // Carried on from the point before, so that the cord is not twisted.
        across -= along * along.dot(across);
        if (across.norm() < 1e-6) across = along.unitOrthogonal();
        across.normalize();
        const Vector3 up = along.cross(across);
        if (i > 0) reached += (way[i] - way[i - 1]).norm();
        for (int k = 0; k < around; ++k) {
            const double turn = 2 * 3.14159265358979323846 * k / (around - 1);
            positions.push_back(way[i] + radius * (std::cos(turn) * across + std::sin(turn) * up));
            rest.emplace_back(reached, radius * turn, 0);
            if (i == 0 || k == 0) continue;
            const auto d = static_cast<std::int32_t>(positions.size()) - 1, c = d - 1, b = d - around,
                       a = b - 1;
            triangles.push_back({a, d, b});
            triangles.push_back({a, c, d});
        }
    }
}

DrawnSheet Ribbon::drawn(double thickness, const QVector3D& tint, float share) const {
    DrawnSheet sheet;
    sheet.surface = {positions.data(), rest.data(),      positions.size(),
                     triangles.data(), triangles.size(), thickness};
    sheet.tint = tint;
    sheet.tint_share = share;
    return sheet;
}

void Ribbons::begin(std::size_t most) {
    used_ = 0;
    ribbons_.resize(std::max(ribbons_.size(), most));
}

Ribbon& Ribbons::next() {
    return ribbons_[used_++];
}

}  // namespace fulcrum::ui
