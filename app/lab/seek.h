// SPDX-License-Identifier: GPL-3.0-or-later
// What key frames of a replay cost and how long a seek takes, as a page.
#pragma once

#include <string>
#include <vector>

#include "app/lab/measure.h"

namespace fulcrum::app {

/// For each task an attempt of `seconds` simulated seconds by the expert operator (after its end its inputs
/// go on backwards and forwards), its key frames, and `seeks` seeks to random moments.
Measured measure_seeks(const std::vector<std::string>& tasks, double seconds, int seeks);

}  // namespace fulcrum::app
