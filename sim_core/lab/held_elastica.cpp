// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/held_elastica.h"

#include <Eigen/Dense>
#include <cmath>

namespace fulcrum::lab {
namespace {

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// x, z, angle above the x axis, bending moment.
using Section = std::array<double, 4>;

struct Shooter {
    const HeldElastica& problem;
    int steps;

    // Forces are those of the part beyond on the part before, constant between holders.
    Section slope(const Section& at, double fx, double fz) const {
        const double c = std::cos(at[2]), s = std::sin(at[2]);
        const double stretch = 1 + (fx * c + fz * s) / problem.axial_stiffness;
        // Moment balance: M' = -(r' x F).y-component in the plane: shear times length.
        return {stretch * c, stretch * s, at[3] / problem.bending_stiffness, -stretch * (c * fz - s * fx)};
    }
    Section along(Section at, double length, double fx, double fz) const {
        const double h = length / steps;
        const auto moved = [](const Section& a, const Section& d, double by) {
            return Section{a[0] + by * d[0], a[1] + by * d[1], a[2] + by * d[2], a[3] + by * d[3]};
        };
        for (int i = 0; i < steps; ++i) {
            const Section k1 = slope(at, fx, fz), k2 = slope(moved(at, k1, 0.5 * h), fx, fz);
            const Section k3 = slope(moved(at, k2, 0.5 * h), fx, fz), k4 = slope(moved(at, k3, h), fx, fz);
            for (std::size_t n = 0; n < 4; ++n) at[n] += h / 6 * (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]);
        }
        return at;
    }
    // Unknowns at the start of each of the three spans: angle, moment, force; the start points of the spans
    // are known.
    Vector12 miss(const Vector12& unknown, double share, HeldElasticaSolution* solution) const {
        const double starts[4] = {0, problem.held_at[0], problem.held_at[1], problem.length};
        const auto place = [&](std::size_t point) {
            std::array<double, 2> at = {starts[point], 0};
            if (point == 1 || point == 2) {
                at[0] += share * problem.moved[point - 1][0];
                at[1] += share * problem.moved[point - 1][1];
            }
            return at;
        };
        Vector12 residual;
        residual[0] = unknown[0];  // the first clamp's angle
        for (std::size_t span = 0; span < 3; ++span) {
            const auto u = static_cast<Eigen::Index>(4 * span);
            const auto from = place(span), to = place(span + 1);
            const Section start = {from[0], from[1], unknown[u], unknown[u + 1]};
            const double length = starts[span + 1] - starts[span], middle = 0.5 * problem.length;
            const Section end = along(start, length, unknown[u + 2], unknown[u + 3]);
            residual[u + 1] = end[0] - to[0];
            residual[u + 2] = end[1] - to[1];
            residual[u + 3] = span < 2 ? end[2] - unknown[u + 4] : end[2];
            if (span < 2)
                residual[u + 4] = (end[3] - unknown[u + 5]) / problem.bending_stiffness * problem.length;
            if (solution == nullptr) continue;
            if (starts[span] < middle && middle <= starts[span + 1]) {
                const Section half = along(start, middle - starts[span], unknown[u + 2], unknown[u + 3]);
                solution->middle_x = half[0];
                solution->middle_z = half[1];
            }
            // Equilibrium of a held point: force beyond + reaction = force before.
            if (span < 2)
                solution->reaction[span] = {unknown[u + 2] - unknown[u + 6], unknown[u + 3] - unknown[u + 7]};
        }
        return residual;
    }
};

}  // namespace

HeldElasticaSolution solve_held_elastica(const HeldElastica& problem, int steps_a_span) {
    const Shooter shooter{problem, steps_a_span};
    HeldElasticaSolution solution;
    Vector12 unknown = Vector12::Zero();
    const double moment = problem.bending_stiffness / problem.length, force = moment / problem.length;
    constexpr int parts = 40;
    for (int part = 1; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        for (int iteration = 0; iteration < 20; ++iteration) {
            const Vector12 residual = shooter.miss(unknown, share, nullptr);
            if (residual.lpNorm<Eigen::Infinity>() < 1e-12) break;
            Matrix12 jacobian;
            for (Eigen::Index k = 0; k < 12; ++k) {
                const double scale = k % 4 == 0 ? 1 : k % 4 == 1 ? moment : force, change = 1e-6 * scale;
                Vector12 shifted = unknown;
                shifted[k] += change;
                jacobian.col(k) = (shooter.miss(shifted, share, nullptr) - residual) / change;
            }
            unknown -= jacobian.partialPivLu().solve(residual);
        }
    }
    solution.residual = shooter.miss(unknown, 1, &solution).lpNorm<Eigen::Infinity>();
    return solution;
}

}  // namespace fulcrum::lab
