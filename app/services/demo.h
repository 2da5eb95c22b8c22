// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration: a really simulated synthetic cohort in a store of its own, and one attempt for a machine
// without a display.
#pragma once

#include <string>

#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Builds the demo store; false when stopped, leaving nothing. Throws InputError, StoreError.
bool build_demo(const std::string& path, const ui::Progress& progress);

}  // namespace fulcrum::app
