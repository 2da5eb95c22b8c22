// SPDX-License-Identifier: Apache-2.0
// Response of a tube's cross-section under EXP2 to combined stretch and bending (docs/THEORY.md,
// section 1.1): energy per rest length w(e, k) = integral of W(e + k y) over the wall, by quadrature over 16
// angles and Gauss points in the squared radius (48 points for a plain wall, 16 per layer for a layered one),
// not by a scaled EI.
//
// With x = k^2 every term is smooth in x, including at k = 0: two points at +-y give
//     W(e + k y) + W(e - k y) = E0/a (exp(a (e^2 + x y^2)) cosh(2 a e y k) - 1),
// and w is given in two parts, axial w(e, 0) and bending w(e, k) - w(e, 0), each with its derivatives to
// second order. Twist is linear, G0 J. SI units; constant after construction; the responses do not allocate.
#pragma once

#include <vector>

#include "sim_core/material/layered_wall.h"
#include "sim_core/numerics/lanes.h"

namespace fulcrum {

struct AxialResponse {
    double energy = 0;   ///< J/m
    double force = 0;    ///< N
    double tangent = 0;  ///< N, > 0
};

/// w(e, k) - w(e, 0) and its derivatives with respect to strain e and to x = k^2.
struct BendingResponse {
    double energy = 0;            ///< J/m
    double by_strain = 0;         ///< N
    double by_square = 0;         ///< N m2, half the bending stiffness
    double by_strain_strain = 0;  ///< N
    double by_strain_square = 0;  ///< N m2
    double by_square_square = 0;  ///< N m4
};

class TubeSection {
  public:
    /// layers from inside to outside, at rest; the outermost ends at outer_radius m.
    /// Throws std::invalid_argument as tube_stiffness does.
    TubeSection(const std::vector<WallLayer>& layers, double outer_radius);

    int points() const { return points_; }  ///< number of quadrature points
    AxialResponse axial(double strain) const;
    /// square: squared curvature, 1/m2; negative values count as 0.
    BendingResponse bending(double strain, double square) const;

  private:
    struct Ring {       // one radius of one layer
        Lanes height2;  // y^2 of four angles, m2
        double area;    // m2, of two of its points
        double young, exponent;
    };
    struct Layer {
        double area, young, exponent;
    };
    std::vector<Ring> rings_;
    std::vector<Layer> layers_;
    int points_ = 0;
};

}  // namespace fulcrum
