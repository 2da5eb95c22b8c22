// SPDX-License-Identifier: GPL-3.0-or-later
// One engine runs through a stored record once, in slices, and leaves key frames.
#pragma once

#include "app/live/frame_store.h"
#include "app/live/replay_player.h"

namespace fulcrum::app {

class FramePass {
  public:
    /// From the newest frame in `frames` on; where there is none it begins and leaves the first. All three
    /// must outlive it. One thread. Throws StateArchiveError, StoreError.
    FramePass(const ReplayStart& start, const AttemptRecord& record, FrameStore& frames);

    /// Some ticks, and a frame where one is due; false when the end of the record is reached.
    bool run_slice();
    /// Everything so far was made again bit for bit.
    bool identical() const { return player_.cursor.outcome().identical; }
    double first_divergence_s() const { return player_.cursor.outcome().first_divergence_s; }
    std::uint32_t tick() const { return player_.cursor.tick(); }
    const WorldSnapshot& world() { return player_.engine.world().snapshot(); }

  private:
    FrameStore& frames_;
    ReplayPlayer player_;
    double since_frame_ = 0;  ///< s
};

}  // namespace fulcrum::app
