// SPDX-License-Identifier: Apache-2.0
// A cavity in closed form for workloads: a bumpy ellipsoid without poles, and a chain of spheres inside it.
#pragma once

#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum::lab {

/// Icosahedron split `level` times (20 * 4^level triangles) onto an ellipsoid about the origin, with bumps of
/// that relative height; closed, outward.
TriangleMesh make_bowl(const Vector3& half_axes, int level, double bump);

/// `count` centres `spacing` apart on a helix about x along the bowl's wall; phase shifts it along, m.
std::vector<Vector3> coil(int count, double spacing, double radius, double width, double phase);

}  // namespace fulcrum::lab
