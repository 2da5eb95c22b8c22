// SPDX-License-Identifier: Apache-2.0
// Whether a trainee's learning curve levels off below the pass mark. Pure.
#pragma once

#include <optional>
#include <vector>

namespace fulcrum {

/// Points, 0 to 100.
struct Plateau {
    double level = 0, low = 0, high = 0;  ///< with its 95 % interval
};
/// Of the curve of `points` (attempts 1, 2, … of one device class); none where it is too short, has not
/// levelled off, or its interval reaches `pass_mark`.
std::optional<Plateau> plateau_below(const std::vector<double>& points, double pass_mark);

}  // namespace fulcrum
