// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod_newton.h"

#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr int free_changes =
    10;  // Newton steps in which contacts may switch without a decrease of the merit (active set)
constexpr double contact_tolerance = 1e-6;  // m, multiplier change over penalty
constexpr double near_target = 1e-3;        // m
constexpr double free_motion = 1e-12;       // of the bending stiffness of a segment
constexpr double largest_turn = 1.0;        // of a segment's edge, relative to its length, in one step

double reaction_scale(const RodScratch::Data& data) {
    double squared = data.reaction_squared;
    const std::size_t last = 4 * (data.matrix.blocks() - 1);
    for (std::size_t e = 0; e < 2; ++e) {
        if (!data.fixed[e]) continue;
        const double* g = &data.gradient[e == 0 ? 0 : last];
        squared += g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    }
    const double reactions = std::sqrt(squared),
                 acting = reactions > data.dead_norm ? reactions : data.dead_norm;
    if (acting > 0 || data.dt <= 0) return acting;
    // No external action: a free flight is measured by the force that would stop it within the step.
    Lanes sum = all_lanes(0);
    for (std::size_t i = 0; i < data.inertia.size(); i += 4) {
        const Lanes carried = load_lanes(&data.inertia[i]) *
                              (load_lanes(&data.predicted[i]) - load_lanes(&data.start.position[i]));
        sum += carried * carried;
    }
    return std::sqrt(sum_lanes(sum));
}

double boundary_distance(const RodShape& shape, const RodScratch::Data& data) {
    double largest = 0;
    const std::size_t last = 4 * (data.matrix.blocks() - 1);
    for (std::size_t e = 0; e < 2; ++e) {
        if (!data.fixed[e]) continue;
        const double* p = &shape.position[e == 0 ? 0 : last];
        const double away = (Vector3(p[0], p[1], p[2]) - data.target[e]).norm();
        largest = away > largest ? away : largest;
    }
    return largest;
}

// Largest fraction of the step that turns or stretches no segment by more than the bound.
double step_bound(const RodShape& shape, const RodScratch::Data& data, std::size_t segments) {
    double largest = 0;
    for (std::size_t j = 0; j < segments; ++j) {
        const Lanes d = load_lanes(&data.step[4 * (j + 1)]) - load_lanes(&data.step[4 * j]);
        const double squared =
            (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) * shape.inverse[j + 1] * shape.inverse[j + 1];
        largest = squared > largest ? squared : largest;
    }
    largest = std::sqrt(largest);
    return largest > largest_turn ? largest_turn / largest : 1.0;
}

// Factors the reduced matrix with the smallest shift that makes it positive definite.
bool factor(RodScratch::Data& data, bool& shifted) {
    shifted = false;
    data.block_factors += data.matrix.blocks();
    if (data.factor.factor(data.matrix)) {
        data.shift *= 0.1;
        return true;
    }
    // A static problem may have motions that cost nothing (the spin of a rod pinned at both ends, the swing
    // of a pendulum); a tiny shift tells them from negative curvature.
    data.block_factors += data.matrix.blocks();
    if (data.dt <= 0 && data.factor.factor(data.matrix, free_motion, data.shift_weight.data())) return true;
    shifted = true;
    double shift = data.shift * 0.2 > 1e-7 ? data.shift * 0.2 : 1e-7;
    for (int attempt = 0; attempt < 24; ++attempt, shift *= 8) {
        data.block_factors += data.matrix.blocks();
        if (data.factor.factor(data.matrix, shift, data.shift_weight.data())) {
            data.shift = shift;
            return true;
        }
    }
    return false;
}

// Halves the step from `share` on until `acceptable` holds for the trial shape; false after 30 attempts.
template <class Acceptable>
bool accept_step(const Rod::Tables& tables, RodInputs& inputs, double share, const Acceptable& acceptable,
                 RodScratch::Data& data) {
    for (int attempt = 0; attempt < 30; ++attempt, share *= 0.5) {
        if (!retract(tables, data.shape, data.step.data(), share, data.trial, data.anchor)) continue;
        if (!evaluate(tables, data.trial, inputs, false, data)) continue;
        if (acceptable(share)) return true;
    }
    return false;
}

}  // namespace

NewtonResult newton(const Rod::Tables& tables, RodInputs& inputs, RodScratch::Data& data, int limit,
                    double tolerance, double constraint_tolerance, bool full_steps) {
    NewtonResult result;
    const std::size_t segments = static_cast<std::size_t>(tables.segments), entries = 4 * (segments + 1);
    const double floor = 1e-13 * tables.stretch[0] * tables.rest_length[0];
    const auto done = [&](const RodShape& shape) {
        result.force_residual = free_residual(data);
        const double scale = reaction_scale(data);
        result.residual =
            scale > 0 ? result.force_residual / scale : (result.force_residual > floor ? 1.0 : 0.0);
        const double noise = floor + data.gradient_noise;
        return (result.force_residual <= tolerance * scale || result.force_residual <= noise) &&
               data.constraint_residual <= constraint_tolerance &&
               data.multiplier_change <= contact_tolerance && boundary_distance(shape, data) <= 1e-12;
    };
    for (int i = 0; i < limit; ++i) {
        if (!evaluate(tables, data.shape, inputs, true, data)) {
            result.finite = false;
            return result;
        }
        if (i == 0 && !full_steps && data.dt <= 0 && done(data.shape)) {
            // A static solve may start at the solution; the matrix still shows whether it is a minimum.
            bool shifted = false;
            reduce(data.shape, data);
            result.positive_definite = factor(data, shifted) && !shifted;
            result.converged = true;
            return result;
        }
        const double energy = data.energy, noise = data.energy_noise, before = free_residual(data);
        const bool prescribed = boundary_distance(data.shape, data) > 1e-12 ||
                                (data.constraint_residual > 1e-7 && i < free_changes);
        const double elastic = data.bend + data.twist + data.stretch;
        double slope = 0;
        reduce(data.shape, data);
        bool shifted = false;
        if (!factor(data, shifted)) {
            result.finite = false;
            return result;
        }
        data.factor.solve(data.step.data());
        for (std::size_t k = 0; k < entries; ++k) slope += data.gradient[k] * data.step[k];
        if (!std::isfinite(slope)) {
            result.finite = false;
            return result;
        }
        ++result.iterations;
        const bool free_step = full_steps || prescribed;
        const bool accepted = accept_step(
            tables, inputs, full_steps ? 1.0 : step_bound(data.shape, data, segments),
            [&](double share) {
                return free_step || (data.active_changes > 0 && i < free_changes) ||
                       data.energy <= energy + 1e-4 * share * slope + noise ||
                       (data.energy <= energy + 1e3 * noise + 1e-9 * elastic &&
                        free_residual(data) < 0.5 * before);
            },
            data);
        if (!accepted) {
            // No further decrease above rounding: keep the result so far.
            evaluate(tables, data.shape, inputs, false, data);
            result.converged = done(data.shape);
            result.positive_definite = !shifted;
            return result;
        }
        std::swap(data.shape, data.trial);
        const bool finished = done(data.shape);
        if (full_steps) linear_reactions(tables, data.trial, inputs, data);
        // The multipliers of contacts are updated only once the forces balance, those of grasps once the wall
        // point is near its target: the overshoot of an iterate is not a force.
        const bool balanced = result.force_residual <= 10 * tolerance * reaction_scale(data);
        update_multipliers(inputs, data.constraint_residual < near_target,
                           balanced && data.multiplier_change > contact_tolerance, data);
        result.positive_definite = !shifted;
        if (finished && !shifted) {
            result.converged = true;
            return result;
        }
    }
    return result;
}

}  // namespace fulcrum
