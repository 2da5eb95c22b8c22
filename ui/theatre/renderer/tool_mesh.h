// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of instruments and targets in their own frames: z along the shaft, the jaws' hinge or the sphere's
// centre at the origin. Lengths in m unless said otherwise.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum::ui {

/// Position, normal, texture coordinates: eight floats a vertex.
struct RigidMesh {
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
};

/// Open cylinder of radius 1 from z = 0 to z = 1; u around, v along.
RigidMesh make_shaft();
/// Clevis that carries the jaws: from z = -1 (shaft) to z = 0.35 in units of the shaft's radius.
RigidMesh make_clevis();
/// One jaw, length 1 along +z from the hinge, closing towards -y; its half width is 0.11. Toothed below,
/// fenestrated in look by a groove above.
RigidMesh make_jaw();
/// One scissors' blade, laid out like a jaw: slim, pointed, smooth, a little bent sideways.
RigidMesh make_blade();
/// A bar of length 1 along +z, laid out like a jaw: round, tapering.
RigidMesh make_rod();
/// Open tube: radius 1, z from -4 to 0, one looks a little way into it.
RigidMesh make_tube_end();
/// Rod with a round end: radius 1, z from -4 to 0.
RigidMesh make_probe_end();
/// L-hook of a rod, in units of the shaft's radius: comes along the axis, dips to -y and ends in its tip at
/// the origin.
RigidMesh make_hook();
/// Sphere of radius 1.
RigidMesh make_sphere();
/// Inside of a box from (0, 0, 0) to size; coordinates in m.
RigidMesh make_box(float width, float depth, float height);

/// What lies between the round image and its square, over clip space.
RigidMesh make_frame_mask();

}  // namespace fulcrum::ui
