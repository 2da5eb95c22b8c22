// SPDX-License-Identifier: Apache-2.0
// The process that reads the device and renders force: one thread on an absolute clock.
#pragma once

#include <sys/types.h>

#include "sim_core/hapticd/backend.h"

namespace fulcrum::hapticd {

/// The exit status where the device has to be opened again.
inline constexpr int status_lost = 3;

/// Opens the device, gives up rights and runs until `stopping` is set, the device is lost or the overseer is
/// gone; the motors are off when it returns. Writes one line of JSON to `report`: {"device": …, "notes": […],
/// "real_time": …, "filtered": …}, or {"error": …} where the device does not open. Returns the exit status.
int run_device(Backend& backend, StatePage& state, const CommandPage& command, pid_t overseer, int report);

}  // namespace fulcrum::hapticd
