// SPDX-License-Identifier: Apache-2.0
// Fibres between two layers that part under tension, ahead of a blade or without one. Our figures,
// provisional.
#pragma once

namespace fulcrum {

struct FibreSpec {
    double strength = 60;  ///< N/m, line tension across the marked line above which they part
    double speed = 0.03;   ///< m/s at most, of an end of a cut that runs on: at twice the strength
};

}  // namespace fulcrum
