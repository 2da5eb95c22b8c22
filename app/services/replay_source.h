// SPDX-License-Identifier: GPL-3.0-or-later
// The scene at any moment of a stored attempt: recorded poses, tissue simulated again.
#pragma once

#include <memory>

#include "app/live/frame_follower.h"
#include "app/live/replay_player.h"
#include "app/live/sample_tap.h"
#include "database/rows/trace_codec.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

struct ReplayRequest {
    ReplayStart start;
    std::string attempt_id;
    std::shared_ptr<const database::Trace> trace;
    ForceDevices devices;           ///< that rendered force in the attempt
    bool start_is_readable = true;  ///< false: another build wrote start.state; only poses are shown
    FrameKeeping keeping = {};      ///< key frames of a completed pass, kept for the next opening
    std::shared_ptr<FrameFollower> follower = {};  ///< of the newest attempt, which may be this one; or null
    std::vector<PackedFrame> frames = {};          ///< of the record's beginning, made already; or none
    std::shared_ptr<void> open = {};               ///< held while the replay is open
    std::shared_ptr<SampleTap> tap =
        {};  ///< gets the recorded sample of what is shown, no events; null: nobody looks
};

/// On a thread of its own one engine runs through the record once and leaves key frames (FrameStore), unless
/// those of an earlier pass were kept, and from where those that were made before end; a second one makes
/// what is asked for from the key frame before it, and compares what it makes with the record: kept frames
/// that lead elsewhere are thrown away, and the pass is made. Instruments and scope come from the record.
/// Owner's thread only.
std::unique_ptr<ui::ReplaySource> make_replay_source(ReplayRequest request);

}  // namespace fulcrum::app
