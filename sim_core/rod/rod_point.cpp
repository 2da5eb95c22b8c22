// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod_point.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

RodPoint locate(const Rod::Tables& tables, double s) {
    const int n = tables.segments;
    const auto& node_s = tables.node_s;
    const double length = node_s[static_cast<std::size_t>(n)];
    s = s > 0 ? (s < length ? s : length) : 0;  // NaN becomes 0
    // Segment that contains s: the guess is exact for equal segments; for unequal ones step to it.
    int j = std::min(n - 1, static_cast<int>(s / length * n));
    while (j > 0 && s < node_s[static_cast<std::size_t>(j)]) --j;
    while (j < n - 1 && s > node_s[static_cast<std::size_t>(j) + 1]) ++j;
    const double low = node_s[static_cast<std::size_t>(j)], high = node_s[static_cast<std::size_t>(j) + 1];
    const double middle = 0.5 * (low + high);
    RodPoint point;
    if (j == 0 && s <= middle) {
        const double x = (s - low) / (high - low);
        point.joint = 1;
        point.node_weight[0] = 1 - x;
        point.node_weight[1] = x;
        point.node_weight[2] = 0;
        return point;
    }
    if (j == n - 1 && s >= middle) {
        const double x = (s - low) / (high - low);
        point.joint = n - 1;
        point.node_weight[0] = 0;
        point.node_weight[1] = 1 - x;
        point.node_weight[2] = x;
        point.segment_weight[0] = 0;
        point.segment_weight[1] = 1;
        return point;
    }
    const int joint = s < middle ? j : j + 1;
    const auto at = static_cast<std::size_t>(joint);
    const double from = 0.5 * (node_s[at - 1] + node_s[at]), to = 0.5 * (node_s[at] + node_s[at + 1]);
    const double u = (s - from) / (to - from), v = 1 - u;
    point.joint = joint;
    point.node_weight[0] = 0.5 * v * v;
    point.node_weight[2] = 0.5 * u * u;
    point.node_weight[1] = 1 - point.node_weight[0] - point.node_weight[2];
    point.segment_weight[0] = v;
    point.segment_weight[1] = u;
    return point;
}

Vector3 perpendicular(const Vector3& t) {
    const double x = std::fabs(t.x()), y = std::fabs(t.y()), z = std::fabs(t.z());
    const Vector3 axis = y <= x && y <= z ? Vector3(0, 1, 0) : (x <= z ? Vector3(1, 0, 0) : Vector3(0, 0, 1));
    return (axis - t * t.dot(axis)).normalized();
}

}  // namespace fulcrum
