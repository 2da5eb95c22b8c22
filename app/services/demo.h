// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration: a store of its own with simulated attempts of a synthetic cohort.
#pragma once

#include <string>

#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Builds the demonstration's store; false if stopped, and then no store is left. Throws InputError,
/// StoreError.
bool build_demo(const std::string& path, const ui::Progress& progress);

}  // namespace fulcrum::app
