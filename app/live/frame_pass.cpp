// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frame_pass.h"

#include <limits>

namespace fulcrum::app {
namespace {

constexpr std::uint32_t ticks_in_slice = 10;

}  // namespace

FramePass::FramePass(const ReplayStart& start, const AttemptRecord& record, FrameStore& frames)
    : frames_(frames), player_(start, record) {
    if (frames_.count() > 0) {
        frames_.put(std::numeric_limits<std::uint32_t>::max(), player_.cursor);
    } else {
        frames_.add(player_.cursor);
    }
}

bool FramePass::run_slice() {
    ReplayCursor& cursor = player_.cursor;
    const double begin = thread_seconds();
    if (cursor.at_end()) {
        cursor.run_to_end();
    } else {
        cursor.run_to(cursor.tick() + ticks_in_slice);
    }
    since_frame_ += thread_seconds() - begin;
    if (cursor.at_end()) return false;
    if (frames_.wants(since_frame_)) {
        frames_.add(cursor);
        since_frame_ = 0;
    }
    return true;
}

}  // namespace fulcrum::app
