// SPDX-License-Identifier: Apache-2.0
// Branching vessels on a periodic tile, drawn as a field from 0 (none) to 1 (middle of a vessel).
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/numerics/random.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Lengths are fractions of the tile's width.
struct VesselGrowth {
    int trees = 10;               ///< started at random places
    double trunk_radius = 0.005;  ///< shrinks by Murray's law at each fork
    double reach = 0.4;           ///< length of a trunk
    Eigen::Vector2d along{1, 0};  ///< axis that trunks follow, in either direction
    std::uint64_t seed = 1;
};

class VesselField {
  public:
    VesselField(int width, int height);
    void grow(const VesselGrowth& growth);
    double at(int i, int j) const {
        return values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(i)];
    }

  private:
    struct Branch {
        Eigen::Vector2d place, direction;  // pixels
        double radius, length;             // pixels
        int generation;
    };
    void stroke(const Eigen::Vector2d& centre, double radius);
    int width_, height_;
    std::vector<float> values_;
};

}  // namespace fulcrum
