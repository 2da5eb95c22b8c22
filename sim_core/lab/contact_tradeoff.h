// SPDX-License-Identifier: Apache-2.0
// Rows `tool_contact` and `haptic_model_age` of `fulcrum lab tradeoff` (docs/THEORY.md, section 8).
#pragma once

#include "sim_core/lab/tradeoff.h"

namespace fulcrum::lab {

/// Levels dynamic_point and query at three surface resolutions; error: distance against brute force over all
/// triangles.
TradeoffStudy tool_contact_tradeoff();

/// Age of the local model, 1 to 40 ticks; error: force compared with the fully synchronous step (a new model
/// at every tick); time: one tick including its share of building the model.
TradeoffStudy model_age_tradeoff();

}  // namespace fulcrum::lab
