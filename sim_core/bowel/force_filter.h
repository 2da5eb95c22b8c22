// SPDX-License-Identifier: Apache-2.0
// The haptic force filter: contact area from the tip box (Eq. 4), grade from the area (Eq. 3), radial basis
// weights around the contact vertex (Eqs. 1-2), blended over the area so that the force is continuous
// (docs/THEORY.md, section 4). Works on any SurfaceView, whole or patch. No allocation, no exceptions: haptic
// and world threads.
#pragma once

#include <array>

#include "sim_core/bowel/filter_level.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// How the filter chooses its grade; `off` is grade 0 without evaluating the area.
enum class FilterMode : std::uint8_t { grade_0, grade_1, grade_2, adaptive };

/// Cuboid approximating an instrument's tip. edges: a along the shaft (axis 0), b, c, m. axes: unit columns
/// n1, n2, n3.
struct TipBox {
    Vector3 edges = Vector3(0.010, 0.005, 0.003);
    Matrix3 axes = Matrix3::Identity();
};

inline constexpr int filter_capacity = 96;  ///< vertices of two rings, at most

/// Weights of a filtered force: force on vertex[i] = weight[i] * F0, sum of weights 1.
struct FilteredForce {
    std::int32_t grade = 0;            ///< by Eq. 3, unblended
    double contact_area = 0.0;         ///< S, m2
    double local_triangle_area = 0.0;  ///< mean area of the triangles around the contact vertex, m2
    double sigma = 0.0;                ///< m, of the reported grade; 0 for grade 0
    std::int32_t count = 0;
    bool overflow = false;  ///< more than filter_capacity vertices in two rings: the later ones were dropped
    std::array<std::int32_t, filter_capacity> vertex{};
    std::array<double, filter_capacity> weight{};
};

struct FilterOptions {
    FilterMode mode = FilterMode::adaptive;
    double sigma = 0.0;  ///< m; 0: grade times the mean edge length at the contact vertex
};

/// Mode for a fidelity level. Without a filter the contact vertex carries the whole force, as with grade 0.
FilterMode filter_mode(FilterLevel level);

/// S = w1 S1 |n1.n0| + w2 S2 |n2.n0| + w3 S3 |n3.n0|, w = (0.5, 0.25, 0.25), S1 = bc, S2 = ac, S3 = ab (Eq.
/// 4), m2.
double contact_area(const TipBox& tip, const Vector3& normal);

/// 0 below the local triangle area, 1 up to four times it, 2 above (Eq. 3).
int filter_grade(double area, double local_triangle_area);

/// Weights around `vertex` for a contact of the given area. Reads only positions and adjacency near the
/// vertex.
void filter_force(const SurfaceView& surface, std::int32_t vertex, double area, const FilterOptions& options,
                  FilteredForce& result);

/// As above, with the area from the tip box and the normal at the vertex.
void filter_force(const SurfaceView& surface, std::int32_t vertex, const TipBox& tip,
                  const FilterOptions& options, FilteredForce& result);

}  // namespace fulcrum
