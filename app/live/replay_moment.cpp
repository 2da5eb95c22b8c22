// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/replay_moment.h"

#include <algorithm>

#include "assessment/attempt/engine_state.h"
#include "assessment/attempt/replay_cursor.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {
namespace {

constexpr std::uint32_t ticks_between_looks = 50;  // between two looks at `stop`

bool ends_attempt(EventKind kind) {
    return kind == EventKind::completed || kind == EventKind::abandoned || kind == EventKind::timed_out ||
           kind == EventKind::interrupted;
}

}  // namespace

bool TraceMoment::bring(AttemptEngine& engine, const std::atomic<bool>& stop) const {
    if (!start.empty()) restore_engine(engine, start);
    ReplayCursor cursor(engine, *record);
    if (!frame.empty()) {
        StateArchive archive(frame.data(), frame.size());
        cursor.transfer(archive);
    }
    while (cursor.tick() < tick && !cursor.at_end()) {
        if (stop.load()) return false;
        cursor.run_to(std::min(tick, cursor.tick() + ticks_between_looks));
    }
    if (!cursor.settle() || engine.ended() || !cursor.outcome().identical) {
        throw InputError(
            attempt_id, "",
            QT_TRANSLATE_NOOP("errors",
                              "the attempt cannot be continued from this moment: the simulation differs from "
                              "the recording here"),
            QT_TRANSLATE_NOOP(
                "errors",
                "it was recorded with another version of the program; practise from the beginning"));
    }
    return true;
}

std::uint32_t settled_tick(const AttemptRecord& record, std::uint32_t tick) {
    for (const Event& event : record.events) {
        if (ends_attempt(event.kind)) tick = std::min(tick, event.tick - std::min(event.tick, 1U));
    }
    const auto after =
        std::upper_bound(record.steps.begin(), record.steps.end(), tick,
                         [](std::uint32_t t, const StepRecord& step) { return t < step.last_tick; });
    return after == record.steps.begin() ? 0 : (after - 1)->last_tick;
}

}  // namespace fulcrum::app
