// SPDX-License-Identifier: Apache-2.0
// Cavities simple enough for tests: a bumpy closed bowl, and a flat floor.
#pragma once

#include "sim_core/geometry/mesh.h"

namespace fulcrum::test {

/// Closed, outward oriented ellipsoid about the origin with bumps of relative height `bump`; 2 sectors (rings
/// - 1) triangles.
TriangleMesh make_bowl(const Vector3& half_axes, int rings, int sectors, double bump);

/// Square floor at z = 0, normals up, `cells` by `cells` squares of two triangles, centred on the origin.
TriangleMesh make_floor(double side, int cells);

/// Centre line of a bowel coiled inside make_bowl(0.06 0.055 0.05): `count` centres `spacing` apart along a
/// wound helix, some of them in the wall. phase moves it along, m.
std::vector<Vector3> coiled_centres(int count, double spacing, double phase);

}  // namespace fulcrum::test
