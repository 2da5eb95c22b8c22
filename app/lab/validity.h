// SPDX-License-Identifier: GPL-3.0-or-later
// The page of validity: what each metric is worth and whom each gate fails, from the results of other pages.
#pragma once

#include <string>

#include "app/lab/measure.h"

namespace fulcrum::app {

/// Reads operators_TASK and lab_invariance from `folder`, as `lab operators` and `lab invariance` write them:
/// the JSON, or where it was not kept the page. Throws InputError where both are missing or of another
/// version.
Measured validity_page(const std::string& folder);

}  // namespace fulcrum::app
