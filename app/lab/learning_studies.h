// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of the statistics of a curriculum for `fulcrum lab run`: rule, curve, cusum, agreement
// (docs/FORMATS.md, Studies).
#pragma once

#include <vector>

#include "sim_core/lab/studies.h"

namespace fulcrum::app {

std::vector<lab::Study> learning_studies();

}  // namespace fulcrum::app
