// SPDX-License-Identifier: GPL-3.0-or-later
// A moment of a stored attempt from which a practice run can begin.
#pragma once

#include <memory>

#include "app/live/live_attempt.h"
#include "database/rows/trace_codec.h"
#include "ui/services/replay_source.h"

namespace fulcrum::app {

/// Constant once made; any thread.
struct TraceMoment : public ui::ReplayMoment {
    LoadedTask loaded;
    std::uint64_t seed = 1;
    std::string attempt_id;
    std::shared_ptr<const AttemptRecord> record;
    std::vector<std::uint8_t> start;  ///< state that the record begins with; empty: the scene's beginning
    std::vector<std::uint8_t> frame;  ///< key frame at or before `tick` (FrameStore::state); empty: none
    std::uint32_t tick = 0;           ///< last one of the record that counts
    int goal = 0;                     ///< under way then

    const Scene& scene() const override { return loaded.scene; }
    const std::string& task_id() const override { return loaded.task.id; }
    double time_s() const override { return tick * loaded.scene.tick_period(); }
    /// Brings a new engine to this moment, at which everything of the record up to it is done. False where
    /// `stop` became true before. Throws StateArchiveError, InputError where the simulation differs from the
    /// record.
    bool bring(AttemptEngine& engine, const std::atomic<bool>& stop) const;
};

/// The last tick up to `tick` at which the record's world had used every tick, and the attempt had not ended;
/// 0: there is none.
std::uint32_t settled_tick(const AttemptRecord& record, std::uint32_t tick);

}  // namespace fulcrum::app
