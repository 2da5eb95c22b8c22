// SPDX-License-Identifier: Apache-2.0
// Smoothness of movements, of a hand or of the scope.
#pragma once

#include "assessment/metrics/analysis.h"

namespace fulcrum {

/// Log jerk: median over contact-free movements (find_free_movements()); absent where the device's noise
/// would decide it.
Figure log_jerk(const HandAnalysis& hand);

}  // namespace fulcrum
