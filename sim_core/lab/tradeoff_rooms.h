// SPDX-License-Identifier: Apache-2.0
// The trade-off studies of each room; declare a new room here (or in its own header) and list it in
// tradeoff.cpp.
#pragma once

#include <vector>

#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// Rod levels and segments: a static solve from rest and a frame of 5 ms, and the law of the material.
std::vector<TradeoffStudy> rod_tradeoff();

}  // namespace fulcrum::lab
