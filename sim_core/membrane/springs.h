// SPDX-License-Identifier: Apache-2.0
// Springs of a membrane, derived from its triangle mesh (docs/THEORY.md 3).
//
// structural: every mesh edge. shear: the two vertices opposite a common edge of two triangles. bend: every
// vertex with the one two edges further on, where the way there is straight to within 40 degrees at rest. A
// pair of vertices gets one spring, of the first kind that names it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"

namespace fulcrum {

enum class SpringKind : std::uint8_t { structural, shear, bend };

/// Energy 1/2 stiffness (|x_first - x_second| - rest_length)^2.
struct MembraneSpring {
    std::int32_t first = 0, second = 0;  ///< vertices, first < second
    double rest_length = 0;              ///< m
    double stiffness = 0;                ///< N/m
    SpringKind kind = SpringKind::structural;
    /// Vertices between the two: shear has one or two (the common edges' ends), bend one; -1 where none. The
    /// squared distance of the pair is bounded by those along the way, which is what keeps the bounding
    /// matrix as sparse as the mesh.
    std::array<std::int32_t, 2> between = {-1, -1};
};

/// What a membrane is made of. Defaults: mesentery, provisional.
struct MembraneMaterial {
    double structural_stiffness = 40;  ///< N/m each, 0 or more, up to 1e12
    double shear_stiffness = 20;       ///< N/m each
    double bend_stiffness = 2;         ///< N/m each
    double mass = 0.05;                ///< kg, all of it, above 0; shared out by triangle area
    double pre_strain = 0;             ///< -0.5 .. 1: springs are stretched by this share in the given shape
    double stiffness_damping = 0;      ///< s, 0 or more: each spring damps with this times its stiffness
    double mass_damping = 0;           ///< 1/s, 0 or more: force -c m v
    std::vector<double> zones;  ///< empty, or by triangle, above 0: a spring has its stiffness times the mean
                                ///< of the triangles it spans
};

/// Springs of a mesh, in a fixed order. Throws InputError where a triangle names a vertex twice or one that
/// is not there, or a position is not finite.
std::vector<MembraneSpring> derive_springs(const TriangleMesh& mesh, const MembraneMaterial& material);

/// Lumped masses, kg: a third of each triangle's area; a vertex with (nearly) no area gets 1 % of the mean,
/// so that slivers and coincident vertices stay solvable. They add up to `mass`.
std::vector<double> lumped_masses(const TriangleMesh& mesh, double mass);

}  // namespace fulcrum
