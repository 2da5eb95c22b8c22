// SPDX-License-Identifier: Apache-2.0
// What lies beneath instruments as a grid of cells along x and y: blood lies on it, heat goes into it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim_core/bleeding/pool.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Constant for an attempt. Heights in patient z: a supine patient's weight pulls along -z.
struct FieldBed {
    PoolModel pool;                    ///< ground: heights of the cells' middles
    Vector3 corner = Vector3::Zero();  ///< m, of the first cell (x and y)
    /// dz/dx and dz/dy by cell; empty: every cell is level.
    std::vector<std::array<double, 2>> slope;

    /// Cell under a place, the nearest one for a place outside the bed.
    int column(const Vector3& place) const {
        return static_cast<int>(
            std::clamp(std::floor((place.x() - corner.x()) / pool.cell), 0.0, pool.columns - 1.0));
    }
    int row(const Vector3& place) const {
        return static_cast<int>(
            std::clamp(std::floor((place.y() - corner.y()) / pool.cell), 0.0, pool.rows - 1.0));
    }
    std::size_t cell(const Vector3& place) const { return pool.index(column(place), row(place)); }
    /// m, of the bed under a place; outside the bed as at its rim.
    double ground(const Vector3& place) const {
        const int c = column(place), r = row(place);
        const std::size_t i = pool.index(c, r);
        if (slope.empty()) return pool.ground[i];
        const double half = 0.5 * pool.cell;
        return pool.ground[i] +
               slope[i][0] * std::clamp(place.x() - corner.x() - (c + 0.5) * pool.cell, -half, half) +
               slope[i][1] * std::clamp(place.y() - corner.y() - (r + 0.5) * pool.cell, -half, half);
    }
};

}  // namespace fulcrum
