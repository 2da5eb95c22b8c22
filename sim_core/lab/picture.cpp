// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fulcrum::lab {
namespace {

using Colour = std::array<float, 3>;

struct Canvas {
    int width, height;
    std::vector<float> depth;
    std::vector<Colour> pixels;
    Canvas(int w, int h)
        : width(w),
          height(h),
          depth(static_cast<std::size_t>(w * h), std::numeric_limits<float>::infinity()),
          pixels(static_cast<std::size_t>(w * h), Colour{1, 1, 1}) {}
    void put(int x, int y, float z, const Colour& colour) {
        if (x < 0 || y < 0 || x >= width || y >= height) return;
        const auto at = static_cast<std::size_t>(y * width + x);
        if (z >= depth[at]) return;
        depth[at] = z;
        pixels[at] = colour;
    }
};

struct Camera {
    Vector3 eye, right, up, forward;
    double scale, half_width, half_height;
    /// x, y in pixels, z the distance along the view.
    Vector3 project(const Vector3& point) const {
        const Vector3 d = point - eye;
        const double z = d.dot(forward);
        return {half_width + scale * d.dot(right) / z, half_height - scale * d.dot(up) / z, z};
    }
};

Colour lit(const Camera& camera, const Vector3& normal, const Vector3& point, const Colour& base) {
    const Vector3 view = (camera.eye - point).normalized();
    const Vector3 n = normal.dot(view) < 0 ? Vector3(-normal) : normal;
    const Vector3 key = (0.5 * camera.up - 0.35 * camera.right - 0.6 * camera.forward).normalized();
    const double diffuse = 0.16 + 0.30 * std::max(0.0, n.dot(view)) + 0.62 * std::max(0.0, n.dot(key));
    const double shine = 0.18 * std::pow(std::max(0.0, n.dot((key + view).normalized())), 40);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<float>(std::min(1.0, diffuse * static_cast<double>(base[c]) + shine));
    return colour;
}

void fill(Canvas& canvas, const Camera& camera, const ExperimentMesh& shown,
          const std::vector<Vector3>& normals) {
    const std::vector<Vector3>& vertices = shown.mesh.vertices;
    for (const Triangle& triangle : shown.mesh.triangles) {
        std::array<Vector3, 3> world, screen, normal;
        bool visible = true;
        for (std::size_t k = 0; k < 3; ++k) {
            world[k] = vertices[static_cast<std::size_t>(triangle[k])];
            screen[k] = camera.project(world[k]);
            visible = visible && world[k].allFinite() && screen[k].z() > 1e-4;
        }
        if (!visible) continue;
        const Vector3 face = area_vector(world[0], world[1], world[2]);
        for (std::size_t k = 0; k < 3; ++k)
            normal[k] = shown.smooth ? normals[static_cast<std::size_t>(triangle[k])] : face.normalized();
        const auto cross = [](const Vector3& a, const Vector3& b, double x, double y) {
            return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
        };
        const double whole = cross(screen[0], screen[1], screen[2].x(), screen[2].y());
        if (std::fabs(whole) < 1e-12) continue;
        const auto bound = [&](int axis, int limit, bool low) {
            const double a = screen[0][axis], b = screen[1][axis], c = screen[2][axis];
            const double value = low ? std::floor(std::min({a, b, c})) : std::ceil(std::max({a, b, c}));
            return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit - 1)));
        };
        for (int y = bound(1, canvas.height, true); y <= bound(1, canvas.height, false); ++y) {
            for (int x = bound(0, canvas.width, true); x <= bound(0, canvas.width, false); ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double u = cross(screen[1], screen[2], px, py) / whole,
                             v = cross(screen[2], screen[0], px, py) / whole, w = 1 - u - v;
                if (u < 0 || v < 0 || w < 0) continue;
                const double inverse = u / screen[0].z() + v / screen[1].z() + w / screen[2].z();
                const auto z = static_cast<float>(1 / inverse);
                if (z >= canvas.depth[static_cast<std::size_t>(y * canvas.width + x)]) continue;
                const Vector3 n = u * normal[0] + v * normal[1] + w * normal[2];
                const Vector3 point = u * world[0] + v * world[1] + w * world[2];
                canvas.put(x, y, z,
                           lit(camera, n.norm() > 0 ? Vector3(n.normalized()) : Vector3(Vector3::UnitZ()),
                               point, shown.colour));
            }
        }
    }
}

void edges(Canvas& canvas, const Camera& camera, const ExperimentMesh& shown) {
    for (const Triangle& triangle : shown.mesh.triangles) {
        for (std::size_t e = 0; e < 3; ++e) {
            if (triangle[e] > triangle[(e + 1) % 3]) continue;  // the neighbour draws it
            const Vector3 a = camera.project(shown.mesh.vertices[static_cast<std::size_t>(triangle[e])]);
            const Vector3 b =
                camera.project(shown.mesh.vertices[static_cast<std::size_t>(triangle[(e + 1) % 3])]);
            if (!a.allFinite() || !b.allFinite() || a.z() < 1e-4 || b.z() < 1e-4) continue;
            const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
            const int count = static_cast<int>(std::clamp(std::ceil(2 * length), 1.0, 8000.0));
            for (int i = 0; i <= count; ++i) {
                const Vector3 p = a + (b - a) * (static_cast<double>(i) / count);
                // A little nearer than the surface the edge lies on.
                const auto z = static_cast<float>(p.z() * (1 - 2e-3));
                for (int side = 0; side < 2; ++side)
                    canvas.put(static_cast<int>(p.x()) + side, static_cast<int>(p.y()), z, shown.colour);
            }
        }
    }
}

}  // namespace

Picture draw_panel(const ExperimentPanel& panel, int width, int height) {
    constexpr int sharp = 2;
    Canvas canvas(width * sharp, height * sharp);
    Camera camera;
    camera.eye = panel.eye;
    camera.forward = (panel.target - panel.eye).normalized();
    camera.right = camera.forward.cross(panel.up).normalized();
    camera.up = camera.right.cross(camera.forward);
    camera.half_width = 0.5 * canvas.width;
    camera.half_height = 0.5 * canvas.height;
    camera.scale = camera.half_height / std::tan(0.5 * panel.field_of_view);
    for (const ExperimentMesh& shown : panel.meshes) {
        if (shown.wireframe) {
            edges(canvas, camera, shown);
        } else {
            fill(canvas, camera, shown, vertex_normals(shown.mesh));
        }
    }
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.rgb.reserve(static_cast<std::size_t>(3 * width * height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0;
                for (int j = 0; j < sharp; ++j) {
                    for (int i = 0; i < sharp; ++i) {
                        sum += static_cast<double>(canvas.pixels[static_cast<std::size_t>(
                            (y * sharp + j) * canvas.width + x * sharp + i)][c]);
                    }
                }
                const double value = std::pow(std::clamp(sum / (sharp * sharp), 0.0, 1.0), 1 / 2.2);
                picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
            }
        }
    }
    return picture;
}

}  // namespace fulcrum::lab
