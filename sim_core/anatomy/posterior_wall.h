// SPDX-License-Identifier: Apache-2.0
// The posterior wall of a cavity as heights over the coronal plane: the surface on which a supine patient's
// bowel rests.
#pragma once

#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

class PosteriorWall {
  public:
    /// Rasterises the triangles that face down (outward normal with z < 0).
    explicit PosteriorWall(const TriangleMesh& cavity, double cell = 0.002);

    /// Height of the wall, m; outside the covered area that of the nearest covered cell.
    double height(double x, double y) const;
    /// Lowest z at which the centre of a sphere of that radius does not touch the wall.
    double resting_height(double x, double y, double radius) const;

  private:
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
    }
    double cell_, x0_ = 0, y0_ = 0;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
};

}  // namespace fulcrum
