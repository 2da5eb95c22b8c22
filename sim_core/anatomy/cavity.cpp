// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/walls.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double wall_height = 0.16, cranial_end = 0.21;  // m

double smooth_step(double edge_0, double edge_1, double x) {
    const double u = std::clamp((x - edge_0) / (edge_1 - edge_0), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

double bell(double x, double centre, double width) {
    const double u = (x - centre) / width;
    return math::exp(-u * u);
}

void check(bool fine, const std::string& name, const std::string& range) {
    if (!fine) throw InputError("anatomy", name, "out of range", "use " + range);
}

/// Half width of the cavity at height y.
double half_width(const PelvisParameters& p, double y) {
    const double pelvis = 0.5 * p.width * (0.80 + 0.20 * smooth_step(-p.depth, -0.2 * p.depth, y));
    return pelvis + (0.5 * p.abdomen_width - pelvis) * smooth_step(-0.005, 0.075, y);
}

/// Posterior wall in the median plane: sacral hollow, promontory, lumbar lordosis.
double posterior_median(const PelvisParameters& p, double y) {
    const double hollow = -0.062 * bell(y, -0.55 * p.depth, 0.45 * p.depth);
    const double promontory = 0.012 * bell(y, 0.004, 0.022);
    return -0.030 + 0.5 * hollow + promontory - 0.018 * smooth_step(0.02, 0.09, y);
}

double anterior_median(double y) {
    const double abdomen = wall_height - 0.045;
    return 0.040 + (abdomen - 0.040) * smooth_step(-0.06, 0.07, y);
}

}  // namespace

double posterior_wall(const PelvisParameters& p, double x, double y) {
    // Beside the spine the wall falls away into the paravertebral gutters, then rises to the flank.
    const double a = half_width(p, y);
    const double u = std::min(1.0, std::abs(x) / a);
    const double gutter = 0.016 * smooth_step(0.02, 0.10, y) * bell(std::abs(x), 0.5 * a, 0.035);
    const double flank = 0.075 * u * u * u * u;
    return posterior_median(p, y) - gutter + flank;
}

CavityShape make_cavity(const PelvisParameters& p) {
    check(p.width >= 0.09 && p.width <= 0.16, "width", "0.09 to 0.16 m");
    check(p.depth >= 0.08 && p.depth <= 0.15, "depth", "0.08 to 0.15 m");
    check(p.triangles >= 2000 && p.triangles <= 200000, "triangles", "2000 to 200000");
    const int columns = static_cast<int>(std::sqrt(0.54 * p.triangles)), rows = p.triangles / (2 * columns);
    CavityShape shape;
    TriangleMesh& mesh = shape.mesh;
    Random random(p.seed);
    double phase[6];
    for (double& value : phase) value = 2.0 * pi * random.uniform();

    const double bottom = -p.depth, top = cranial_end;
    // Rows crowd towards both ends, where the surface closes.
    const auto row_height = [&](int i) {
        const double u = (i + 0.5) / rows;
        return bottom + (top - bottom) * (u - 0.08 * math::sin(2.0 * pi * u) / (2.0 * pi) * 2.0);
    };
    const auto closing = [&](double y) {
        // Share of the full cross-section: an ellipsoidal cap at the pelvic floor and at the cranial end.
        const double from_floor = std::min(1.0, (y - bottom) / 0.045), from_top = std::min(1.0, (top - y) / 0.05);
        const double share_floor = std::sqrt(std::max(0.0, from_floor * (2.0 - from_floor)));
        const double share_top = std::sqrt(std::max(0.0, from_top * (2.0 - from_top)));
        return std::max(0.02, std::min(share_floor, share_top));
    };
    for (int i = 0; i < rows; ++i) {
        const double y = row_height(i);
        const double share = closing(y), a = half_width(p, y);
        const double front = anterior_median(y);
        for (int j = 0; j < columns; ++j) {
            const double angle = 2.0 * pi * j / columns;
            const double c = math::cos(angle), s = math::sin(angle);
            const double x = a * c;
            const double back = posterior_wall(p, x, y);
            const double level = posterior_wall(p, a, y);             // where front and back halves meet, at the flank
            const double middle = 0.5 * (posterior_wall(p, 0, y) + front);
            const double side = std::min(front - 0.01, std::max(level, middle - 0.02));
            double z = 0;
            if (s >= 0) {
                z = side + (front - side) * smooth_step(0.0, 0.85, s);
            } else {
                z = side + (back - side) * smooth_step(0.0, 0.75, -s);
            }
            const double uneven = 0.0012 * (math::sin(70 * y + phase[0]) * math::sin(3 * angle + phase[1]) + math::sin(130 * y + phase[2]) * math::sin(7 * angle + phase[3]));
            const double centre_z = 0.5 * (posterior_median(p, y) + front);
            Vector3 vertex(x * share, y, centre_z + (z - centre_z) * share);
            const Vector3 inward(-c, 0, -s);
            vertex += uneven * share * inward;
            mesh.vertices.push_back(vertex);
            mesh.texture_coordinates.emplace_back(10.0 * y, static_cast<double>(j) / columns * 6.0);
        }
    }
    const auto floor_pole = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, bottom, 0.5 * (posterior_median(p, bottom) + anterior_median(bottom)));
    mesh.texture_coordinates.emplace_back(10.0 * bottom, 3.0);
    const std::int32_t top_pole = floor_pole + 1;
    mesh.vertices.emplace_back(0, top, 0.5 * (posterior_median(p, top) + anterior_median(top)));
    mesh.texture_coordinates.emplace_back(10.0 * top, 3.0);

    const auto at = [&](int i, int j) { return static_cast<std::int32_t>(i * columns + (j % columns)); };
    for (int i = 0; i + 1 < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
        }
    }
    for (int j = 0; j < columns; ++j) {
        mesh.triangles.push_back({floor_pole, at(0, j), at(0, j + 1)});
        mesh.triangles.push_back({top_pole, at(rows - 1, j + 1), at(rows - 1, j)});
    }
    if (enclosed_volume(mesh.vertices, mesh.triangles) < 0) {
        for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    }
    shape.fat.assign(mesh.vertices.size(), 0.3F);
    return shape;
}

}  // namespace fulcrum
