// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bleeding/vessel.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double dry_share = 1e-3;  // below this share of the lumen a vessel does not bleed

double share(double value) {
    return value > 0 ? std::min(value, 1.0) : 0.0;
}

}  // namespace

double vessel_flow(const VesselModel& model, double area_share) noexcept {
    const double open = share(area_share) * model.radius * model.radius;  // r^2 of the opening
    return pi * open * open * model.pressure / (8 * model.viscosity * model.feeding_length);
}

double open_share(const BleedState& state) noexcept {
    if (state.clipped) return 0;
    const double open = share(state.opening) * (1 - share(state.sealed)) * (1 - share(state.clotted));
    return open > dry_share ? open : 0.0;
}

double bleed_flow(const VesselModel& model, const BleedState& state) noexcept {
    return vessel_flow(model, open_share(state));
}

void open_vessel(double area_share, BleedState& state) noexcept {
    const double open = open_share(state);
    const double fresh = share(area_share);
    if (fresh <= open) return;
    state.opening = fresh;
    state.sealed = state.clotted = 0;
}

double step_bleed(const VesselModel& model, double dt, BleedState& state) noexcept {
    if (!(dt > 0) || !std::isfinite(dt)) return 0;
    const double open = open_share(state);
    if (open <= 0) return 0;
    // The open area decreases as exp(-t / tau), so the flow decreases twice as fast.
    const double fall = dt / model.clotting_time;
    const double lost = vessel_flow(model, open) * 0.5 * model.clotting_time * (1 - math::exp(-2 * fall));
    state.clotted = 1 - (1 - share(state.clotted)) * math::exp(-fall);
    state.lost += lost;
    return lost;
}

}  // namespace fulcrum
