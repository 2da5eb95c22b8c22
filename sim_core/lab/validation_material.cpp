// SPDX-License-Identifier: Apache-2.0
// Material laws and layers of the wall through the rod: EXP2 in stretch and bending, composite stiffness,
// indentation.
#include <algorithm>
#include <cmath>

#include "sim_core/lab/validation_rooms.h"
#include "sim_core/material/layered_wall.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double outer = 0.015, inner = 0.012, length = 0.4;

RodSpec tube(MaterialLaw law, int segments) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = length;
    spec.outer_radius = outer;
    spec.inner_radius = inner;
    spec.law = law;
    spec.young_modulus = law == MaterialLaw::exp2 ? 30.0e3 : 32.3e3;
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    return spec;
}

double stress(MaterialLaw law, double strain) {
    const Rod rod(tube(law, 32));
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    inputs.ends[1].position.x() += strain * length;
    return rod.solve(state, inputs, scratch).end_force[1].x() / (pi * (outer * outer - inner * inner));
}

// Force and moment of the ring section by chords across it (Simpson's rule), independent of rings and angles.
void chords(double strain, double curvature, double& force, double& moment) {
    force = moment = 0;
    for (const double radius : {outer, -inner}) {
        const int steps = 400;
        for (int i = 0; i <= steps; ++i) {
            const double phi = pi * (static_cast<double>(i) / steps - 0.5), y = radius * std::sin(phi);
            const double weight = (i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2)) * pi / steps / 3;
            const double e = strain + curvature * y, sigma = 30.0e3 * e * std::exp(3 * e * e);
            const double chord = (radius > 0 ? 2 : -2) * std::pow(radius * std::cos(phi), 2);
            force += weight * sigma * chord;
            moment += weight * sigma * y * chord;
        }
    }
}

// The rod between frames of an arc, under the line load that keeps a stretched arc in balance.
double arc_moment(double strain, double curvature, double force) {
    const RodSpec spec = tube(MaterialLaw::exp2, 128);
    const Rod rod(spec);
    const double angle = curvature * length, radius = length * (1 + strain) / angle;
    std::vector<Vector3> nodes;
    RodInputs inputs;
    for (int i = 0; i <= spec.segments; ++i) {
        const double u = angle * i / spec.segments;
        nodes.emplace_back(radius * std::sin(u), radius * (1 - std::cos(u)), 0);
        inputs.nodal_forces.push_back(force * angle / spec.segments * Vector3(std::sin(u), -std::cos(u), 0));
    }
    RodState state = rod.make_state(nodes);
    for (Vector3& director : state.directors) director = Vector3::UnitZ();
    for (int e = 0; e < 2; ++e) {
        const double turned = e * angle;
        Matrix3& frame = state.ends[e].rotation;
        frame.col(2) = Vector3(std::cos(turned), std::sin(turned), 0);
        frame.col(0) = Vector3::UnitZ();
        frame.col(1) = frame.col(2).cross(Vector3(frame.col(0)));
        inputs.ends[e] = state.ends[e];
    }
    RodScratch scratch = rod.make_scratch();
    return rod.solve(state, inputs, scratch).end_moment[1].z();
}

void laws(std::vector<ValidationCase>& cases) {
    double worst = 0;
    for (int i = 1; i <= 50; ++i) {
        const double e = 0.012 * i;
        worst =
            std::max(worst, std::fabs(stress(MaterialLaw::exp2, e) / (30.0e3 * e * std::exp(3 * e * e)) - 1));
    }
    cases.push_back(absolute_case("rod", "EXP2, clamped rod stretched to 50 strains up to 60 %",
                                  "largest |stress over its formula - 1|", worst, 0,
                                  "sigma = E0 e exp(3 e^2), E0 = 30.0 kPa", 1e-8));
    const double over = stress(MaterialLaw::exp2, 0.22) / stress(MaterialLaw::linear, 0.22);
    cases.push_back(relative_case("rod", "EXP2 compared with linear (32.3 kPa) at 22 % strain",
                                  "stress, EXP2 over linear", over, 30.0 / 32.3 * std::exp(3 * 0.22 * 0.22),
                                  "the two formulas", 1e-8));
    double low = 0.2, high = 0.4;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (stress(MaterialLaw::exp2, middle) < 1.2 * stress(MaterialLaw::linear, middle) ? low : high) = middle;
    }
    cases.push_back(relative_case("rod", "EXP2 compared with linear, stretched",
                                  "strain where they part by 20 %", low,
                                  std::sqrt(std::log(1.2 * 32.3 / 30.0) / 3), "the two formulas", 1e-6));
    for (const double strain : {0.0, 0.12}) {
        double force, moment;
        chords(strain, 8, force, moment);
        cases.push_back(relative_case("rod",
                                      strain > 0 ? "EXP2, arc of 8 1/m stretched by 12 %, 128 segments"
                                                 : "EXP2, arc of 8 1/m, 128 segments",
                                      "end moment, N m", arc_moment(strain, 8, force), moment,
                                      "the law summed over chords of the section", 2e-3));
    }
}

// Small rectangles of every layer, each with its own moment and that of its distance (parallel axes).
void layers(std::vector<ValidationCase>& cases) {
    const std::vector<WallLayer> wall = bowel_wall_layers();
    const double rim = 0.016, poisson = 0.35;
    double ea = 0, ei = 0, gj = 0, top = rim;
    for (std::size_t k = wall.size(); k-- > 0;) {
        const int shells = 100, angles = 360;
        const double height = wall[k].thickness / shells;
        for (int r = 0; r < shells; ++r) {
            const double middle = top - (r + 0.5) * height, width = 2 * pi * middle / angles,
                         area = width * height;
            for (int t = 0; t < angles; ++t) {
                const double s = std::sin(2 * pi * (t + 0.5) / angles), c2 = 1 - s * s;
                const double own = area / 12 * (height * height * s * s + width * width * c2);
                ea += wall[k].young * area;
                ei += wall[k].young * (own + area * middle * middle * s * s);
                gj += wall[k].young / (2 * (1 + poisson)) * area * middle * middle;
            }
        }
        top -= wall[k].thickness;
    }
    RodSpec spec;
    spec.outer_radius = rim;
    spec.poisson_ratio = poisson;
    spec.layers = wall;
    const Rod rod(spec);
    const char* source = "layered beam: small pieces with parallel axes";
    cases.push_back(relative_case("wall", "rod of four layers", "stretching stiffness, N",
                                  rod.axial_stiffness(), ea, source, 1e-4));
    cases.push_back(relative_case("wall", "rod of four layers", "bending stiffness, N m2",
                                  rod.bending_stiffness(), ei, source, 1e-4));
    cases.push_back(relative_case("wall", "rod of four layers", "torsional stiffness, N m2",
                                  rod.torsional_stiffness(), gj, source, 1e-4));
}

// Depth of the layers in series under one pressure, each by bisection of its own law.
void indentation(std::vector<ValidationCase>& cases) {
    LayeredWallSpec spec;
    spec.nodule.height = 0.0005;
    spec.nodule.radius = 0.006;
    const LayeredWall wall(spec);
    const double nu = spec.poisson_ratio, factor = (1 - nu) / ((1 + nu) * (1 - 2 * nu)), pressure = 20e3;
    const auto squeezed = [&](double young, double exponent) {
        double low = 0, high = 10;
        for (int i = 0; i < 100; ++i) {
            const double e = 0.5 * (low + high);
            (factor * young * e * std::exp(exponent * e * e) < pressure ? low : high) = e;
        }
        return low;
    };
    double depth = pressure / spec.backing, over = 0;
    for (const WallLayer& layer : spec.layers)
        depth += layer.thickness * squeezed(layer.young, layer.exponent);
    over = depth + spec.nodule.height * (squeezed(spec.nodule.young, spec.nodule.exponent) -
                                         squeezed(spec.layers[0].young, spec.layers[0].exponent));
    double found, slope;
    wall.pressure_at(depth, 0, found, slope);
    cases.push_back(relative_case("wall", "pressed by 20 kPa", "pressure at that depth, Pa", found, pressure,
                                  "layers in series, each law by bisection", 2e-4));
    wall.pressure_at(over, spec.nodule.height, found, slope);
    cases.push_back(relative_case("wall", "pressed by 20 kPa over a nodule of 0.5 mm",
                                  "pressure at that depth, Pa", found, pressure,
                                  "layers in series, each law by bisection", 2e-4));
}

}  // namespace

std::vector<ValidationCase> material_validation() {
    std::vector<ValidationCase> cases;
    laws(cases);
    layers(cases);
    indentation(cases);
    return cases;
}

}  // namespace fulcrum::lab
