// SPDX-License-Identifier: Apache-2.0
// A simulated device at the product's contact: its stability boundary, and passivity within Eq. 8
// (docs/THEORY.md, section 6).
#include <string>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/stability_map.h"
#include "sim_core/lab/validation_rooms.h"

namespace fulcrum::lab {

std::vector<ValidationCase> haptic_validation() {
    std::vector<ValidationCase> cases;
    SimulatedDevice device;
    for (const int delay : {0, 1}) {
        device.delay_ticks = delay;
        DeviceAtContact contact(FilterMode::adaptive, device);
        for (const double damping : {0.0, 0.4}) {
            if (delay > 0 && damping > 0)
                continue;  // not small compared with the delay: the linear bound is not a reference there
            cases.push_back(relative_case(
                "haptics",
                "device of 0.1 kg and 0.5 N s/m at 1 kHz, B = " + short_number(damping, 2) +
                    " N s/m, delay " + std::to_string(delay) + " ticks",
                "largest stable stiffness, N/m", contact.boundary(damping, 0.01),
                (device.damping + damping) / (device.period * (0.5 + delay)), "K (T/2 + t_d) = b + B", 0.10));
        }
    }
    device.delay_ticks = 0;
    DeviceAtContact contact(FilterMode::grade_1, device);
    int sound = 0, points = 0;
    for (const double damping : {0.0, 0.2, 0.4}) {
        const double bound = 2 * (device.damping - damping) / device.period;
        for (const double share : {0.3, 0.9}) {
            const DeviceRun run = contact.run(share * bound, damping, true);
            ++points;
            sound += run.passive && run.stable && run.finite ? 1 : 0;
        }
    }
    cases.push_back(absolute_case("haptics", "six points inside Eq. 8, with the worst passive hand",
                                  "points that are stable and passive by the observer", sound, points,
                                  "Eq. 8 with Colgate's |B|: K < 2 (b - |B|) / T", 0));
    return cases;
}

}  // namespace fulcrum::lab
