// SPDX-License-Identifier: Apache-2.0
// An attempt's record kept in memory, for scoring and for studies that store nothing.
#pragma once

#include "assessment/attempt/engine.h"

namespace fulcrum {

/// Grows with the attempt: not for real-time threads.
class MemorySink : public AttemptSink {
  public:
    void on_event(const Event& event) noexcept override { record.events.push_back(event); }
    void on_tick(const RigSample& input, const TickSample& sample) noexcept override {
        record.inputs.push_back(input);
        record.samples.push_back(sample);
    }
    void on_step(const StepRecord& step) noexcept override { record.steps.push_back(step); }
    AttemptRecord record;
};

}  // namespace fulcrum
