// SPDX-License-Identifier: Apache-2.0
// Position of the bowel: a path over the coronal plane, dropped onto the posterior wall as a chain of spheres
// would rest there, and the root of its mesentery on the wall beneath.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/anatomy/bowel_parts.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/anatomy/posterior_wall.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

using Point = Eigen::Vector2d;

constexpr int line_points = 361;
constexpr double clearance = 0.0008;  // m between the spheres and the wall

// Way-points over the coronal plane, m: rectum, promontory, sigmoid loop, left iliac fossa, left gutter.
// `loop` scales the sigmoid about the promontory.
std::vector<Point> way_points(double loop, double width_scale, double depth_scale) {
    constexpr std::array<std::array<double, 3>, 24> points = {
        {{0.000, -0.086, 0},  {0.006, -0.064, 0},   {-0.007, -0.038, 0}, {0.006, -0.008, 0},
         {0.000, 0.020, 0},   {-0.030, 0.042, 0.6}, {-0.066, 0.050, 1},  {-0.100, 0.066, 1},
         {-0.112, 0.100, 1},  {-0.106, 0.138, 1},   {-0.082, 0.172, 1},  {-0.042, 0.184, 1},
         {0.000, 0.178, 1},   {0.032, 0.160, 1},    {0.042, 0.128, 1},   {0.024, 0.100, 0.8},
         {0.014, 0.074, 0.5}, {0.036, 0.046, 0.2},  {0.074, 0.040, 0.1}, {0.102, 0.062, 0.1},
         {0.108, 0.102, 0.1}, {0.112, 0.142, 0.1},  {0.116, 0.180, 0},   {0.110, 0.226, 0}}};
    std::vector<Point> result;
    for (const auto& p : points) {
        const double factor = 1 + p[2] * (loop - 1);
        const double y =
            p[1] < 0 ? p[1] * depth_scale : 0.02 + (p[1] - 0.02) * (p[1] > 0.02 ? 0.5 + 0.5 * factor : 1.0);
        result.emplace_back(p[0] * factor * (p[0] > 0 ? width_scale : 1.0), y);
    }
    return result;
}

// Uniform cubic B-spline near the points: no bend is tighter than the spacing of the points.
std::vector<Point> smooth_path(const std::vector<Point>& points, int per_span) {
    std::vector<Point> control;
    control.push_back(2 * points.front() - points[1]);
    control.insert(control.end(), points.begin(), points.end());
    control.push_back(2 * points.back() - points[points.size() - 2]);
    std::vector<Point> path;
    for (std::size_t i = 0; i + 3 < control.size(); ++i) {
        const int count = i + 4 == control.size() ? per_span + 1 : per_span;
        for (int k = 0; k < count; ++k) {
            const double t = static_cast<double>(k) / per_span, t2 = t * t, t3 = t2 * t;
            path.push_back(((1 - 3 * t + 3 * t2 - t3) * control[i] + (4 - 6 * t2 + 3 * t3) * control[i + 1] +
                            (1 + 3 * t + 3 * t2 - 3 * t3) * control[i + 2] + t3 * control[i + 3]) /
                           6);
        }
    }
    return path;
}

// Smooths a series of numbers; its ends are unchanged.
void smooth(std::vector<double>& values, int passes) {
    std::vector<double> next = values;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 1; i + 1 < values.size(); ++i)
            next[i] = 0.25 * values[i - 1] + 0.5 * values[i] + 0.25 * values[i + 1];
        std::swap(values, next);
    }
}

// Drops the path onto the wall: not below the resting height of a chain of spheres, and as smooth as a bowel
// bends.
std::vector<Vector3> drop(const std::vector<Point>& path, const PosteriorWall& wall, double radius) {
    std::vector<double> floor;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(path.size() - 1);
        floor.push_back(wall.resting_height(path[i].x(), path[i].y(), radius * bowel_width(share)) +
                        clearance);
    }
    std::vector<double> height = floor;
    constexpr int smoothing_passes = 120, lifting_rounds = 12;
    smooth(height, smoothing_passes);
    for (int round = 0; round < lifting_rounds; ++round) {
        // The part below the wall is added back, equally smoothed.
        std::vector<double> lack(height.size());
        for (std::size_t i = 0; i < height.size(); ++i) lack[i] = 1.6 * std::max(0.0, floor[i] - height[i]);
        smooth(lack, smoothing_passes / 2);
        for (std::size_t i = 0; i < height.size(); ++i) height[i] += lack[i];
    }
    std::vector<Vector3> line;
    for (std::size_t i = 0; i < path.size(); ++i) line.emplace_back(path[i].x(), path[i].y(), height[i]);
    return line;
}

double length_of(const std::vector<Vector3>& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
    return sum;
}

// The first `length` metres of a line, as points at equal arc length.
std::vector<Vector3> cut_to_length(const std::vector<Vector3>& line, double length, int points) {
    std::vector<double> along(line.size(), 0.0);
    for (std::size_t i = 1; i < line.size(); ++i) along[i] = along[i - 1] + (line[i] - line[i - 1]).norm();
    std::vector<Vector3> result;
    std::size_t k = 0;
    for (int i = 0; i < points; ++i) {
        const double s = length * i / (points - 1);
        while (k + 2 < line.size() && along[k + 1] < s) ++k;
        result.push_back(line[k] + (s - along[k]) / (along[k + 1] - along[k]) * (line[k + 1] - line[k]));
    }
    return result;
}

// Root of the sigmoid mesentery: from the sacrum up to the left of the promontory and down to the left fossa.
Point root_of_loop(double share) {
    constexpr std::array<std::array<double, 3>, 5> points = {{{0.0, 0.000, 0.010},
                                                              {0.30, 0.004, 0.052},
                                                              {0.55, 0.020, 0.074},
                                                              {0.8, 0.060, 0.082},
                                                              {1.0, 0.088, 0.110}}};
    std::size_t i = 0;
    while (i + 2 < points.size() && points[i + 1][0] <= share) ++i;
    const double t = (share - points[i][0]) / (points[i + 1][0] - points[i][0]);
    return {points[i][1] + t * (points[i + 1][1] - points[i][1]),
            points[i][2] + t * (points[i + 1][2] - points[i][2])};
}

}  // namespace

void lay_bowel(const BowelParameters& p, const CavityShape& cavity, BowelShape& bowel) {
    const PosteriorWall wall(cavity.mesh);
    double left = 0, lowest = 0;
    for (const Vector3& v : cavity.mesh.vertices) {
        left = std::max(left, v.x());
        lowest = std::min(lowest, v.y());
    }
    const double width_scale = left / 0.150, depth_scale = lowest / -0.112;
    const auto line_for = [&](double loop) {
        return drop(smooth_path(way_points(loop, width_scale, depth_scale), 24), wall, p.radius);
    };
    // The sigmoid takes up the remaining length.
    double low = 0.35, high = 1.45;
    if (length_of(line_for(low)) > p.length || length_of(line_for(high)) < p.length)
        throw InputError("bowel parameters", "length",
                         QT_TRANSLATE_NOOP("errors", "a bowel of this length does not fit this cavity"),
                         QT_TRANSLATE_NOOP("errors", "give a length nearer to 0.9 m"));
    for (int i = 0; i < 24; ++i) {
        const double middle = 0.5 * (low + high);
        (length_of(line_for(middle)) < p.length ? low : high) = middle;
    }
    const std::vector<Vector3> line = line_for(high);
    bowel.centre_line = cut_to_length(line, p.length, line_points);

    std::vector<double> root_x, root_y;
    for (std::size_t i = 0; i < bowel.centre_line.size(); ++i) {
        const double share = static_cast<double>(i) / (line_points - 1);
        const Vector3& c = bowel.centre_line[i];
        // Rectum and descending colon are attached posteriorly; the sigmoid is suspended from its short root.
        const double free = smooth_step(0.14, 0.30, share) * (1 - smooth_step(0.80, 0.96, share));
        const Point own(c.x() * 0.92, c.y());
        const Point root =
            (1 - free) * own + free * root_of_loop(std::clamp((share - 0.14) / 0.82, 0.0, 1.0));
        root_x.push_back(root.x());
        root_y.push_back(root.y());
    }
    smooth(root_x, 150);
    smooth(root_y, 150);
    std::vector<double> root_z;
    for (std::size_t i = 0; i < root_x.size(); ++i)
        root_z.push_back(wall.height(root_x[i], root_y[i]) + 0.001);
    smooth(root_z, 12);  // removes the steps of the wall raster
    for (std::size_t i = 0; i < root_x.size(); ++i)
        bowel.root_line.emplace_back(root_x[i], root_y[i], root_z[i]);
}

BowelShape make_bowel(const BowelParameters& parameters, const CavityShape& cavity) {
    BowelShape bowel;
    make_bowel_surface(parameters, bowel);
    lay_bowel(parameters, cavity, bowel);
    return bowel;
}

BowelShape make_bowel(const BowelParameters& parameters, const PelvisParameters& pelvis) {
    return make_bowel(parameters, make_cavity(pelvis));
}

}  // namespace fulcrum
