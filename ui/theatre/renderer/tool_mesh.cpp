// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/tool_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>

namespace fulcrum::ui {
namespace {

constexpr float pi = 3.14159265F;
using Point = Eigen::Vector3f;

// A grid of points; normals from its neighbours, so that edges come out round unless rows are doubled.
RigidMesh sweep(int rows, int columns, bool closed, float tiles_around, float tiles_along,
                const std::function<Point(int, int)>& at) {
    RigidMesh mesh;
    for (int i = 0; i < rows; ++i) {
        for (int k = 0; k <= columns; ++k) {
            const auto wrap = [&](int j) {
                return closed ? (j + columns) % columns : std::min(std::max(j, 0), columns);
            };
            const Point p = at(i, wrap(k));
            const Point across = at(i, wrap(k + 1)) - at(i, wrap(k - 1));
            const Point along = at(std::min(i + 1, rows - 1), wrap(k)) - at(std::max(i - 1, 0), wrap(k));
            Point n = across.cross(along);
            n = n.norm() > 1e-12F ? Point(n.normalized()) : Point(0, 0, i == 0 ? -1.0F : 1.0F);
            const float u = tiles_around * static_cast<float>(k) / static_cast<float>(columns);
            const float v = tiles_along * static_cast<float>(i) / static_cast<float>(rows - 1);
            for (const float value : {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), u, v})
                mesh.vertices.push_back(value);
        }
    }
    for (int i = 0; i + 1 < rows; ++i) {
        for (int k = 0; k < columns; ++k) {
            const auto a = static_cast<std::uint32_t>(i * (columns + 1) + k), b = a + 1;
            const auto d = a + static_cast<std::uint32_t>(columns) + 1, c = d + 1;
            for (const std::uint32_t index : {a, b, c, a, c, d}) mesh.indices.push_back(index);
        }
    }
    return mesh;
}

Point ring(int k, int columns, float radius, float z) {
    const float angle = 2 * pi * static_cast<float>(k) / static_cast<float>(columns);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

RigidMesh make_shaft() {
    return sweep(2, 18, true, 1, 1, [](int i, int k) { return ring(k, 18, 1, static_cast<float>(i)); });
}

RigidMesh make_clevis() {
    // A turned collar, then two cheeks: the section goes from round to flat.
    static constexpr float z[] = {-1.9F, -1.85F, -1.2F, -0.9F, -0.3F, 0.7F, 1.2F, 1.35F, 1.35F};
    static constexpr float x[] = {0.0F, 1.03F, 1.03F, 0.95F, 0.92F, 0.92F, 0.75F, 0.4F, 0.0F};
    static constexpr float y[] = {0.0F, 1.03F, 1.03F, 0.90F, 0.66F, 0.60F, 0.50F, 0.3F, 0.0F};
    return sweep(9, 14, true, 1, 0.3F, [](int i, int k) {
        Point p = ring(k, 14, 1, z[i]);
        p.x() *= x[i];
        p.y() *= y[i];
        return p;
    });
}

RigidMesh make_jaw() {
    constexpr int rows = 36, columns = 12;
    return sweep(rows, columns, true, 0.4F, 1, [](int i, int k) {
        const float t =
            std::min(1.0F, std::max(0.0F, static_cast<float>(i - 1) / static_cast<float>(rows - 3)));
        const float cap = i == 0 || i == rows - 1 ? 0.0F : 1.0F;
        const float angle = 2 * pi * static_cast<float>(k) / columns;
        // Slim from the hinge, a little broader in the middle, round at the tip.
        const float end = std::sqrt(std::max(0.0F, 1 - std::pow(std::max(0.0F, (t - 0.88F) / 0.12F), 2.0F)));
        const float half =
            cap * (0.085F + 0.030F * std::sin(pi * std::min(1.0F, 1.15F * t))) * (0.25F + 0.75F * end);
        const float thick = cap * (0.125F - 0.055F * t) * (0.3F + 0.7F * end);
        float px = half * std::cos(angle), py = thick * (0.5F + 0.5F * std::sin(angle));
        // Flat below, with teeth; a groove along the back.
        if (std::sin(angle) < -0.3F) {
            const float tooth = std::abs(std::fmod(t * 11.0F, 1.0F) - 0.5F) * 2;
            py = cap * 0.016F * tooth * (t > 0.12F ? 1.0F : 0.0F);
            px *= 1.06F;
        } else if (std::sin(angle) > 0.9F && t > 0.2F && t < 0.85F) {
            py -= 0.030F;
        }
        return Point(px, py, t);
    });
}

RigidMesh make_blade() {
    constexpr int rows = 14, columns = 10;
    return sweep(rows, columns, true, 0.4F, 1, [](int i, int k) {
        const float t =
            std::min(1.0F, std::max(0.0F, static_cast<float>(i - 1) / static_cast<float>(rows - 3)));
        const float cap = i == 0 || i == rows - 1 ? 0.0F : 1.0F;
        const float angle = 2 * pi * static_cast<float>(k) / columns;
        const float point = std::sqrt(1 - 0.96F * t * t);
        const float px = cap * 0.040F * (0.4F + 0.6F * point) * std::cos(angle);
        const float py = cap * (0.105F - 0.030F * t) * point * (0.5F + 0.5F * std::sin(angle));
        return Point(px + 0.10F * t * t, py, t);
    });
}

RigidMesh make_rod() {
    constexpr int rows = 12, columns = 10;
    return sweep(rows, columns, true, 0.4F, 1, [](int i, int k) {
        const float t =
            std::min(1.0F, std::max(0.0F, static_cast<float>(i - 1) / static_cast<float>(rows - 3)));
        const float cap = i == 0 || i == rows - 1 ? 0.0F : 1.0F;
        const float end = std::sqrt(std::max(0.0F, 1 - std::pow(std::max(0.0F, (t - 0.93F) / 0.07F), 2.0F)));
        const float thick = cap * (0.062F - 0.016F * t) * (0.3F + 0.7F * end);
        const float angle = 2 * pi * static_cast<float>(k) / columns;
        return Point(thick * std::cos(angle), thick * (1 + std::sin(angle)), t);
    });
}

RigidMesh make_tube_end() {
    static constexpr float z[] = {-4.0F, -0.5F, -0.5F, -0.10F, 0.0F, 0.0F, -0.15F, -0.9F, -0.9F};
    static constexpr float wide[] = {1.0F, 1.0F, 1.10F, 1.10F, 1.02F, 0.78F, 0.72F, 0.70F, 0.0F};
    return sweep(9, 16, true, 1, 0.5F, [](int i, int k) { return ring(k, 16, wide[i], z[i]); });
}

RigidMesh make_probe_end() {
    return sweep(10, 16, true, 1, 0.5F, [](int i, int k) {
        if (i == 0) return ring(k, 16, 1, -4);
        const float angle = 0.5F * pi * static_cast<float>(i - 1) / 8;
        return ring(k, 16, std::cos(angle), -1 + std::sin(angle));
    });
}

RigidMesh make_hook() {
    static constexpr float y[] = {0.0F, 0.0F, 0.0F, -0.5F, -1.1F, -1.35F, -1.3F, -0.9F, 0.0F, 0.0F};
    static constexpr float z[] = {-4.0F, -4.0F, -3.2F, -2.4F, -1.6F, -0.9F, -0.4F, -0.1F, 0.0F, 0.0F};
    static constexpr float wide[] = {0.0F, 0.95F, 0.9F, 0.45F, 0.32F, 0.30F, 0.30F, 0.28F, 0.16F, 0.0F};
    return sweep(10, 14, true, 1, 0.5F, [](int i, int k) {
        const int before = std::max(i - 1, 0), after = std::min(i + 1, 9);
        Point along(0, y[after] - y[before], z[after] - z[before]);
        along.normalize();
        const Point up(0, along.z(), -along.y());
        const float angle = 2 * pi * static_cast<float>(k) / 14;
        return Point(Point(0, y[i], z[i]) +
                     wide[i] * (std::cos(angle) * Point::UnitX() + std::sin(angle) * up));
    });
}

RigidMesh make_sphere() {
    constexpr int rows = 13, columns = 20;
    RigidMesh mesh = sweep(rows, columns, true, 1, 1, [](int i, int k) {
        const float angle = pi * static_cast<float>(i) / (rows - 1);
        return ring(k, columns, std::sin(angle), -std::cos(angle));
    });
    for (std::size_t v = 0; v < mesh.vertices.size(); v += 8) {
        for (std::size_t c = 0; c < 3; ++c) mesh.vertices[v + 3 + c] = mesh.vertices[v + c];
    }
    return mesh;
}

RigidMesh make_box(float width, float depth, float height) {
    RigidMesh mesh;
    const Point size(width, depth, height);
    for (int axis = 0; axis < 3; ++axis) {
        const int s = (axis + 1) % 3, t = (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 8);
            for (int corner = 0; corner < 4; ++corner) {
                Point p = Point::Zero(), n = Point::Zero();
                p[axis] = side == 0 ? 0 : size[axis];
                p[s] = corner == 1 || corner == 2 ? size[s] : 0;
                p[t] = corner >= 2 ? size[t] : 0;
                n[axis] = side == 0 ? 1.0F : -1.0F;
                for (const float value : {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), p[s], p[t]})
                    mesh.vertices.push_back(value);
            }
            for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + index);
        }
    }
    return mesh;
}

RigidMesh make_frame_mask() {
    RigidMesh mesh;
    constexpr std::uint32_t steps = 96;
    for (std::uint32_t k = 0; k < steps; ++k) {
        const float angle = 2 * pi * static_cast<float>(k) / steps;
        const float x = std::cos(angle), y = std::sin(angle);
        const float out = 1.01F / std::max(std::abs(x), std::abs(y));
        for (const float r : {1.0F, out}) {
            for (const float value : {r * x, r * y, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F})
                mesh.vertices.push_back(value);
        }
        const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % steps);
        for (const std::uint32_t index : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(index);
    }
    return mesh;
}

}  // namespace fulcrum::ui
