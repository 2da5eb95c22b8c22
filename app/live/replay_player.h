// SPDX-License-Identifier: GPL-3.0-or-later
// An engine at the beginning of a record, with its cursor.
#pragma once

#include <ctime>
#include <vector>

#include "assessment/attempt/engine_state.h"
#include "assessment/attempt/replay_cursor.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app {

/// What an attempt begins with, as its replay needs it.
struct ReplayStart {
    LoadedTask loaded;
    std::uint64_t seed = 1;
    std::vector<std::uint8_t> state = {};  ///< that it began with (Attempts::start_state); empty: none
};

/// Both arguments must outlive it. Throws StateArchiveError.
struct ReplayPlayer {
    AttemptEngine engine;
    ReplayCursor cursor;

    ReplayPlayer(const ReplayStart& from, const AttemptRecord& record)
        : engine(from.loaded.scene, from.loaded.task, from.seed), cursor(at_start(engine, from), record) {}

  private:
    static AttemptEngine& at_start(AttemptEngine& engine, const ReplayStart& from) {
        if (!from.state.empty()) restore_engine(engine, from.state);
        return engine;
    }
};

/// s of processor time of the calling thread.
inline double thread_seconds() noexcept {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace fulcrum::app
