// SPDX-License-Identifier: Apache-2.0
// A simple bowel for studies, validation cases and tests: the closed reference tube on its cage, and centre
// lines in closed form to bend it along.
#pragma once

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/lab/reference_tube.h"

namespace fulcrum::lab {

/// Tube bound to a cage of spheres `spacing` apart.
BowelSkin make_skin(double length, double mean_radius, double spacing, int sections, int around,
                    const TubeRadius& radius);

/// Frames of the rings on a circular arc of that radius from the origin, tangent +x there, curving towards
/// +y.
std::vector<RingFrame> bent_frames(const Cage& cage, double bend_radius);
/// Straight, a quarter circle of that radius in the middle, straight.
std::vector<RingFrame> quarter_bend_frames(const Cage& cage, double bend_radius);
/// Straight line, each frame turned about the tangent by `rate` rad per metre.
std::vector<RingFrame> twisted_frames(const Cage& cage, double rate);
std::vector<RingFrame> rest_frames(const Cage& cage);

}  // namespace fulcrum::lab
