// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/walls.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double rectum_length = 0.13;  // m, without haustra

double smooth_step(double edge_0, double edge_1, double x) {
    const double u = std::clamp((x - edge_0) / (edge_1 - edge_0), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// Haustra with individual spacing: centres of the folds between them.
struct Haustra {
    std::vector<double> folds;   ///< m, rising
    std::vector<double> depths;  ///< share of the radius

    /// Share of the radius lost at x, deepest in a fold.
    double loss(double x) const {
        double sum = 0;
        const auto first = std::lower_bound(folds.begin(), folds.end(), x - 0.03);
        for (auto fold = first; fold != folds.end() && *fold < x + 0.03; ++fold) {
            const double u = (x - *fold) / 0.0075;
            sum += depths[static_cast<std::size_t>(fold - folds.begin())] * math::exp(-u * u);
        }
        return sum;
    }
};

Haustra make_haustra(const BowelParameters& p) {
    Haustra haustra;
    Random random(p.seed);
    double x = rectum_length;
    while (x < p.length - 0.01) {
        haustra.folds.push_back(x);
        haustra.depths.push_back(p.haustra_depth * (0.75 + 0.5 * random.uniform()));
        x += p.haustra_spacing * (0.85 + 0.3 * random.uniform());
    }
    return haustra;
}

/// 1 on the middle of a taenia, 0 between them; three of them around the tube.
double taenia(double angle) {
    const double nearest = std::abs(angle / (2.0 * pi / 3.0) - std::round(angle / (2.0 * pi / 3.0))) * (2.0 * pi / 3.0);
    return 1.0 - smooth_step(0.10, 0.30, nearest);
}

double surface_radius(const BowelParameters& p, const Haustra& haustra, double x, double angle) {
    const double colon = smooth_step(rectum_length - 0.03, rectum_length + 0.03, x);
    const double band = taenia(angle);
    const double fold = haustra.loss(x) * colon * (1.0 - band);
    const double bulge = 0.05 * colon * (1.0 - band) - 0.05 * colon * band;
    return p.radius * (1.0 + bulge - fold);
}

TriangleMesh make_surface(const BowelParameters& p, const Haustra& haustra) {
    TriangleMesh mesh;
    const int columns = 64;
    const int rows = std::max(16, p.vertices / columns);
    const int cap_rings = 5;
    const auto add_ring = [&](double x, double share) {
        for (int j = 0; j < columns; ++j) {
            const double angle = 2.0 * pi * j / columns;
            const double radius = share * surface_radius(p, haustra, x, angle);
            mesh.vertices.emplace_back(x, radius * math::cos(angle), radius * math::sin(angle));
            mesh.texture_coordinates.emplace_back(x / p.length, static_cast<double>(j) / columns);
        }
    };
    for (int k = 1; k < cap_rings; ++k) add_ring(0.0, static_cast<double>(k) / cap_rings);
    for (int i = 0; i < rows; ++i) add_ring(p.length * i / (rows - 1), 1.0);
    for (int k = cap_rings - 1; k >= 1; --k) add_ring(p.length, static_cast<double>(k) / cap_rings);
    const auto first_pole = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, 0);
    mesh.texture_coordinates.emplace_back(0.0, 0.5);
    mesh.vertices.emplace_back(p.length, 0, 0);
    mesh.texture_coordinates.emplace_back(1.0, 0.5);
    const int rings = rows + 2 * (cap_rings - 1);
    const auto at = [&](int i, int j) { return static_cast<std::int32_t>(i * columns + (j % columns)); };
    for (int i = 0; i + 1 < rings; ++i) {
        for (int j = 0; j < columns; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    for (int j = 0; j < columns; ++j) {
        mesh.triangles.push_back({first_pole, at(0, j + 1), at(0, j)});
        mesh.triangles.push_back({first_pole + 1, at(rings - 1, j), at(rings - 1, j + 1)});
    }
    if (enclosed_volume(mesh.vertices, mesh.triangles) < 0) {
        for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    }
    return mesh;
}

/// Catmull-Rom through the points, `steps` pieces a span.
std::vector<Vector3> spline(const std::vector<Vector3>& points, int steps) {
    std::vector<Vector3> line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector3& b = points[i];
        const Vector3& c = points[i + 1];
        const Vector3 a = i > 0 ? points[i - 1] : Vector3(2.0 * b - c);
        const Vector3 d = i + 2 < points.size() ? points[i + 2] : Vector3(2.0 * c - b);
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            line.push_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) + t * t * t * (3.0 * (b - c) + d - a)));
        }
    }
    line.push_back(points.back());
    return line;
}

double length_of(const std::vector<Vector3>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
}

std::vector<Vector3> equal_steps(const std::vector<Vector3>& line, int points) {
    std::vector<Vector3> result;
    const double total = length_of(line);
    double before = 0;
    std::size_t k = 0;
    for (int i = 0; i < points; ++i) {
        const double s = total * i / (points - 1);
        while (k + 2 < line.size() && before + (line[k + 1] - line[k]).norm() < s) {
            before += (line[k + 1] - line[k]).norm();
            ++k;
        }
        const double span = (line[k + 1] - line[k]).norm();
        const double u = span > 0 ? std::clamp((s - before) / span, 0.0, 1.0) : 0.0;
        result.push_back((1 - u) * line[k] + u * line[k + 1]);
    }
    return result;
}

/// The way of the bowel over the posterior wall for a width of the sigmoid's loops: rectum, promontory, loops, descending colon.
std::vector<Vector3> laid_line(const BowelParameters& p, const PelvisParameters& pelvis, double loop_width) {
    const double clearance = 1.10 * p.radius + 0.001;
    const auto on_wall = [&](double x, double y) { return Vector3(x, y, posterior_wall(pelvis, x, y) + clearance); };
    const double w = loop_width, pitch = 2.0 * p.radius * 1.30;
    const double y1 = 0.022, y2 = y1 + pitch, y3 = y2 + pitch, y4 = y3 + pitch;
    std::vector<Vector3> points;
    points.push_back(on_wall(0, -0.72 * pelvis.depth));
    points.push_back(on_wall(0, -0.45 * pelvis.depth));
    points.push_back(on_wall(0.002, -0.2 * pelvis.depth));
    points.push_back(on_wall(0.0, -0.002));
    points.push_back(on_wall(-0.45 * w, y1));
    points.push_back(on_wall(-0.85 * w, y1 + 0.004));
    points.push_back(on_wall(-w - 0.012, 0.5 * (y1 + y2)));
    points.push_back(on_wall(-0.85 * w, y2 - 0.002));
    points.push_back(on_wall(0, y2));
    points.push_back(on_wall(0.85 * w, y2 + 0.002));
    points.push_back(on_wall(w + 0.012, 0.5 * (y2 + y3)));
    points.push_back(on_wall(0.85 * w, y3));
    points.push_back(on_wall(0, y3));
    points.push_back(on_wall(-0.85 * w, y3));
    points.push_back(on_wall(-w - 0.012, 0.5 * (y3 + y4)));
    points.push_back(on_wall(-0.85 * w, y4));
    points.push_back(on_wall(0, y4));
    points.push_back(on_wall(0.6 * w, y4 + 0.004));
    points.push_back(on_wall(0.095, y4 + 0.008));
    return spline(points, 24);
}

}  // namespace

BowelShape make_bowel(const BowelParameters& p, const PelvisParameters& pelvis) {
    if (!(p.length >= 0.3 && p.length <= 2.0)) throw InputError("anatomy", "length", "out of range", "use 0.3 to 2 m");
    if (!(p.radius >= 0.008 && p.radius <= 0.03)) throw InputError("anatomy", "radius", "out of range", "use 0.008 to 0.03 m");
    BowelShape shape;
    const auto haustra = std::make_shared<const Haustra>(make_haustra(p));
    shape.surface = make_surface(p, *haustra);
    shape.length = p.length;
    shape.radius = [p, haustra](double s) {
        const double colon = smooth_step(rectum_length - 0.03, rectum_length + 0.03, s);
        return p.radius * (1.0 - 0.3 * haustra->loss(s) * colon);
    };
    double narrow = 0.005, wide = 0.5 * pelvis.abdomen_width - 0.03;
    if (length_of(laid_line(p, pelvis, narrow)) > p.length || length_of(laid_line(p, pelvis, wide)) < p.length) {
        throw InputError("anatomy", "length", "a bowel of this length and radius cannot be laid into this cavity", "change the length, or the cavity's width");
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (narrow + wide);
        (length_of(laid_line(p, pelvis, middle)) < p.length ? narrow : wide) = middle;
    }
    shape.centre_line = equal_steps(laid_line(p, pelvis, 0.5 * (narrow + wide)), 257);
    const double scale_error = std::abs(length_of(shape.centre_line) - p.length);
    if (scale_error > 0.01 * p.length) throw InputError("anatomy", "length", "the laid-out line misses the length asked", "change the length");

    // The root runs obliquely over the posterior wall, from the promontory to the left iliac fossa.
    std::vector<Vector3> root;
    for (int i = 0; i <= 64; ++i) {
        const double u = i / 64.0;
        const double x = 0.012 + 0.060 * u * u, y = -0.55 * pelvis.depth + (0.13 + 0.55 * pelvis.depth) * u;
        root.emplace_back(x, y, posterior_wall(pelvis, x, y));
    }
    shape.root_line = root;
    return shape;
}

}  // namespace fulcrum
