// SPDX-License-Identifier: Apache-2.0
// A bowel in closed form for studies, workloads and tests: the straight rest tube along +x from the origin.
#pragma once

#include <functional>

#include "sim_core/geometry/mesh.h"

namespace fulcrum::lab {

/// Radius at (x, angle from +y towards +z), m.
using TubeRadius = std::function<double(double, double)>;

/// Closed tube from x = 0 to length: sections + 1 circles of `around` vertices, then the two cap centres.
TriangleMesh make_tube(double length, int sections, int around, const TubeRadius& radius);

/// Haustra (bulges every 30 mm) and three shallow taeniae on a mean radius.
TubeRadius haustral_radius(double mean);
TubeRadius plain_radius(double radius);

}  // namespace fulcrum::lab
