// SPDX-License-Identifier: Apache-2.0
// The cavity as a tube of sections along a bent axis, from the pelvic floor through the inlet into the
// insufflated abdomen. Each section is a superellipse with separate depths in front and behind, indented by
// spine, psoas, bladder and the vessels at the brim.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;

// One section: position along the tube, centre (y, z), tilt of its front-to-back direction, half width, depth
// behind and in front, all for a pelvis of 0.125 m width and 0.115 m depth.
struct Section {
    double at, y, z, tilt, half_width, behind, front;
};

constexpr std::array<Section, 9> sections = {{{0.00, -0.112, -0.018, -20, 0.042, 0.044, 0.040},
                                              {0.14, -0.078, -0.033, -10, 0.051, 0.050, 0.045},
                                              {0.29, -0.036, -0.024, 16, 0.058, 0.056, 0.050},
                                              {0.41, 0.000, 0.000, 34, 0.0625, 0.060, 0.058},
                                              {0.48, 0.022, 0.008, 31, 0.092, 0.066, 0.063},
                                              {0.55, 0.048, 0.018, 22, 0.126, 0.075, 0.070},
                                              {0.66, 0.095, 0.028, 8, 0.146, 0.084, 0.080},
                                              {0.80, 0.160, 0.030, 0, 0.150, 0.088, 0.085},
                                              {1.00, 0.285, 0.030, 0, 0.150, 0.088, 0.085}}};

struct Shape {
    double y = 0, z = 0, tilt = 0, half_width = 0, behind = 0, front = 0;
};

double component(const Section& s, int k) {
    switch (k) {
        case 0:
            return s.y;
        case 1:
            return s.z;
        case 2:
            return s.tilt;
        case 3:
            return s.half_width;
        case 4:
            return s.behind;
        default:
            return s.front;
    }
}

// Cubic Hermite through the stations, tangents from central differences.
double interpolate(double at, int k) {
    std::size_t i = 0;
    while (i + 2 < sections.size() && sections[i + 1].at <= at) ++i;
    const auto slope = [k](std::size_t j) {
        const std::size_t a = j > 0 ? j - 1 : 0, b = std::min(j + 1, sections.size() - 1);
        return (component(sections[b], k) - component(sections[a], k)) / (sections[b].at - sections[a].at);
    };
    const double span = sections[i + 1].at - sections[i].at;
    const double t = (at - sections[i].at) / span, t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * component(sections[i], k) + (t3 - 2 * t2 + t) * span * slope(i) +
           (3 * t2 - 2 * t3) * component(sections[i + 1], k) + (t3 - t2) * span * slope(i + 1);
}

double power(double x, double exponent) {
    return x <= 0 ? 0.0 : math::exp(exponent * math::log(x));
}
double bell(double x, double width) {
    return math::exp(-(x / width) * (x / width));
}

Shape shape_at(double at, const PelvisParameters& p) {
    Shape shape;
    shape.y = interpolate(at, 0);
    shape.z = interpolate(at, 1);
    shape.tilt = interpolate(at, 2) * pi / 180;
    // The bony pelvis scales with its own width, the abdomen above the brim with its own.
    const double above = smooth_step(0.42, 0.68, at);
    const double pelvis = p.width / 0.125, abdomen = p.abdomen_width / 0.30;
    shape.half_width = interpolate(at, 3) * ((1 - above) * pelvis + above * abdomen);
    const double depth_scale = (1 - above) * std::sqrt(pelvis) + above;
    shape.behind = interpolate(at, 4) * depth_scale;
    shape.front = interpolate(at, 5) * depth_scale;
    if (shape.y < 0) shape.y *= p.depth / 0.115;
    // Domes at both ends.
    const double floor_end = std::min(1.0, at / 0.13), top_end = std::min(1.0, (1 - at) / 0.13);
    const double dome = std::sqrt(std::max(0.0, 1 - (1 - floor_end) * (1 - floor_end))) *
                        std::sqrt(std::max(0.0, 1 - (1 - top_end) * (1 - top_end)));
    shape.half_width *= dome;
    shape.behind *= dome;
    shape.front *= dome;
    return shape;
}

// Indentation of the wall towards the axis, m; angle 0 is posterior, x the lateral position.
double pushed_in(double at, double angle, double x, const PelvisParameters& p) {
    const double back = smooth_step(0.0, 0.5, math::cos(angle));
    const double front = smooth_step(0.0, 0.6, -math::cos(angle));
    const double lumbar = smooth_step(0.36, 0.50, at);
    double in = 0;
    in += back * lumbar * 0.020 * bell(x, 0.026);  // spine, promontory
    const double psoas = smooth_step(0.46, 0.62, at);
    in += back * psoas * 0.010 * (bell(x - 0.052, 0.020) + bell(x + 0.052, 0.020));  // psoas
    in += front * 0.014 * bell(at - 0.34, 0.09) * bell(x, 0.04);                     // bladder
    const double side = std::abs(math::sin(angle));
    const double brim = 0.455 - 0.05 * math::cos(angle);
    in +=
        0.0055 * bell(at - brim, 0.022) * smooth_step(0.35, 0.7, side) * (p.width / 0.125);  // iliac vessels
    return in;
}

void check(const PelvisParameters& p) {
    const auto refuse = [](const char* place, const char* range) {
        throw InputError("pelvis parameters", place, "the value is out of range", range);
    };
    if (!(p.width >= 0.09 && p.width <= 0.16)) refuse("width", "give 0.09 to 0.16 m");
    if (!(p.depth >= 0.08 && p.depth <= 0.15)) refuse("depth", "give 0.08 to 0.15 m");
    if (!(p.abdomen_width >= 0.24 && p.abdomen_width <= 0.40)) refuse("abdomen_width", "give 0.24 to 0.40 m");
    if (p.triangles < 2000 || p.triangles > 200000) refuse("triangles", "give 2000 to 200000");
}

}  // namespace

CavityShape make_cavity(const PelvisParameters& parameters) {
    check(parameters);
    // Twice as many triangles as quads; the circumference is about 1.6 times the length.
    const int around =
        std::max(16, 4 * static_cast<int>(std::lround(std::sqrt(parameters.triangles / 2.0 * 1.6) / 4)));
    const int along = std::max(8, parameters.triangles / (2 * around) + 1);

    CavityShape cavity;
    TriangleMesh& mesh = cavity.mesh;
    const auto add = [&](const Vector3& point, double u, double v, double fat) {
        mesh.vertices.push_back(point);
        mesh.texture_coordinates.emplace_back(u, v);
        cavity.fat.push_back(static_cast<float>(std::clamp(fat, 0.0, 1.0)));
    };
    // Denser rows towards the ends, where the domes curve.
    const auto station = [along](int row) {
        const double t = static_cast<double>(row) / along;
        return 0.72 * t + 0.28 * (t * t * (3 - 2 * t));
    };
    const Shape floor = shape_at(0, parameters), top = shape_at(1, parameters);
    add(Vector3(0, floor.y, floor.z), 0.5, 0.0, 0.7);
    for (int row = 1; row < along; ++row) {
        const double at = station(row);
        const Shape s = shape_at(at, parameters);
        const Vector3 behind(0, math::sin(s.tilt), -math::cos(s.tilt));
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around;
            double sine = 0, cosine = 1;
            math::sin_cos(angle, sine, cosine);
            const double depth = cosine > 0 ? s.behind : s.front;
            // The flanks are flat posteriorly; the insufflated anterior wall is round.
            const double squareness =
                2.3 + 1.1 * smooth_step(0.45, 0.62, at) * smooth_step(-0.2, 0.3, cosine);
            double r = 1 / power(power(std::abs(sine) / s.half_width, squareness) +
                                     power(std::abs(cosine) / depth, squareness),
                                 1 / squareness);
            const double dome = std::min(1.0, std::min(s.half_width, depth) / 0.03);
            r -= dome * pushed_in(at, angle, r * sine, parameters);
            Vector3 point = Vector3(0, s.y, s.z) + r * (sine * Vector3::UnitX() + cosine * behind);
            const Vector3 outward = sine * Vector3::UnitX() + cosine * behind;
            const double rough = 0.0016 * noise3(point / 0.022, parameters.seed) +
                                 0.0007 * noise3(point / 0.009, parameters.seed + 1);
            point += dome * rough * outward;
            const double patches =
                noise3(point / 0.035, parameters.seed + 2) + 0.5 * noise3(point / 0.013, parameters.seed + 3);
            const double pelvic = 1 - smooth_step(0.36, 0.52, at);
            const double lateral = smooth_step(0.2, 0.9, std::abs(sine));
            const double spine = bell(r * sine, 0.02) * smooth_step(0, 0.5, cosine);
            add(point, static_cast<double>(k) / around, at,
                0.30 + 0.45 * patches + 0.25 * pelvic + 0.15 * lateral - 0.35 * spine);
        }
    }
    add(Vector3(0, top.y, top.z), 0.5, 1.0, 0.2);

    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    const auto at = [around](int row, int k) { return 1 + (row - 1) * around + k % around; };
    for (int k = 0; k < around; ++k) mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    for (int row = 1; row + 1 < along; ++row) {
        for (int k = 0; k < around; ++k) {
            const int a = at(row, k), b = at(row, k + 1), c = at(row + 1, k + 1), d = at(row + 1, k);
            if ((row + k) % 2 == 0) {
                mesh.triangles.push_back({a, c, b});
                mesh.triangles.push_back({a, d, c});
            } else {
                mesh.triangles.push_back({a, d, b});
                mesh.triangles.push_back({b, d, c});
            }
        }
    }
    for (int k = 0; k < around; ++k) mesh.triangles.push_back({last, at(along - 1, k + 1), at(along - 1, k)});
    if (enclosed_volume(mesh.vertices, mesh.triangles) < 0) {
        for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    }
    return cavity;
}

}  // namespace fulcrum
