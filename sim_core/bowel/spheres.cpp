// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/spheres.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fulcrum {

SphereChain sample_spheres(double length, double spacing, const RadiusProfile& radius) {
    assert(length > 0.0 && spacing > 0.0);
    const int gaps = std::max(2, static_cast<int>(std::lround(length / spacing)));
    SphereChain chain;
    for (int i = 0; i <= gaps; ++i) {
        const double s = i == gaps ? length : length * i / gaps;
        chain.arc_lengths.push_back(s);
        chain.radii.push_back(radius(s));
    }
    return chain;
}

}  // namespace fulcrum
