// SPDX-License-Identifier: Apache-2.0
// A bowel simple enough for tests: a closed tube along +x with haustra, and centre lines in closed form to
// bend it along.
#pragma once

#include <functional>

#include "sim_core/bowel/bowel_skin.h"

namespace fulcrum::test {

/// Radius at (x, angle from +y towards +z), m.
using TubeRadius = std::function<double(double, double)>;

/// Closed tube from x = 0 to length: sections + 1 circles of `around` vertices, then the two cap centres.
TriangleMesh make_tube(double length, int sections, int around, const TubeRadius& radius);

/// Haustra (bulges every 30 mm) and three shallow taeniae on a mean radius.
TubeRadius haustral_radius(double mean);
TubeRadius plain_radius(double radius);

/// Tube bound to a cage of spheres `spacing` apart.
BowelSkin make_skin(double length, double mean_radius, double spacing, int sections, int around,
                    const TubeRadius& radius);

/// Frames of the rings on a circular arc of that radius from the origin, tangent +x there, curving towards
/// +y.
std::vector<RingFrame> bent_frames(const Cage& cage, double bend_radius);
/// Straight line, each frame turned about the tangent by `rate` rad per metre.
std::vector<RingFrame> twisted_frames(const Cage& cage, double rate);
std::vector<RingFrame> rest_frames(const Cage& cage);

}  // namespace fulcrum::test
