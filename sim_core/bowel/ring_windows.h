// SPDX-License-Identifier: Apache-2.0
// Local scope of mean value coordinates: windows of 2k+1 rings, closed by caps whose centres are the means of
// their rings, and blended from ring to ring so that the surface has no tears or creases (docs/THEORY.md,
// section 1.4).
#pragma once

#include <vector>

#include "sim_core/bowel/mean_value.h"

namespace fulcrum {

/// Weights of the ring vertices of rings first .. first + rings - 1, ring by ring.
struct WindowWeights {
    int first = 0;
    int rings = 0;
    std::vector<double> weight;  ///< rings * vertices_per_ring
};

/// A tube of rings in the rest pose: vertex k of ring r is vertices[r * vertices_per_ring + k]. Not thread
/// safe: owns scratch.
class RingWindows {
  public:
    /// neighbours: k, number of rings on each side of a window's centre ring. At least 2 rings of at least 3
    /// vertices, counterclockwise about the direction in which the rings follow each other.
    RingWindows(std::vector<Vector3> vertices, int vertices_per_ring, int neighbours);

    int rings() const { return rings_; }
    int vertices_per_ring() const { return per_ring_; }

    /// Gap (ring j to j + 1) of the point: 0 .. rings - 2; beyond the ends the outermost gap.
    int gap_of(const Vector3& point) const;
    /// Position of the point between the planes of rings gap and gap + 1: 0 at the first, 1 at the second.
    double fraction(int gap, const Vector3& point) const;

    /// Blended weights of a point in that gap. Sum 1, linear reproduction.
    void weights(int gap, const Vector3& point, WindowWeights& result);
    /// Weights with the whole tube as one closed cage: rings() * vertices_per_ring().
    void global_weights(const Vector3& point, WindowWeights& result);

  private:
    void window_weights(int first, int count, const Vector3& point);

    int rings_ = 0, per_ring_ = 0, neighbours_ = 0;
    std::vector<Vector3> vertices_;
    std::vector<Vector3> centres_, normals_;  // of the rings' planes
    std::vector<Vector3> cage_;               // vertices of the current window, cap centres last
    CageTopology window_, global_;
    std::vector<double> cage_weights_;
    MeanValueScratch scratch_;
};

}  // namespace fulcrum
