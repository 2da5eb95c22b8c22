// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/force_release.h"

#include <algorithm>
#include <cmath>

#include "app/live/real_time.h"
#include "assessment/attempt/engine.h"
#include "sim_core/haptics/hand_output.h"

namespace fulcrum::app {

int periods_to_release(const Rig& rig, const TickOutput& last, const Scene& scene) noexcept {
    const double step = scene.slew_limit * scene.tick_period();
    double periods = 0;
    for (int hand = 0; hand < hand_count; ++hand) {
        double most = step;
        if (const auto device = rig.force_output(static_cast<Hand>(hand)))
            most = std::min(most, device->slew * scene.tick_period());
        periods = std::max(periods, last.device_force[hand].norm() / most);
        periods = std::max(periods, std::abs(last.device_torque[hand]) / (step * slew_arm));
    }
    return static_cast<int>(std::ceil(std::min(periods, static_cast<double>(scene.tick_rate))));
}

void release_forces(Rig& rig, const TickOutput& last, const Scene& scene) noexcept {
    const auto period = static_cast<std::int64_t>(1e9 * scene.tick_period());
    const int periods = periods_to_release(rig, last, scene);
    TickOutput output;
    for (int left = periods - 1; left > 0; --left) {
        const double share = static_cast<double>(left) / periods;
        for (int hand = 0; hand < hand_count; ++hand) {
            output.device_force[hand] = share * last.device_force[hand];
            output.device_torque[hand] = share * last.device_torque[hand];
        }
        // After the last one, not by the clock of the ticks: a late thread would send several at once.
        sleep_until(now_ns() + period);
        write_forces(rig, output);
    }
    if (periods > 0) sleep_until(now_ns() + period);
    write_forces(rig, TickOutput{});
}

}  // namespace fulcrum::app
