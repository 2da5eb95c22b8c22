// SPDX-License-Identifier: Apache-2.0
// A tool's tip on a sheet, or its blade in it, at the tick: the world's solution carried on to first order.
// Haptic thread: no allocation, lock, exception.
#pragma once

#include "sim_core/contact/tool_contact.h"

namespace fulcrum {

/// Adds sheet_force and what belongs to it to the result; nothing where the model has no sheet near.
void touch_sheet(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                 ToolContactResult& result);

}  // namespace fulcrum
