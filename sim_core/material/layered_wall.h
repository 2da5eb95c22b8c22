// SPDX-License-Identifier: Apache-2.0
// Layered bowel wall (docs/THEORY.md, sections 1.1 and 4, "beyond"): composite stiffness of the tube for the
// rod, and the non-linear force-depth curve of an instrument pressed into the wall, with a nodule under soft
// mucosa and a puncture limit.
//
// Indentation: under a contact that is wide compared with the wall thickness no layer can bulge sideways. The
// layers then act in series under one pressure p, each with the constrained form of EXP2,
// p = m E0 e exp(a e^2) with m = (1 - nu) / ((1 + nu)(1 - 2 nu)) and e the compression over the thickness.
// What lies behind the wall (contents, opposite wall, fat) is one more spring of `backing` N/m3. A nodule of
// height h lies on the submucosa and replaces the same thickness of mucosa:
// depth(p, h) = depth(p, 0) + h (e_nodule(p) - e_mucosa(p)), exactly. Pressure and depth are tabulated once;
// a look-up is a bisection of the table and one cubic, without allocation and bit-reproducible. SI units.
// Model: constant after construction, readable from any thread.
#pragma once

#include <array>
#include <vector>

#include "sim_core/material/exp2.h"

namespace fulcrum {

/// One layer of the wall, from the lumen outwards.
struct WallLayer {
    double thickness = 0;   ///< m, > 0
    double young = 0;       ///< Pa, at rest, > 0
    double exponent = 3.0;  ///< a of EXP2, 0.01 .. 100; not used by the linear law
};

/// Mucosa, submucosa, muscularis, serosa. Submucosa and muscularis carry the load, the mucosa is soft (Siri
/// et al. 2020, Bioengineering 7:130, a review). The values are provisional ones of this project: 3 mm in
/// total, and a tube of 16 mm radius with the same tensile stiffness as one of 32.3 kPa within 1 %.
std::vector<WallLayer> bowel_wall_layers();

/// Stiffness at rest of a tube of concentric layers, about its axis.
struct TubeStiffness {
    double axial = 0;      ///< N, sum of E A
    double bending = 0;    ///< N m2, sum of E I
    double torsional = 0;  ///< N m2, sum of G J
};

/// layers from inside to outside; the outermost ends at outer_radius m. Their total thickness must not exceed
/// it.
TubeStiffness tube_stiffness(const std::vector<WallLayer>& layers, double outer_radius, double poisson);

/// A stiff lump under the mucosa: a dome of `height` at its centre that ends at `radius`.
struct WallNodule {
    double height = 0;      ///< m, 0: none; at most the thickness of the layer that it replaces
    double radius = 0;      ///< m, > 0 where height > 0
    double young = 300e3;   ///< Pa, at rest; provisional
    double exponent = 3.0;  ///< of EXP2
};

struct LayeredWallSpec {
    std::vector<WallLayer> layers = bowel_wall_layers();  ///< 1 .. 8, lumen first
    double poisson_ratio = 0.35;                          ///< 0 .. 0.49
    double backing = 2.5e7;  ///< N/m3, > 0; same meaning as for dents (bowel/dent.h)
    WallNodule nodule;
    int nodule_layer = 0;  ///< index of the layer that a nodule replaces (0: mucosa)
};

/// Response of the wall at a depth.
struct Indentation {
    double force = 0;        ///< N, against the instrument along the normal; never above puncture_force
    double stiffness = 0;    ///< N/m, d force / d depth, >= 0; 0 once punctured
    bool punctured = false;  ///< the force has reached the limit: the wall is perforated at this depth
};

class LayeredWall {
  public:
    /// Throws std::invalid_argument on values outside the ranges given above.
    explicit LayeredWall(const LayeredWallSpec& spec);

    double thickness() const { return thickness_; }  ///< m
    /// Height of the nodule under a point at `distance` m from its centre, along the wall; smooth, 0 beyond
    /// its radius.
    double nodule_height(double distance) const;

    /// Force of a contact of `area` m2 (Eq. 4) at `depth` m (negative: no contact) over `nodule_height` m of
    /// nodule. puncture_force N: the value drawn for the attempt from the published distribution (Heijnsdijk
    /// et al. 2003: 10.3 +- 2.9 N, human small bowel between hemispheres of 1.5 mm); infinity: no limit.
    Indentation indent(double depth, double area, double puncture_force, double nodule_height = 0) const;

    /// Pressure Pa and its slope Pa/m at a depth; indent() multiplies both by the area.
    void pressure_at(double depth, double nodule_height, double& pressure, double& slope) const;
    /// m, exact inverse by Newton's method in each layer; the table is made from it.
    double depth_at(double pressure, double nodule_height) const;

  private:
    static constexpr std::size_t points = 129;
    double strain(double young, double exponent, double pressure) const;

    LayeredWallSpec spec_;
    double thickness_ = 0, modulus_factor_ = 1;
    // Indexed by pressure: depth without a nodule, depth added per 1 m of nodule, and their slopes (1/Pa).
    std::array<double, points> pressure_{}, depth_{}, relief_{}, depth_slope_{}, relief_slope_{};
};

}  // namespace fulcrum
