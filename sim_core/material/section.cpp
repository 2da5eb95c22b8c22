// SPDX-License-Identifier: Apache-2.0
#include "sim_core/material/section.h"

#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

// exp(v) - 1, cosh(z) - 1, sinh(z) / z and (cosh(z) - sinh(z) / z) / z^2 for z^2 = zeta.
struct Hyperbolic {
    Lanes rise, cosine, sine, third;
};

Hyperbolic hyperbolic(const Lanes& v, const Lanes& zeta) {
    // Series, each 1 + r_1 x (1 + r_2 x (...)) from the ratios of neighbouring terms; exact to rounding for
    // v <= 1/2 and zeta <= 1.
    Lanes e = all_lanes(1), c = e, s = e, t = e;
    for (int k = 15; k >= 2; --k) e = 1.0 + v * (1.0 / k) * e;
    for (int k = 9; k >= 1; --k) {
        c = 1.0 + zeta * (1.0 / ((2 * k + 1) * (2 * k + 2))) * c;
        s = 1.0 + zeta * (1.0 / ((2 * k) * (2 * k + 1))) * s;
        t = 1.0 + zeta * ((k + 1.0) / (k * (2.0 * k + 2) * (2.0 * k + 3))) * t;
    }
    Hyperbolic h{v * e, 0.5 * zeta * c, s, t * (1.0 / 3.0)};
    for (int lane = 0; lane < 4; ++lane) {
        if (v[lane] > 0.5) h.rise[lane] = math::exp(v[lane]) - 1.0;
        if (zeta[lane] > 1.0) {
            const double z = std::sqrt(zeta[lane]), up = math::exp(z), down = 1.0 / up;
            h.cosine[lane] = 0.5 * (up + down) - 1.0;
            h.sine[lane] = 0.5 * (up - down) / z;
            h.third[lane] = (h.cosine[lane] + 1.0 - h.sine[lane]) / zeta[lane];
        }
    }
    return h;
}

}  // namespace

TubeSection::TubeSection(const std::vector<WallLayer>& layers, double outer_radius) {
    (void)tube_stiffness(layers, outer_radius, 0.0);  // checks the layers
    // Gauss points in u = r^2, in which the area of a ring is uniform: 3 points integrate r^10 exactly.
    static const double place3[3] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
    static constexpr double weight3[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const std::size_t radii = layers.size() == 1 ? 3 : 1;
    double outer = outer_radius;
    for (std::size_t k = layers.size(); k-- > 0;) {
        const WallLayer& layer = layers[k];
        double inner = outer - layer.thickness;
        if (inner < 1e-12 * outer_radius) inner = 0;
        const double low = inner * inner, high = outer * outer, area = pi * (high - low);
        layers_.push_back({area, layer.young, layer.exponent});
        for (std::size_t r = 0; r < radii; ++r) {
            const double u = low + (high - low) * (radii == 3 ? place3[r] : 0.5);
            Ring ring;
            for (int q = 0; q < 4; ++q) {
                const double cosine = math::cos((2 * q + 1) * pi / 16);
                ring.height2[q] = u * cosine * cosine;
            }
            ring.area = area * (radii == 3 ? weight3[r] : 1.0) / 8;
            ring.young = layer.young;
            ring.exponent = layer.exponent;
            rings_.push_back(ring);
            points_ += 16;
        }
        outer = inner;
    }
}

AxialResponse TubeSection::axial(double strain) const {
    AxialResponse sum;
    for (const Layer& layer : layers_) {
        const double power = layer.exponent * strain * strain, less = exponential_less_one(power);
        const double stiff = layer.young * layer.area;
        sum.energy += 0.5 * stiff / layer.exponent * less;
        sum.force += stiff * strain * (1.0 + less);
        sum.tangent += stiff * (1.0 + 2.0 * power) * (1.0 + less);
    }
    return sum;
}

BendingResponse TubeSection::bending(double strain, double square) const {
    const double x = square > 0 ? square : 0, strain2 = strain * strain;
    Lanes energy = all_lanes(0), n = energy, m = energy, nn = energy, nm = energy, mm = energy;
    double grown = 1, exponent = -1;
    for (const Ring& ring : rings_) {
        const double a = ring.exponent;
        if (a != exponent) grown = 1.0 + exponential_less_one(a * strain2), exponent = a;
        const Lanes eta2 = ring.height2 * x, v = a * eta2;
        const double p = a * strain2;
        const Hyperbolic h = hyperbolic(v, 4.0 * p * v);
        const double scale = ring.young * ring.area * grown;
        const Lanes c = 1.0 + h.cosine, s = h.sine, t = h.third, g = scale * (1.0 + h.rise);
        const Lanes q = c + 2.0 * v * s, r = c + 2.0 * p * s, gy = g * ring.height2;
        energy += (scale / a) * (h.rise * c + h.cosine);
        n += (2.0 * scale * strain) * (h.rise * q + h.cosine + 2.0 * v * s);
        m += gy * r;
        nn += 2.0 * (g * (q * (1.0 + 2.0 * p) + 4.0 * p * v * (s + 2.0 * v * t)) - scale * (1.0 + 2.0 * p));
        nm += (a * strain) * gy * (2.0 * r + 4.0 * s + 4.0 * v * s + 8.0 * p * v * t);
        mm += a * (gy * ring.height2) * (c + 4.0 * p * s + 4.0 * p * p * t);
    }
    return {sum_lanes(energy), sum_lanes(n), sum_lanes(m), sum_lanes(nn), sum_lanes(nm), sum_lanes(mm)};
}

}  // namespace fulcrum
