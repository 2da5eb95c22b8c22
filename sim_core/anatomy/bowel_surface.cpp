// SPDX-License-Identifier: Apache-2.0
// The colon at rest: three taeniae, and between them haustra separated by semilunar folds that are offset
// from one sector to the next. The rectum has neither.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/anatomy/bowel_parts.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int sectors = 3;

double bell(double x, double width) {
    return math::exp(-(x / width) * (x / width));
}

// Fold positions of one sector, m, and how deep each is.
struct Folds {
    std::vector<double> at, depth;
};

Folds make_folds(const BowelParameters& p, Random& random) {
    Folds folds;
    double s = -p.haustra_spacing * random.uniform(0.0, 1.0);
    while (s < p.length + p.haustra_spacing) {
        folds.at.push_back(s);
        folds.depth.push_back(random.uniform(0.65, 1.0));
        s += p.haustra_spacing * random.uniform(0.72, 1.28);
    }
    return folds;
}

// 1 on a fold, falling steeply and then gently to 0 in the middle of a haustrum.
double crease(const Folds& folds, double s, double spacing) {
    const auto next = std::upper_bound(folds.at.begin(), folds.at.end(), s);
    double result = 0;
    const auto look = [&](std::ptrdiff_t i) {
        if (i < 0 || i >= static_cast<std::ptrdiff_t>(folds.at.size())) return;
        const auto k = static_cast<std::size_t>(i);
        const double d = std::abs(s - folds.at[k]) / spacing;
        const double shape = 0.62 * bell(d, 0.085) + 0.38 * bell(d, 0.22);
        result = std::max(result, folds.depth[k] * shape);
    };
    const auto i = next - folds.at.begin();
    look(i - 1);
    look(i);
    return result;
}

void check(const BowelParameters& p) {
    const auto refuse = [](const char* place, const char* range) {
        throw InputError("bowel parameters", place, "the value is out of range", range);
    };
    if (!(p.length >= 0.6 && p.length <= 1.2)) refuse("length", "give 0.6 to 1.2 m");
    if (!(p.radius >= 0.010 && p.radius <= 0.022)) refuse("radius", "give 0.010 to 0.022 m");
    if (p.vertices < 1000 || p.vertices > 200000) refuse("vertices", "give 1000 to 200000");
    if (!(p.haustra_spacing >= 0.02 && p.haustra_spacing <= 0.06))
        refuse("haustra_spacing", "give 0.02 to 0.06 m");
    if (!(p.haustra_depth >= 0 && p.haustra_depth <= 0.4)) refuse("haustra_depth", "give 0 to 0.4");
    if (!(p.taenia_width >= 0.003 && p.taenia_width <= 0.012))
        refuse("taenia_width", "give 0.003 to 0.012 m");
}

}  // namespace

double bowel_width(double share) {
    return 1.0 + 0.12 * bell(share - 0.05, 0.07) - 0.07 * bell(share - 0.2, 0.06) +
           0.04 * bell(share - 0.95, 0.15);
}

void add_capped_tube(int rings, int around, TriangleMesh& mesh) {
    const int last = 1 + rings * around;
    const auto at = [around](int ring, int k) { return 1 + ring * around + k % around; };
    for (int k = 0; k < around; ++k) mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    for (int i = 0; i + 1 < rings; ++i) {
        for (int k = 0; k < around; ++k) {
            const int a = at(i, k), b = at(i, k + 1), c = at(i + 1, k + 1), d = at(i + 1, k);
            if ((i + k) % 2 == 0) {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, c, d});
            }
        }
    }
    for (int k = 0; k < around; ++k) mesh.triangles.push_back({last, at(rings - 1, k), at(rings - 1, k + 1)});
}

void make_bowel_surface(const BowelParameters& p, BowelShape& bowel) {
    check(p);
    bowel.length = p.length;
    const double circumference = 2 * pi * p.radius;
    // Quads about as long as they are wide.
    const int around =
        std::max(12, 6 * static_cast<int>(std::lround(std::sqrt(p.vertices * circumference / p.length) / 6)));
    const int rings = std::max(8, p.vertices / around);

    std::array<Folds, sectors> folds;
    for (std::size_t sector = 0; sector < sectors; ++sector) {
        Random random(p.seed, 40 + sector);
        folds[sector] = make_folds(p, random);
    }
    // The ends are domes of this length inside 0 .. length.
    const double dome = 0.6 * p.radius;
    TriangleMesh& mesh = bowel.surface;
    const auto add = [&](double x, double radius, double u, double taenia) {
        double sine = 0, cosine = 1;
        math::sin_cos(2 * pi * u, sine, cosine);
        mesh.vertices.emplace_back(x, radius * cosine, radius * sine);
        mesh.texture_coordinates.emplace_back(u, x / circumference);
        bowel.taenia.push_back(static_cast<float>(taenia));
    };
    const auto radius_of = [&](double s, double u, double& taenia) {
        const double mean = p.radius * bowel_width(s / p.length);
        // Sectors are between the taeniae at 1/6, 3/6, 5/6.
        const double turned = 3 * (u + 1.0 / 6.0);
        const double across = turned - std::floor(turned);  // 0 and 1: on a taenia is at 1/6 -> turned 1
        const auto sector = static_cast<std::size_t>(static_cast<int>(std::floor(turned)) % sectors);
        const double off_taenia = std::min(across, 1 - across) * 2 * pi * p.radius / 3;
        taenia = 1 - smooth_step(0.35 * p.taenia_width, 0.62 * p.taenia_width, off_taenia);
        const double colon = smooth_step(0.08, 0.17, s / p.length);
        const double middle = smooth_step(0.0, 0.42, std::min(across, 1 - across));
        const double fold = crease(folds[sector], s, p.haustra_spacing);
        double factor = 1 + colon * (0.085 * middle * (1 - fold) - 0.055 * (1 - middle) -
                                     p.haustra_depth * fold * (0.2 + 0.8 * middle));
        const Vector3 place(s / 0.02, 2.5 * across, static_cast<double>(sector) * 7.0);
        factor += 0.012 * noise3(place, p.seed + 9) * (2.5 * middle * (1 - middle) + 0.2);
        taenia *= 0.25 + 0.75 * colon;
        return mean * factor;
    };
    double taenia = 0;
    add(0, 0, 0.5, 0);
    for (int i = 0; i < rings; ++i) {
        // First and last rings are on the domes, near the poles.
        const double s = p.length * (i + 0.5) / rings;
        const double from_end = std::min(1.0, std::min(s, p.length - s) / dome);
        const double rounded = std::sqrt(1 - (1 - from_end) * (1 - from_end));
        for (int k = 0; k < around; ++k) {
            const double u = static_cast<double>(k) / around;
            const double radius = radius_of(s, u, taenia) * rounded;
            add(s, radius, u, taenia);
        }
    }
    add(p.length, 0, 0.5, 0);

    add_capped_tube(rings, around, mesh);

    const BowelParameters copy = p;
    bowel.radius = [copy](double s) {
        return copy.radius * bowel_width(std::clamp(s / copy.length, 0.0, 1.0));
    };
}

}  // namespace fulcrum
