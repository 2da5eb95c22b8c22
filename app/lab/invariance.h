// SPDX-License-Identifier: GPL-3.0-or-later
// What metrics make of the same attempts recorded otherwise, as a page.
#pragma once

#include "app/lab/measure.h"

namespace fulcrum::app {

/// One expert's attempt at each task that has metrics for it, under every change of trace_changes.
Measured measure_invariance();

}  // namespace fulcrum::app
