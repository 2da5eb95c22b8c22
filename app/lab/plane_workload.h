// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim_core/lab/bench.h"

namespace fulcrum::app {

/// world_c4: a step of the world in which the plane behind the rectum is divided.
lab::Workload plane_workload();

}  // namespace fulcrum::app
