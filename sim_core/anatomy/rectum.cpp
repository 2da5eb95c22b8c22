// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/rectum.h"

#include <algorithm>
#include <cmath>

#include "sim_core/anatomy/bowel_parts.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int line_points = 181;
constexpr double below = 0.025;          // m by which the wall continues the curve beyond the caudal end
constexpr double above = 0.050;          // m by which it continues straight from the promontory
constexpr double fall = 0.4;             // rad by which that part and the brims slope posteriorly
constexpr double hollow = 1.25;          // rad to either side, where the trough ends
constexpr double brim = 0.035;           // m by which it continues from there, straight to the side
constexpr double wall_spacing = 0.0035;  // m

void check(const RectumParameters& p) {
    const auto refuse = [](const char* place, const char* range) {
        throw InputError("rectum parameters", place, "the value is out of range", range);
    };
    if (!(p.length >= 0.05 && p.length <= 0.3)) refuse("length", "give 0.05 to 0.3 m");
    if (!(p.curve.rectum_radius >= 0.005 && p.curve.rectum_radius <= 0.03))
        refuse("rectum_radius", "give 0.005 to 0.03 m");
    if (!(p.curve.gap >= 0.002 && p.curve.gap <= 0.05)) refuse("gap", "give 0.002 to 0.05 m");
    if (!(p.curve.curve_radius >= 1.5 * p.curve.fascia_radius() && p.curve.curve_radius <= 10))
        refuse("curve_radius", "give at least 1.5 times the fascia's distance from the centre line");
    if (!(p.promontory > 0 && p.promontory <= p.length))
        refuse("promontory", "give an arc length on the rectum");
    if (!(p.length <= 3 * p.curve.curve_radius)) refuse("length", "give less than three radii of the curve");
    if (!(p.unevenness >= 0 && p.unevenness <= 0.003)) refuse("unevenness", "give 0 to 0.003 m");
    if (p.vertices < 200 || p.vertices > 200000) refuse("vertices", "give 200 to 200000");
    if (!p.curve.centre.allFinite() || !std::isfinite(p.curve.caudal_angle))
        refuse("centre", "give finite numbers");
}

}  // namespace

Vector3 SacralCurve::posterior(double s) const {
    double sine = 0, cosine = 1;
    math::sin_cos(angle(s), sine, cosine);
    return {0, sine, -cosine};
}

Vector3 SacralCurve::cranial(double s) const {
    double sine = 0, cosine = 1;
    math::sin_cos(angle(s), sine, cosine);
    return {0, cosine, sine};
}

Vector3 SacralCurve::centre_line(double s) const {
    return centre + curve_radius * posterior(s);
}

Vector3 SacralCurve::point(double s, double turn, double height) const {
    double sine = 0, cosine = 1;
    math::sin_cos(turn, sine, cosine);
    const double distance = fascia_radius() - height;
    return centre + (curve_radius + distance * cosine) * posterior(s) + distance * sine * Vector3::UnitX();
}

BowelShape make_rectum(const RectumParameters& p) {
    check(p);
    BowelShape shape;
    shape.length = p.length;
    const double radius = p.curve.rectum_radius, circumference = 2 * pi * radius;
    const int around =
        std::max(12, 6 * static_cast<int>(std::lround(std::sqrt(p.vertices * circumference / p.length) / 6)));
    const int rings = std::max(8, p.vertices / around);
    const double dome = 0.6 * radius;  // m of each end that is rounded
    TriangleMesh& mesh = shape.surface;
    const auto add = [&](double s, double r, double u) {
        double sine = 0, cosine = 1;
        math::sin_cos(2 * pi * u, sine, cosine);
        mesh.vertices.emplace_back(s, r * cosine, r * sine);
        mesh.texture_coordinates.emplace_back(u, s / circumference);
        shape.taenia.push_back(0);
    };
    add(0, 0, 0.5);
    for (int i = 0; i < rings; ++i) {
        const double s = p.length * (i + 0.5) / rings;
        const double from_end = std::min(1.0, std::min(s, p.length - s) / dome);
        const double rounded = std::sqrt(1 - (1 - from_end) * (1 - from_end));
        for (int k = 0; k < around; ++k) add(s, radius * rounded, static_cast<double>(k) / around);
    }
    add(p.length, 0, 0.5);
    add_capped_tube(rings, around, mesh);
    shape.radius = [radius](double) { return radius; };
    for (int i = 0; i < line_points; ++i)
        shape.centre_line.push_back(p.curve.centre_line(p.length * i / (line_points - 1)));
    return shape;
}

TriangleMesh make_presacral_wall(const RectumParameters& p) {
    check(p);
    const SacralCurve& curve = p.curve;
    const auto count = [](double length) { return static_cast<int>(std::ceil(length / wall_spacing)); };
    const double stretch = (curve.curve_radius + curve.fascia_radius()) / curve.curve_radius;
    const int curved = count((p.promontory + below) * stretch), straight = count(above);
    const int arc = count(hollow * curve.fascia_radius()), side = count(brim);
    double sine = 0, cosine = 1;
    math::sin_cos(fall, sine, cosine);
    const Vector3 onwards = cosine * curve.cranial(p.promontory) + sine * curve.posterior(p.promontory);
    TriangleMesh mesh;
    for (int r = 0; r <= curved + straight; ++r) {
        const double s = std::min(p.promontory, (p.promontory + below) * r / curved - below);
        const Vector3 shift = above * std::max(0, r - curved) / straight * onwards;
        for (int c = -arc - side; c <= arc + side; ++c) {
            const double turn = hollow * std::clamp(c, -arc, arc) / arc;
            const double out = brim * (c - std::clamp(c, -arc, arc)) / side;
            const Vector3 beside =
                out * cosine * Vector3::UnitX() + std::abs(out) * sine * curve.posterior(s);
            const Vector3 smooth = curve.point(s, turn, 0) + shift + beside;
            const double deeper =
                0.5 * p.unevenness * (1 + std::clamp(noise3(smooth / 0.012, p.seed), -1.0, 1.0));
            mesh.vertices.push_back(smooth + curve.point(s, turn, -deeper) - curve.point(s, turn, 0));
        }
    }
    const std::int32_t columns = 2 * (arc + side);
    for (std::int32_t r = 0; r < curved + straight; ++r) {
        for (std::int32_t c = 0; c < columns; ++c) {
            const std::int32_t a = r * (columns + 1) + c, b = a + 1, d = a + columns + 1, e = d + 1;
            // Columns to the left, rows cranially: this orientation faces the rectum.
            mesh.triangles.push_back({a, b, e});
            mesh.triangles.push_back({a, e, d});
        }
    }
    return mesh;
}

}  // namespace fulcrum
