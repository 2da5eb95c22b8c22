// SPDX-License-Identifier: Apache-2.0
// Fibres between two layers that tear under tension, ahead of a blade or without one. Provisional values.
#pragma once

namespace fulcrum {

struct FibreSpec {
    double strength = 60;  ///< N/m, line tension across the marked line above which they tear
    double speed = 0.03;   ///< m/s, largest speed at which a cut extends by itself: at twice the strength
};

}  // namespace fulcrum
