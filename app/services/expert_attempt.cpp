// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/expert_attempt.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "app/live/performance.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t expert_seed = 1000;
constexpr double progress_every_s = 0.5;  // simulated

/// The newest expert that was made, and for what.
struct KeptExpert {
    std::mutex mutex;
    std::string made_for;
    ui::ExpertAttempt attempt;
};
KeptExpert& kept_expert() {
    static KeptExpert kept;
    return kept;
}

/// The class of devices whose model the expert works through: that of the attempt's limits where the task has
/// any, else the one that limits are made with first.
DeviceClass device_of(const LoadedTask& loaded, const database::AttemptMeta& attempt) {
    const DeviceClass used = limits_class(attempt.device_class);
    return limits_for(loaded.task, loaded.scene, used).set ? used : DeviceClass::haptic;
}

}  // namespace

std::function<std::optional<ui::ExpertAttempt>(const ui::Progress&)> expert_maker(
    LoadedTask loaded, const database::AttemptMeta& attempt) {
    const DeviceClass device = device_of(loaded, attempt);
    return [loaded = std::move(loaded),
            device](const ui::Progress& progress) -> std::optional<ui::ExpertAttempt> {
        const std::string wanted = loaded.task.id + '\n' + row_of(device_classes, device).name + '\n' +
                                   loaded.scene.fidelity.id + '\n' + loaded.scene_text;
        KeptExpert& kept = kept_expert();
        {
            const std::lock_guard<std::mutex> lock(kept.mutex);
            if (kept.made_for == wanted) return kept.attempt;
        }
        PerformRequest request;
        request.loaded = loaded;
        request.operator_level = OperatorLevel::expert;
        request.seed = expert_seed;
        request.individual = expert_seed;
        request.device_class = device;
        bool stopped = false;
        double said = 0;  // s
        const double limit = std::max(1.0, loaded.task.time_limit_s);
        request.keep_going = [&](double seconds) {
            if (seconds - said < progress_every_s) return true;
            said = seconds;
            stopped = stopped || (progress && !progress(std::min(0.99, seconds / limit), {}));
            return !stopped;
        };
        const Limits limits = limits_for(loaded.task, loaded.scene, device);
        Performed performed = perform(request, nullptr, limits);
        if (stopped) return std::nullopt;
        ui::ExpertAttempt made;
        made.summary.meta = attempt_meta(loaded, expert_seed, AttemptMode::practice, DeviceClass::synthetic,
                                         "synthetic expert", limits);
        made.summary.meta.operator_name = "expert";
        made.summary.synthetic = true;
        made.summary.state = made.summary.recorded_state = performed.scored.state;
        made.summary.duration_s = performed.scored.duration_s;
        made.summary.passed = performed.scored.score.passed;
        made.summary.points = performed.scored.score.points;
        made.score = to_row(performed.scored, limits.name());
        auto trace = std::make_shared<database::Trace>();
        trace->samples = std::move(performed.record.samples);
        trace->inputs = std::move(performed.record.inputs);
        trace->steps = std::move(performed.record.steps);
        trace->events = std::move(performed.record.events);
        made.trace = std::move(trace);
        const std::lock_guard<std::mutex> lock(kept.mutex);
        kept.made_for = wanted;
        kept.attempt = made;
        return made;
    };
}

}  // namespace fulcrum::app
