// SPDX-License-Identifier: GPL-3.0-or-later
// A device that replays the readings of a record, tick by tick; after the last one the attempt is abandoned.
#pragma once

#include <vector>

#include "sim_core/instrument/device.h"

namespace fulcrum::app {

class TraceRig : public Rig {
  public:
    explicit TraceRig(const std::vector<RigSample>& inputs) : inputs_(inputs) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        if (tick >= 1 && tick <= inputs_.size()) {
            sample = inputs_[tick - 1];
            sample.flags &=
                ~static_cast<std::uint32_t>(rig_world_late);  // depends on the timing of the original run
        } else {
            if (!inputs_.empty()) sample = inputs_.back();
            sample.flags |= rig_abandon;
        }
        sample.tick = tick;
    }
    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    const std::vector<RigSample>& inputs_;
};

}  // namespace fulcrum::app
