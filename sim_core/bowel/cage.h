// SPDX-License-Identifier: Apache-2.0
// The cage: rings of eight vertices around the centre line, a sphere template at each sphere and a middle
// template halfway between two, joined into a closed tube with end caps (docs/THEORY.md, section 1.3; Pan et
// al. 2011, Fig. 8). Built in the extended rest pose: the tube lies along +x from the origin, d3 = +x, d1 =
// +y, d2 = +z.
#pragma once

#include <array>
#include <vector>

#include "sim_core/bowel/skin.h"
#include "sim_core/bowel/spheres.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

inline constexpr int ring_size = 8;  ///< vertices of a ring

/// Rings in the order of the line: sphere 0, middle, sphere 1, middle ... ring 2 i belongs to sphere i.
struct Cage {
    double length = 0.0;              ///< m, of the centre line at rest
    std::vector<double> arc_lengths;  ///< m, where each ring's frame is taken
    std::vector<std::array<Vector3, ring_size>>
        templates;           ///< X_rk, m, ring frame; counterclockwise about d3
    double clearance = 0.0;  ///< m, smallest distance between the surface and the cage at rest

    int rings() const { return static_cast<int>(arc_lengths.size()); }
};

struct CageOptions {
    double margin = 0.0008;  ///< m, the surface stays at least this far inside
};

/// Builds the cage around a closed surface in the rest pose: sphere and middle rings, pushed out to the
/// surface along the normals, then further until every vertex and every edge of the surface is inside by the
/// margin. Throws InputError if the surface is not a tube of that length along +x (open, inside out, or an
/// axis point outside it).
Cage build_cage(const TriangleMesh& surface, double length, const SphereChain& spheres,
                const CageOptions& options = {});

/// Frame of the rest line at arc length s.
RingFrame rest_frame(double s);

/// Cage vertices under the given frames, ring by ring, followed by the centres of the first and last cap
/// (means of their rings).
std::vector<Vector3> cage_vertices(const Cage& cage, const RingFrame* frames);
/// Triangles of a closed tube of that many rings, outward; indices as cage_vertices gives them.
std::vector<Triangle> cage_triangles(int rings, int vertices_per_ring = ring_size);

/// Sets one frame per ring from a callable RingFrame frame_at(double s): the rod's position and directors at
/// rest arc length s.
template <typename FrameAt>
void ring_frames(const Cage& cage, FrameAt&& frame_at, RingFrame* frames) {
    for (int r = 0; r < cage.rings(); ++r)
        frames[r] = frame_at(cage.arc_lengths[static_cast<std::size_t>(r)]);
}

}  // namespace fulcrum
