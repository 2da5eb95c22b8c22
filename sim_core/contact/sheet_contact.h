// SPDX-License-Identifier: Apache-2.0
// Tip on a sheet, or blade in it, at the tick: first-order extrapolation of the world's solution. Haptic
// thread: no allocation, lock, exception.
#pragma once

#include "sim_core/contact/tool_contact.h"

namespace fulcrum {

/// Adds sheet_force and related fields to the result; no effect if the model has no sheet nearby.
void touch_sheet(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                 ToolContactResult& result);

}  // namespace fulcrum
