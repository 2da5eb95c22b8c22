// SPDX-License-Identifier: Apache-2.0
// Springs of a membrane, derived from its triangle mesh (docs/THEORY.md, section 3).
//
// structural: every mesh edge. shear: the two vertices opposite a common edge of two triangles. bend: every
// vertex with the one two edges further on, if that path is straight to within 40 degrees at rest. A pair of
// vertices gets one spring, of the first kind that applies.
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
    /// Vertices between the two: shear has one or two (the ends of the common edges), bend one; -1: none. The
    /// squared distance of the pair is bounded by the distances along this path, which keeps the bounding
    /// matrix as sparse as the mesh.
    std::array<std::int32_t, 2> between = {-1, -1};
};

/// Material of a membrane. Defaults: mesentery, provisional.
struct MembraneMaterial {
    double structural_stiffness = 40;  ///< N/m each, 0 or more, up to 1e12
    double shear_stiffness = 20;       ///< N/m each
    double bend_stiffness = 2;         ///< N/m each
    double mass = 0.05;                ///< kg in total, above 0; distributed by triangle area
    double pre_strain = 0;             ///< -0.5 .. 1: strain of the springs in the given shape
    double stiffness_damping = 0;      ///< s, 0 or more: damping of each spring is this times its stiffness
    double mass_damping = 0;           ///< 1/s, 0 or more: force -c m v
    std::vector<double> zones;  ///< empty, or by triangle, above 0: a spring has its stiffness times the mean
                                ///< of the triangles it spans
};

/// Springs of a mesh, in a fixed order. Throws InputError if a triangle uses a vertex twice or one that does
/// not exist, or a position is not finite.
std::vector<MembraneSpring> derive_springs(const TriangleMesh& mesh, const MembraneMaterial& material);

/// Lumped masses, kg: a third of each triangle's area; a vertex with (nearly) no area gets 1 % of the mean,
/// so that slivers and coincident vertices stay solvable. The sum is `mass`.
std::vector<double> lumped_masses(const TriangleMesh& mesh, double mass);

}  // namespace fulcrum
