// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/bowel_line.h"

#include <algorithm>

namespace fulcrum {

LinePoint line_point(const std::vector<Vector3>& nodes, const std::vector<double>& arc_lengths,
                     double arc_length) noexcept {
    LinePoint point;
    const std::size_t count = std::min(nodes.size(), arc_lengths.size());
    if (count < 2) return point;
    const auto begin = arc_lengths.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    auto upper = static_cast<std::size_t>(std::upper_bound(begin, end, arc_length) - begin);
    upper = std::clamp<std::size_t>(upper, 1, count - 1);
    const double before = arc_lengths[upper - 1], after = arc_lengths[upper];
    const double share =
        after > before ? std::clamp((arc_length - before) / (after - before), 0.0, 1.0) : 0.0;
    const Vector3 step = nodes[upper] - nodes[upper - 1];
    point.position = nodes[upper - 1] + share * step;
    const double length = step.norm();
    if (length > 0) point.tangent = step / length;
    return point;
}

}  // namespace fulcrum
