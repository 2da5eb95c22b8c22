// SPDX-License-Identifier: Apache-2.0
// Straightness between way-points and error of depth: metrics of where a hand meant to go.
#pragma once

#include "assessment/metrics/registry.h"

namespace fulcrum {

class Analysis;

Figure econ(const Analysis& analysis, const Selection& row);
Figure depth_err(const Analysis& analysis, const Selection& row);
Figure depth_err_sd(const Analysis& analysis, const Selection& row);

}  // namespace fulcrum
