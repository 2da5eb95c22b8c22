// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/elastica.h"

#include <cmath>

namespace fulcrum::lab {
namespace {

struct Unknowns {
    double angle, moment, x, z;
};

Unknowns rate(const Cantilever& c, double s, const Unknowns& u) {
    // The section at s carries everything beyond it: a downward force, known because the loads are dead.
    const double force = -(c.distributed * (c.length - s) + c.tip_force);
    const double cosine = std::cos(u.angle), sine = std::sin(u.angle);
    const double stretch = c.axial_stiffness > 0 ? 1 + force * sine / c.axial_stiffness : 1;
    return {u.moment / c.bending_stiffness, -stretch * cosine * force, stretch * cosine, stretch * sine};
}

// Integrates from the tip back to the clamp; the angle there must vanish.
Unknowns shoot(const Cantilever& c, double tip_angle, int steps) {
    Unknowns u{tip_angle, 0, 0, 0};
    const double h = -c.length / steps;
    const auto ahead = [](const Unknowns& a, const Unknowns& k, double by) {
        return Unknowns{a.angle + by * k.angle, a.moment + by * k.moment, a.x + by * k.x, a.z + by * k.z};
    };
    for (int i = 0; i < steps; ++i) {
        const double s = c.length + i * h;
        const Unknowns k1 = rate(c, s, u), k2 = rate(c, s + h / 2, ahead(u, k1, h / 2));
        const Unknowns k3 = rate(c, s + h / 2, ahead(u, k2, h / 2)), k4 = rate(c, s + h, ahead(u, k3, h));
        u = {u.angle + h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
             u.moment + h / 6 * (k1.moment + 2 * k2.moment + 2 * k3.moment + k4.moment),
             u.x + h / 6 * (k1.x + 2 * k2.x + 2 * k3.x + k4.x),
             u.z + h / 6 * (k1.z + 2 * k2.z + 2 * k3.z + k4.z)};
    }
    return u;
}

}  // namespace

CantileverTip solve_cantilever(const Cantilever& cantilever, int steps) {
    // Continuation in the load, from 1: of several equilibria under a large load, selects the one that grows
    // from the straight rod. As the load grows the tip turns towards the vertical; from the last load's tip
    // angle on, steeper angles are tried until the angle at the clamp, which starts positive, changes sign.
    constexpr double vertical = 1.5707963267948966;
    const double l = cantilever.length;
    const double size =
        (cantilever.distributed * l + cantilever.tip_force) * l * l / cantilever.bending_stiffness;
    double above = vertical, angle = 0,
           part = size > 1 ? 1 / size : 1;  // above: of the tip over the vertical
    Unknowns clamp{};
    for (;;) {
        Cantilever c = cantilever;
        c.distributed *= part;
        c.tip_force *= part;
        double flat = above, steep = above;
        while (steep > 1e-12 && shoot(c, steep - vertical, steps).angle >= 0) {
            flat = steep;
            steep *= 0.9;
        }
        for (int i = 0; i < 100 && flat - steep > 1e-16; ++i) {
            const double middle = 0.5 * (steep + flat);
            clamp = shoot(c, middle - vertical, steps);
            (clamp.angle < 0 ? steep : flat) = middle;
        }
        above = 0.5 * (steep + flat);
        angle = above - vertical;
        clamp = shoot(c, angle, steps);
        if (part >= 1) break;
        part = part * 1.15 < 1 ? part * 1.15 : 1;
    }
    return {-clamp.x, -clamp.z, angle};
}

}  // namespace fulcrum::lab
