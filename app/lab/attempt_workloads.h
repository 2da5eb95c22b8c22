// SPDX-License-Identifier: GPL-3.0-or-later
// Reference workloads that need a whole attempt: the haptic tick, the B1 world step, a headless second,
// recording.
#pragma once

#include <vector>

#include "sim_core/lab/bench.h"

namespace fulcrum::app {

std::vector<lab::Workload> attempt_workloads();

}  // namespace fulcrum::app
