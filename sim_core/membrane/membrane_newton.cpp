// SPDX-License-Identifier: Apache-2.0
// Minimises the incremental potential by Newton's method, with directions from conjugate gradients.
#include <algorithm>
#include <cmath>

#include "sim_core/membrane/membrane_system.h"

namespace fulcrum::membrane_detail {
namespace {

// y += a x over the free nodes.
void add_scaled(double a, const Lanes* x, Lanes* y, std::size_t count) {
    const Lanes scale = all_lanes(a);
    for (std::size_t i = 0; i < count; ++i) y[i] += scale * x[i];
}

/// Direction of the tangent system by conjugate gradients preconditioned with the multigrid cycle. If the
/// tangent is not positive the direction so far is kept, at least that of the cycle; then returns false.
bool conjugate_gradients(const Membrane::Tables& t, Data& d, double tolerance, int most,
                         MembraneReport& report) {
    const auto count = at(t.free);
    std::fill(d.direction.begin(), d.direction.end(), all_lanes(0));
    std::copy(d.gradient.begin(), d.gradient.begin() + static_cast<std::ptrdiff_t>(count),
              d.residual.begin());
    std::copy(d.residual.begin(), d.residual.begin() + static_cast<std::ptrdiff_t>(count),
              d.preconditioned.begin());
    apply_inverse(t, d, d.preconditioned.data());
    Lanes* p = d.search.data();
    std::copy(d.preconditioned.begin(), d.preconditioned.begin() + static_cast<std::ptrdiff_t>(count), p);
    std::fill(d.search.begin() + static_cast<std::ptrdiff_t>(count), d.search.end(), all_lanes(0));
    double product = dot(d.residual.data(), d.preconditioned.data(), count);
    const double start = product;
    for (int k = 0; k < most && product > tolerance * tolerance * start; ++k) {
        for (std::size_t i = 0; i < at(t.nodes); ++i) d.product[i] = all_lanes(d.inertia[i]) * p[i];
        multiply_tangent(t, d, p, d.product.data());
        const double curvature = dot(p, d.product.data(), count);
        ++report.inner_iterations;
        if (!(curvature > 1e-12 * dot(p, d.residual.data(), count))) {
            if (k == 0) std::copy(p, p + count, d.direction.begin());
            return false;
        }
        const double step = product / curvature;
        add_scaled(step, p, d.direction.data(), count);
        add_scaled(-step, d.product.data(), d.residual.data(), count);
        std::copy(d.residual.begin(), d.residual.begin() + static_cast<std::ptrdiff_t>(count),
                  d.preconditioned.begin());
        apply_inverse(t, d, d.preconditioned.data());
        const double next = dot(d.residual.data(), d.preconditioned.data(), count);
        const Lanes keep = all_lanes(next / product);
        for (std::size_t i = 0; i < count; ++i) p[i] = d.preconditioned[i] + keep * p[i];
        product = next;
    }
    return true;
}

}  // namespace

void minimise_newton(const Membrane::Tables& t, Data& d, int iterations, double tolerance,
                     MembraneReport& report) {
    const auto count = at(t.free);
    double value = potential(t, d, d.position.data(), d.gradient.data());
    report.converged = false;
    double last = 1;
    int idle = 0;
    for (report.iterations = 0; report.iterations < iterations; ++report.iterations) {
        report.residual = scaled_residual(t, d, d.position.data(), d.gradient.data());
        if (report.residual <= tolerance) {
            report.converged = true;
            break;
        }
        if (!std::isfinite(report.residual) || idle > 3) break;
        // This near, a Newton step without gain has reached rounding.
        if (report.residual < 1e-6 && report.residual > 0.5 * last && ++idle > 2) break;
        const double forcing = std::min(0.1, std::max(1e-8, 0.5 * std::min(report.residual, last)));
        last = report.residual;
        make_tangent(t, d.stiffness.data(), d.rest.data(), d.position.data(), false, d);
        if (!conjugate_gradients(t, d, forcing, 400, report)) {
            make_tangent(t, d.stiffness.data(), d.rest.data(), d.position.data(), true, d);
            conjugate_gradients(t, d, forcing, 400, report);
        }
        const double slope = -dot(d.gradient.data(), d.direction.data(), count);
        if (!(slope < 0)) break;
        double length = 1, next = 0;
        bool lower = false;
        for (int halving = 0; halving < 30; ++halving, length *= 0.5) {
            for (std::size_t i = 0; i < count; ++i)
                d.trial[i] = d.position[i] - all_lanes(length) * d.direction[i];
            for (std::size_t i = count; i < at(t.nodes); ++i) d.trial[i] = d.position[i];
            next = potential(t, d, d.trial.data(), d.trial_gradient.data());
            // Near the minimum, rounding hides the change of the value before that of the gradient.
            lower = next <= value + 1e-4 * length * slope ||
                    (std::abs(slope) < 1e-11 * std::abs(value) &&
                     dot(d.trial_gradient.data(), d.trial_gradient.data(), count) <
                         dot(d.gradient.data(), d.gradient.data(), count));
            if (lower) break;
        }
        if (!lower) {
            ++idle;
            if (idle > 1) break;
            // Rounding may make the direction of the tangent an ascent; that of the cycle never is.
            std::copy(d.gradient.begin(), d.gradient.begin() + static_cast<std::ptrdiff_t>(count),
                      d.direction.begin());
            apply_inverse(t, d, d.direction.data());
            for (std::size_t i = 0; i < count; ++i) d.trial[i] = d.position[i] - d.direction[i];
            next = potential(t, d, d.trial.data(), d.trial_gradient.data());
            if (!(next <= value)) break;
        }
        d.position.swap(d.trial);
        d.gradient.swap(d.trial_gradient);
        value = next;
    }
    report.potential = value;
    report.residual = scaled_residual(t, d, d.position.data(), d.gradient.data());
    report.converged = report.residual <= tolerance;
}

}  // namespace fulcrum::membrane_detail
