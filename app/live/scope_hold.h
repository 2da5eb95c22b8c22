// SPDX-License-Identifier: GPL-3.0-or-later
// The clutch of the scope in a live attempt. During a pause or a loss of a device the scope stays where it
// is, like the instruments; afterwards it continues from there, wherever its device is by then. Otherwise a
// scope that is moved in a pause would be at its next view without time or path.
//
// It replaces the scope's pose in the input before the engine sees it, so the record has what was done and
// every replay of it is the same; the instruments have their clutch in the haptic loop.
//
// Haptic thread only. No allocation, exception or lock.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/haptics/clutch.h"
#include "sim_core/instrument/device.h"

namespace fulcrum::app {

class ScopeHold {
  public:
    /// Before the first tick: the scope stands as `held` has it, and its device is clutched in there.
    void begin_from(const DeviceSample& held) noexcept {
        held_ = pose_of(held);
        on_hold_ = seen_ = true;
    }
    /// Once each tick, with the flags of the input set.
    void apply(RigSample& input) noexcept {
        const bool on_hold = (input.flags & (rig_paused | rig_device_lost)) != 0U;
        if (!on_hold || !seen_) {
            const Pose device = pose_of(input.camera);
            for (std::size_t i = 0; i < device.size(); ++i) {
                if (on_hold_) offset_[i] = clutch_offset(held_[i], device[i]);
                held_[i] = clutched(device[i], offset_[i]);
            }
        }
        for (int i = 0; i < 3; ++i) input.camera.handle[i] = held_[static_cast<std::size_t>(i)];
        input.camera.roll = held_[3];
        input.camera.jaw = held_[4];
        on_hold_ = on_hold;
        seen_ = true;
    }

  private:
    /// Handle, turn of the light post, turn of the camera head, in counts.
    using Pose = std::array<std::int32_t, 5>;
    static Pose pose_of(const DeviceSample& scope) noexcept {
        return {scope.handle[0], scope.handle[1], scope.handle[2], scope.roll, scope.jaw};
    }

    Pose held_ = {}, offset_ = {};
    bool on_hold_ = false, seen_ = false;
};

}  // namespace fulcrum::app
