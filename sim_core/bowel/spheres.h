// SPDX-License-Identifier: Apache-2.0
// The sphere chain: the bowel's collision shape, rigidly attached to the centre line (docs/THEORY.md,
// section 1.2; Pan et al. 2011, Fig. 6). It is sampled along the line independently of the rod's nodes.
#pragma once

#include <functional>
#include <vector>

namespace fulcrum {

/// Arc lengths at rest, ascending from 0 to the length, and radii, m. One entry per sphere.
struct SphereChain {
    std::vector<double> arc_lengths;
    std::vector<double> radii;
};

/// Radius of the tube at a rest arc length, m.
using RadiusProfile = std::function<double(double)>;

/// Spheres about `spacing` apart, the first and last at the ends of the line; at least three. Radius = local
/// lumen radius.
SphereChain sample_spheres(double length, double spacing, const RadiusProfile& radius);

}  // namespace fulcrum
