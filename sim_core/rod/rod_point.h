// SPDX-License-Identifier: Apache-2.0
// A material point of the centre line: the nodes and segments it depends on, and their weights.
#pragma once

#include "sim_core/rod/rod_tables.h"

namespace fulcrum {

/// r(s) = sum_k node_weight[k] r_(joint - 1 + k); directions blend those of segments joint - 1 and joint.
struct RodPoint {
    int joint = 1;  ///< 1 .. n - 1
    double node_weight[3] = {0, 1, 0};
    double segment_weight[2] = {1, 0};
};

/// s in m of rest length, clamped to the rod; NaN counts as 0.
RodPoint locate(const Rod::Tables& tables, double s);

/// v rotated by the shortest rotation from unit `from` to unit `to`. Not for opposite directions.
inline Vector3 transport(const Vector3& v, const Vector3& from, const Vector3& to) {
    return v - (from + to) * (v.dot(to) / (1.0 + from.dot(to))) -
           (from + to) * (v.dot(from) / (1.0 + from.dot(to))) + to * (2.0 * v.dot(from));
}

/// A unit vector perpendicular to unit t; deterministic in t.
Vector3 perpendicular(const Vector3& t);

}  // namespace fulcrum
