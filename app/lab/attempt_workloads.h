// SPDX-License-Identifier: GPL-3.0-or-later
// Reference workloads that need a whole attempt: the haptic tick, the B1 world step, a headless second,
// recording.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "sim_core/lab/bench.h"
#include "sim_core/world/world.h"

namespace fulcrum::app {

std::vector<lab::Workload> attempt_workloads();

/// Memory of parts of a world, by their names in World::costs().
std::size_t bytes_of(const World& world, const std::set<std::string>& parts);

}  // namespace fulcrum::app
