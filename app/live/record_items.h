// SPDX-License-Identifier: GPL-3.0-or-later
// What the haptic and the world thread hand to the recorder's.
#pragma once

#include "sim_core/instrument/device.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum::app {

struct RecordTick {
    RigSample input;
    TickSample sample;
};
struct RecordWorld {
    bool is_event = false;
    Event event;
    StepRecord step;
};

}  // namespace fulcrum::app
