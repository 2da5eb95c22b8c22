// SPDX-License-Identifier: Apache-2.0
// Local dents, which the rod cannot represent. Each vertex under a filtered force sinks into a Winkler bed of
// the wall, u_i = C_ii F_i, C_ii = 1 / (k A_i), with first-order relaxation (docs/THEORY.md, section 4).
#pragma once

#include <array>

#include "sim_core/bowel/force_filter.h"
#include "sim_core/bowel/skin.h"

namespace fulcrum {

/// Bed of springs under the wall.
struct WinklerBed {
    double stiffness_per_area = 0.0;  ///< k, N/m3
    double time_constant = 0.08;      ///< s, > 0
    /// m: the bed stiffens as a dent approaches this depth, u = t / sqrt(1 + (t / most_depth)^2) with t = C F
    /// (0.5 % at a tenth of the depth). Without this limit a pointed contact would pierce the opposite wall.
    double most_depth = 0.010;
};

/// Wall (constrained modulus over thickness) and backing (contents, opposite wall, fat) in series.
/// young Pa, 0 <= poisson < 0.5, wall_thickness m, backing N/m3 (> 0; infinity: rigid).
WinklerBed winkler_bed(double young, double poisson, double wall_thickness, double backing,
                       double time_constant);

inline constexpr int dent_capacity = 256;  ///< vertices dented at once: both tools and relaxing dents

/// State: copyable, hashed as `count` entries, in ascending order of vertex.
struct DentState {
    std::int32_t count = 0;
    bool overflow = false;  ///< a dent was dropped: dent_capacity is too small
    std::array<DentVertex, dent_capacity> entries{};
};

/// A filtered force on the surface.
struct SurfaceLoad {
    const FilteredForce* filtered = nullptr;
    const std::int32_t* vertex_of = nullptr;  ///< patch vertex -> surface vertex; null: the same
    Vector3 force = Vector3::Zero();          ///< F0, N, on the tissue
    /// N/m, stiffness of the contact that produced the force: the dent is scaled to have this slope. 0: the
    /// stiffness of the bed itself.
    double stiffness = 0.0;
};

/// One step: u += (1 - exp(-dt / tau)) (u(C F) - u) for all loaded and still dented vertices. vertex_areas:
/// m2, of the surface.
void step_dents(const WinklerBed& bed, const double* vertex_areas, const SurfaceLoad* loads, int load_count,
                double dt, DentState& state);

/// Contact stiffness of the bed, N/m: F0 over the displacement that does the same work, sum of w_i u_i.
double contact_stiffness(const WinklerBed& bed, const double* vertex_areas, const FilteredForce& filtered,
                         const std::int32_t* vertex_of = nullptr);

/// Displacement of a vertex, zero if not dented (binary search).
Vector3 dent_at(const DentState& state, std::int32_t vertex);

}  // namespace fulcrum
