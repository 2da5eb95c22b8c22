// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/trace_input.h"

#include <algorithm>
#include <cmath>

#include "assessment/trace/trace_csv.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {

std::vector<RigSample> inputs_from_csv(const std::string& path, const Scene& scene) {
    const Trace trace = read_trace_csv(path);
    if (trace.t.size() < 2)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "has fewer than two samples"),
                         QT_TRANSLATE_NOOP("errors", "give a recorded trace"));
    bool any = false;
    for (const HandTrace& hand : trace.hand) any = any || hand.has(Channel::position);
    if (!any)
        throw InputError(
            path, "1",
            QT_TRANSLATE_NOOP("errors",
                              "has no tip positions: columns left.px left.py left.pz (or right) are missing"),
            QT_TRANSLATE_NOOP("errors", "add the tip positions of at least one hand"));

    const double duration = trace.t.back() - trace.t.front();
    const auto ticks = static_cast<std::size_t>(std::floor(duration * scene.tick_rate)) + 1;
    std::vector<RigSample> inputs(ticks);
    std::size_t k = 0;
    DeviceSample last[hand_count];
    for (std::size_t i = 0; i < ticks; ++i) {
        RigSample& input = inputs[i];
        input.tick = static_cast<std::uint32_t>(i + 1);
        const double t = trace.t.front() + static_cast<double>(i) / scene.tick_rate;
        while (k + 2 < trace.t.size() && trace.t[k + 1] < t) ++k;
        const double u = std::clamp((t - trace.t[k]) / (trace.t[k + 1] - trace.t[k]), 0.0, 1.0);
        const auto between = [&](const std::vector<double>& column) {
            return column.empty() ? 0.0 : (1 - u) * column[k] + u * column[k + 1];
        };
        for (int h = 0; h < hand_count; ++h) {
            const InstrumentSpec* spec = scene.instrument(static_cast<Hand>(h));
            if (spec == nullptr) continue;
            const HandTrace& hand = trace.hand[static_cast<std::size_t>(h)];
            if (!hand.has(Channel::position)) {
                input.hand[h] = start_sample(spec->trocar, spec->start_insertion);
                continue;
            }
            DeviceReading reading;
            reading.handle = handle_for_tip(make_trocar(spec->trocar),
                                            Vector3(between(hand.px), between(hand.py), between(hand.pz)));
            reading.roll = between(hand.roll);
            reading.grip = between(hand.jaw_force);
            reading.jaw = reading.grip > 0 ? 0.0 : spec->jaw_opening;
            input.hand[h] = quantise(reading, last[h]);
            last[h] = input.hand[h];
        }
        if (scene.camera) input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
    }
    return inputs;
}

}  // namespace fulcrum::app
