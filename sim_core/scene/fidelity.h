// SPDX-License-Identifier: Apache-2.0
// Named fidelities: one level for every row of the speed-accuracy table.
#pragma once

#include <string>
#include <vector>

#include "sim_core/scene/scene.h"

namespace fulcrum {

/// "fast", "standard", "fine". Throws InputError listing the names for any other.
Fidelity named_fidelity(const std::string& id);
std::vector<std::string> fidelity_names();

}  // namespace fulcrum
