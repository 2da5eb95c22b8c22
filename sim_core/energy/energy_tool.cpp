// SPDX-License-Identifier: Apache-2.0
#include "sim_core/energy/energy_tool.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double half_depth = 0.002;   // m of blood that absorbs half of the power; provisional
constexpr double most_tension = 1e3;   // N
constexpr double hottest_blade = 1e4;  // K

}  // namespace

EnergyToolModel harmonic_shears() {
    return {};
}

EnergyToolModel monopolar_hook() {
    EnergyToolModel hook;
    hook.tissue_power = 30;
    hook.blade_power = 0.5;
    hook.blade_capacity = 0.03;
    hook.blade_cooling = 0.01;
    hook.blade_contact = 0.004;
    hook.division_rate = 0.6;
    hook.needs_jaws = false;
    return hook;
}

void step_blade(const EnergyToolModel& model, bool active, double given, double dt,
                BladeState& blade) noexcept {
    if (!(dt > 0) || !std::isfinite(dt)) return;
    const double taken = std::isfinite(given) ? given : 0.0;
    const double heat = model.blade_capacity * blade.rise + (active ? model.blade_power * dt : 0.0) - taken;
    blade.rise = std::clamp(heat / (model.blade_capacity + model.blade_cooling * dt), 0.0, hottest_blade);
}

double division_rate(const EnergyToolModel& model, double temperature, double tension) noexcept {
    if (!(temperature > model.division_start)) return 0;
    const double hot =
        std::min(1.0, (temperature - model.division_start) / (model.division_full - model.division_start));
    const double pulled = tension > 0 ? std::min(tension, most_tension) : 0.0;
    return model.division_rate * hot * (1 + model.tension_gain * pulled);
}

double share_under_blood(double depth) noexcept {
    return depth > 0 ? half_depth / (half_depth + depth) : 1.0;
}

}  // namespace fulcrum
