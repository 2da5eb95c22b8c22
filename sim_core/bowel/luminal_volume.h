// SPDX-License-Identifier: Apache-2.0
// Contents of the lumen (beyond Pan et al. 2011): a fluid that fills the tube and cannot leave it. Its
// pressure is uniform and follows a change of volume by its bulk modulus; the wall responds to the pressure
// in hoop direction. Without this model a stretched tube keeps its cross-section and its volume grows with
// its length. SI units.
#pragma once

#include <vector>

#include "sim_core/bowel/cage.h"

namespace fulcrum {

struct LuminalSpec {
    double bulk_modulus = 0;        ///< Pa, of the contents; 0: none
    double young_modulus = 32.3e3;  ///< Pa, of the wall
    double wall_thickness = 0.003;  ///< m
};

/// Model (constant after construction) and the pressure found last.
class LuminalVolume {
  public:
    LuminalVolume(const Cage& cage, const LuminalSpec& spec);

    /// The uniform pressure (Pa above rest) at which the volumes of contents and tube agree; stretch: one per
    /// ring, length over rest length. Newton's method, at most 60 iterations; does not allocate.
    double solve(const double* stretch);
    /// Radial scale of a ring under the pressure found last, 0.2 .. 3.
    double scale(int ring) const;
    /// Volume of the tube over its volume at rest under scale() of every ring.
    double volume_ratio(const double* stretch) const;
    double pressure() const { return pressure_; }
    /// All that changes.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(pressure_);
    }

  private:
    double scale_at(std::size_t ring, double pressure) const;
    double ratio_at(const double* stretch, double pressure) const;

    LuminalSpec spec_;
    std::vector<double> volume_;      ///< m3 at rest, of each ring's share of the tube
    std::vector<double> compliance_;  ///< 1/Pa, hoop strain per pressure: R / (E h)
    double total_ = 0, pressure_ = 0;
};

}  // namespace fulcrum
