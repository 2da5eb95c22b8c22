// SPDX-License-Identifier: GPL-3.0-or-later
// Latency and jitter that fulcrum-hapticd adds between a device and the program, as a page.
#pragma once

#include "app/lab/measure.h"

namespace fulcrum::app {

/// A virtual device with a simulated hand of 0.2 kg for `seconds`, first with nothing else to do, then next
/// to a busy thread for each processor. Throws InputError where fulcrum-hapticd does not start.
Measured measure_hapticd(double seconds);

}  // namespace fulcrum::app
