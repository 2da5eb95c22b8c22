// SPDX-License-Identifier: Apache-2.0
// The dynamic point of Maciel and De (2008), on a segment: it walks from the last triangle through adjacency
// to the point of the surface that the shaft is nearest to, or deepest below.
//
// The point q of the surface that belongs to a point x of the shaft is the one whose smooth normal passes
// through x: x = q + phi n(q), n the interpolated vertex normals. It is a god-object without friction: it
// stays on the side from which it came, and because n is continuous over the mesh so are q and the signed
// distance phi (a closest point would jump between facets below the surface). Along the shaft phi is lowest
// where n is perpendicular to it, or at the tip.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct WalkOptions {
    int iterations = 12;              ///< steps across triangles and along the shaft in one tick
    double tolerance = 1e-7;          ///< m, motion of the point at which the walk ends
    double curvature_radius = 0.016;  ///< m, of the surface across the shaft: Newton's step along the shaft
    double longest_step = 0.004;      ///< m along the shaft in one iteration
};

/// Where the walk stands; copyable. Triangle numbers are the surface's own.
struct WalkPoint {
    std::int32_t triangle = -1;
    Vector3 barycentric = Vector3(1.0 / 3, 1.0 / 3, 1.0 / 3);
    double shaft = 1.0;                  ///< fraction of the segment, 0 .. 1
    Vector3 position = Vector3::Zero();  ///< q, m
    Vector3 normal = Vector3::Zero();    ///< n(q), unit, outward
    Vector3 on_shaft = Vector3::Zero();  ///< x, m
    double distance = 0;                 ///< phi, m, < 0 below the surface
    bool at_border = false;              ///< the walk wanted to leave the mesh: search again
    bool converged = false;
};

}  // namespace fulcrum
