// SPDX-License-Identifier: Apache-2.0
#include "sim_core/energy/heat.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double tolerance = 1e-14;  // of the residual, relative to the right-hand side
constexpr double least_right = 1e-300;
constexpr double damage_limit = 1e6;
constexpr double harmless =
    39;  // degrees C: below it damage, like dose, counts as zero (rate below 3e-7 1/s)
constexpr double hottest = 1e6;  // K, upper bound for any input

double usable(double value, double most) {
    return value > 0 ? std::min(value, most) : 0.0;
}  // NaN: 0

// y = A x, A = diagonal + graph Laplacian of the links that conduct.
void multiply(const HeatModel& model, const HeatState& state, const std::vector<double>& diagonal,
              const std::vector<double>& x, std::vector<double>& y) noexcept {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = diagonal[i] * x[i];
    for (std::size_t l = 0; l < model.links.size(); ++l) {
        if (state.parted[l] != 0) continue;
        const HeatLink& link = model.links[l];
        const auto a = static_cast<std::size_t>(link.a), b = static_cast<std::size_t>(link.b);
        const double flow = link.conductance * (x[a] - x[b]);
        y[a] += flow;
        y[b] -= flow;
    }
}

// Conjugate gradients, preconditioned by the diagonal, started from the last temperatures: a few iterations
// for short steps. Writes scratch.next, residual and iterations.
void solve(const HeatModel& model, const HeatState& state, HeatScratch& scratch,
           HeatReport& report) noexcept {
    const std::size_t count = model.patches.size();
    multiply(model, state, scratch.diagonal, scratch.next, scratch.product);
    // Sums of one pass run side by side: each waits for its own last term only.
    double right2 = 0, residual2 = 0, next_rho = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double residual = scratch.right[i] - scratch.product[i];
        scratch.residual[i] = residual;
        right2 += scratch.right[i] * scratch.right[i];
        residual2 += residual * residual;
        next_rho += residual * residual / scratch.diagonal[i];
    }
    const double scale = std::sqrt(right2);
    double rho = 0;
    const int most = 4 * static_cast<int>(count) + 8;
    for (;;) {
        report.residual = scale > least_right ? std::sqrt(residual2) / scale : 0.0;
        if (!(report.residual > tolerance) || report.iterations >= most) break;
        const double beta = report.iterations > 0 ? next_rho / rho : 0.0;
        rho = next_rho;
        for (std::size_t i = 0; i < count; ++i)
            scratch.direction[i] = scratch.residual[i] / scratch.diagonal[i] + beta * scratch.direction[i];
        multiply(model, state, scratch.diagonal, scratch.direction, scratch.product);
        double curvature = 0;
        for (std::size_t i = 0; i < count; ++i) curvature += scratch.direction[i] * scratch.product[i];
        if (!(curvature > 0)) break;
        const double alpha = rho / curvature;
        residual2 = next_rho = 0;
        for (std::size_t i = 0; i < count; ++i) {
            scratch.next[i] += alpha * scratch.direction[i];
            const double residual = scratch.residual[i] - alpha * scratch.product[i];
            scratch.residual[i] = residual;
            residual2 += residual * residual;
            next_rho += residual * residual / scratch.diagonal[i];
        }
        ++report.iterations;
    }
}

}  // namespace

HeatState make_heat_state(const HeatModel& model) {
    HeatState state;
    const std::size_t count = model.patches.size();
    state.rise.assign(count, 0.0);
    state.dose.assign(count, 0.0);
    state.damage.assign(count, 0.0);
    for (const HeatPatch& patch : model.patches) {
        assert(patch.capacity > 0 && patch.perfusion >= 0 && patch.water >= 0);
        state.water.push_back(patch.water);
    }
    state.parted.assign(model.links.size(), 0);
    return state;
}

HeatInputs make_heat_inputs(const HeatModel& model) {
    const std::size_t count = model.patches.size();
    return {std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
            std::vector<double>(count, 0.0)};
}

HeatScratch make_heat_scratch(const HeatModel& model) {
    const std::vector<double> zero(model.patches.size(), 0.0);
    return {zero, zero, zero, zero, zero, zero};
}

HeatReport step_heat(const HeatModel& model, const HeatInputs& inputs, double dt, HeatState& state,
                     HeatScratch& scratch) noexcept {
    HeatReport report;
    if (!(dt > 0) || !std::isfinite(dt)) return report;
    const std::size_t count = model.patches.size();
    double given = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const HeatPatch& patch = model.patches[i];
        const double power = usable(inputs.power[i], hottest), contact = usable(inputs.contact[i], hottest);
        const double contact_rise = usable(inputs.contact_rise[i], hottest);
        scratch.diagonal[i] = patch.capacity / dt + patch.perfusion + contact;
        scratch.right[i] = patch.capacity / dt * state.rise[i] + power + contact * contact_rise;
        scratch.next[i] = state.rise[i];
        given += power;
    }

    solve(model, state, scratch, report);
    const double boiling = model.boiling_point - model.body_temperature;
    const double at_rest = damage_rate(model.body_temperature);
    state.given += given * dt;
    for (std::size_t i = 0; i < count; ++i) {
        const HeatPatch& patch = model.patches[i];
        const double touched = usable(inputs.contact[i], hottest) *
                               (usable(inputs.contact_rise[i], hottest) - scratch.next[i]) * dt;
        report.from_contact += touched;
        state.given += touched;
        state.perfused += patch.perfusion * scratch.next[i] * dt;
        double rise = scratch.next[i];
        if (rise > boiling && state.water[i] > 0) {
            const double steam =
                std::min(state.water[i], patch.capacity * (rise - boiling) / model.latent_heat);
            state.water[i] -= steam;
            rise -= steam * model.latent_heat / patch.capacity;
            state.boiled += steam * model.latent_heat;
            report.steam += steam;
        }
        const double mean = model.body_temperature + 0.5 * (state.rise[i] + rise);
        state.dose[i] = std::min(dose_limit, state.dose[i] + dose_rate(mean) * dt / 60.0);
        const double harm = mean < harmless ? at_rest : damage_rate(mean);
        state.damage[i] = std::min(damage_limit, state.damage[i] + harm * dt);
        state.rise[i] = rise;
    }
    return report;
}

double stored_heat(const HeatModel& model, const HeatState& state) {
    double sum = 0;
    for (std::size_t i = 0; i < model.patches.size(); ++i) sum += model.patches[i].capacity * state.rise[i];
    return sum;
}

double dose_rate(double temperature) {
    constexpr double ln2 = 0.6931471805599453, highest_rate = 1e9;
    if (!(temperature >= 39)) return 0;
    if (temperature < 43) return math::exp((temperature - 43) * 2 * ln2);
    return temperature < 70 ? math::exp((temperature - 43) * ln2)
                            : std::min(highest_rate, math::exp((std::min(temperature, 500.0) - 43) * ln2));
}

double damage_rate(double temperature) {
    constexpr double ln_a = 226.7847412249076;  // ln 3.1e98
    constexpr double activation = 6.28e5, gas = 8.314462618;
    const double kelvin = temperature + 273.15;
    if (!(kelvin > 1)) return 0;
    return math::exp(std::min(ln_a - activation / (gas * kelvin), 13.815510557964274));  // at most 1e6
}

double coagulated_share(double damage) {
    return damage > 0 ? 1 - math::exp(-damage) : 0.0;
}

}  // namespace fulcrum
