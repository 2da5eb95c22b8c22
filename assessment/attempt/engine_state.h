// SPDX-License-Identifier: Apache-2.0
// An engine's whole state as bytes (sim_core/numerics/state_archive.h): what an attempt begins with that
// continues another one.
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/attempt/engine.h"

namespace fulcrum {

std::vector<std::uint8_t> engine_state(AttemptEngine& engine);
/// Into an engine of the same scene, task and seed. Throws StateArchiveError.
void restore_engine(AttemptEngine& engine, const std::vector<std::uint8_t>& state);

}  // namespace fulcrum
